/* SPDX-License-Identifier: MIT */
/* Models exchanged under a ringing drum: no parametric pump. */
#include "physics.h"

static TaborDrumDef two_heads(void) {
  TaborDrumDef def = physics_preset("frame-drum");
  def.two_headed = 1;
  def.shell.depth = 0.1;
  def.quality.losses = 0;
  def.quality.two_way_bandwidth = 3000.0;
  for (uint32_t i = 0; i < def.mic_count; i++) def.mic[i].height = 0.1 + 0.1 * i;
  return def;
}

static double stored(const TaborDrum *drum) {
  TaborLedger ledger;
  tabor_drum_ledger(drum, &ledger);
  return ledger.stored;
}

enum { TOGGLES = 750, TOGGLE = 64, CROSSING = 12 * TOGGLE }; /* 16 ms, as the engine has it */

/* Returns the swap, which is done once the former model has faded. */
static TaborSwap *exchange(TaborDrum *drum, TaborModel *from, TaborModel *to) {
  TaborSwap *swap;
  TaborError error;
  assert_int_equal(tabor_swap_create(from, to, &swap, &error), TABOR_OK);
  const TaborEvent event = {.type = TABOR_EVENT_SWAP, .swap = swap};
  tabor_drum_process(drum, &event, 1, NULL, TOGGLE);
  assert_false(tabor_swap_done(swap));
  return swap;
}

/* Phase and action are kept per mode, so the energy follows the frequencies: it swings by sqrt(1.1)
 * at most and comes back, but for the modes that only one of the models keeps. Carrying
 * displacements over multiplied it by 2e9 in this second. */
static void a_tension_toggled_by_ten_per_cent_pumps_no_energy(void **state) {
  (void)state;
  for (int head = 0; head < 2; head++) {
    TaborDrumDef def = two_heads(), tense = def;
    (head ? &tense.resonant : &tense.batter)->tension *= 1.1;
    TaborModel *models[2] = {physics_model(&def, 48000.0, TABOR_QUALITY_LIVE),
                             physics_model(&tense, 48000.0, TABOR_QUALITY_LIVE)};
    TaborDrum *drum = physics_drum(models[0]);
    const TaborEvent strike = physics_strike(&def);
    tabor_drum_process(drum, &strike, 1, NULL, 4800); /* the stick is gone by then */
    const double start = stored(drum);
    double most = start;
    TaborSwap *swaps[TOGGLES];
    for (int toggle = 0; toggle < TOGGLES; toggle++) {
      swaps[toggle] = exchange(drum, models[toggle % 2], models[1 - toggle % 2]);
      most = fmax(most, stored(drum));
    }
    print_message("%s: energy rises to %.4f of its start at most, ends at %.6f\n",
                  head ? "resonant" : "batter", most / start, stored(drum) / start);
    assert_true(most < sqrt(1.1) * start * (1.0 + 1e-9));
    assert_true(fabs(stored(drum) / start - 1.0) < 1e-4);
    TaborLedger ledger;
    tabor_drum_ledger(drum, &ledger);
    assert_true(fabs(ledger.residual) < 1e-9 * (ledger.injected + fabs(ledger.control)));
    tabor_drum_process(drum, NULL, 0, NULL, CROSSING);
    for (int toggle = 0; toggle < TOGGLES; toggle++) {
      assert_true(tabor_swap_done(swaps[toggle]));
      tabor_swap_destroy(swaps[toggle]);
    }
    tabor_drum_destroy(drum);
    for (int i = 0; i < 2; i++) tabor_model_release(models[i]);
  }
}

/* Studio steps twice per sample at 48 kHz, live once: place, velocity and energy of the modes go
 * on, there and back. What little changes is the wood's last contact and rounding. */
static void steps_half_as_long_keep_the_motion(void **state) {
  (void)state;
  const TaborDrumDef def = two_heads();
  TaborModel *models[2] = {physics_model(&def, 48000.0, TABOR_QUALITY_LIVE),
                           physics_model(&def, 48000.0, TABOR_QUALITY_STUDIO)};
  TaborDrum *drum = physics_drum(models[0]), *same = physics_drum(models[0]);
  const TaborEvent strike = physics_strike(&def);
  tabor_drum_process(drum, &strike, 1, NULL, 4800);
  tabor_drum_process(same, &strike, 1, NULL, 4800);
  const double start = stored(drum);
  TaborSwap *swaps[2];
  double most = 0.0, worst = 0.0;
  for (int i = 0; i < 2; i++) {
    swaps[i] = exchange(drum, models[i], models[1 - i]);
    tabor_drum_process(same, NULL, 0, NULL, TOGGLE);
    print_message("energy %.9f of its start\n", stored(drum) / start);
    assert_true(fabs(stored(drum) / start - 1.0) < 1e-6);
    for (int frame = 0; frame < CROSSING; frame++) {
      TaborProbe probe, expected;
      tabor_drum_process(drum, NULL, 0, NULL, 1);
      tabor_drum_process(same, NULL, 0, NULL, 1);
      tabor_drum_probe(drum, &probe);
      tabor_drum_probe(same, &expected);
      most = fmax(most, fabs(expected.head));
      worst = fmax(worst, fabs(probe.head - expected.head));
    }
  }
  print_message("the head moves %.2g m, differs by %.1e m\n", most, worst);
  assert_true(worst < 1e-2 * most);
  for (int i = 0; i < 2; i++) {
    assert_true(tabor_swap_done(swaps[i]));
    tabor_swap_destroy(swaps[i]);
  }
  tabor_drum_destroy(same);
  tabor_drum_destroy(drum);
  for (int i = 0; i < 2; i++) tabor_model_release(models[i]);
}

/* Made for another model, it cannot act: the drum stays as it is, and the swap may be freed. */
/* Modes count their angles from the drum's own stroke: with another one a head keeps its motion,
 * whose copies turn. Off the centre and beside the stroke all copies move. */
static void another_own_stroke_keeps_the_motion(void **state) {
  (void)state;
  TaborDrumDef def = two_heads(), other;
  def.two_headed = 0;
  def.quality.losses = 1;
  other = def;
  other.strike.angle = def.strike.angle + 50.0;
  TaborModel *models[2] = {physics_model(&def, 48000.0, TABOR_QUALITY_STUDIO),
                           physics_model(&other, 48000.0, TABOR_QUALITY_STUDIO)};
  TaborDrum *drum = physics_drum(models[0]), *same = physics_drum(models[0]);
  TaborEvent strike = physics_strike(&def);
  strike.radius = 0.6 * def.shell.radius;
  strike.angle = def.strike.angle + 20.0;
  for (int i = 0; i < 2; i++) tabor_drum_process(i ? same : drum, &strike, 1, NULL, 4800);
  TaborSwap *swap = exchange(drum, models[0], models[1]);
  tabor_drum_process(same, NULL, 0, NULL, TOGGLE);
  const double energy = stored(same), away = fabs(stored(drum) / energy - 1.0);
  /* The same stroke there anew tells where the head is: its stick meets the same motion. */
  TaborProbe probe, expected;
  double most = 0.0, worst = 0.0;
  TaborEvent again = strike;
  again.radius = 0.3 * def.shell.radius;
  again.angle = def.strike.angle + 130.0;
  tabor_drum_process(drum, &again, 1, NULL, 1);
  tabor_drum_process(same, &again, 1, NULL, 1);
  for (int frame = 0; frame < 480; frame++) {
    tabor_drum_process(drum, NULL, 0, NULL, 1);
    tabor_drum_process(same, NULL, 0, NULL, 1);
    tabor_drum_probe(drum, &probe);
    tabor_drum_probe(same, &expected);
    most = fmax(most, fabs(expected.striker_force));
    worst = fmax(worst, fabs(probe.striker_force - expected.striker_force));
  }
  print_message("energy %.1e away; the stick's force of %.2g N differs by %.1e N\n", away, most,
                worst);
  assert_true(away < 1e-9 && most > 1.0 && worst < 1e-6 * most);
  tabor_drum_process(drum, NULL, 0, NULL, CROSSING);
  assert_true(tabor_swap_done(swap));
  tabor_swap_destroy(swap);
  tabor_drum_destroy(same);
  tabor_drum_destroy(drum);
  for (int i = 0; i < 2; i++) tabor_model_release(models[i]);
}

static void a_swap_for_another_model_is_dropped_and_done(void **state) {
  (void)state;
  const TaborDrumDef def = physics_preset("frame-drum");
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT),
             *other = physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT);
  TaborDrum *drum = physics_drum(model);
  TaborSwap *swap;
  TaborError error;
  assert_int_equal(tabor_swap_create(other, model, &swap, &error), TABOR_OK);
  assert_false(tabor_swap_done(swap));
  const TaborEvent event = {.type = TABOR_EVENT_SWAP, .swap = swap};
  tabor_drum_process(drum, &event, 1, NULL, 64);
  TaborStatistics statistics;
  tabor_drum_statistics(drum, &statistics);
  assert_int_equal(statistics.dropped_events, 1);
  assert_ptr_equal(tabor_drum_model(drum), model);
  assert_true(tabor_swap_done(swap));
  tabor_swap_destroy(swap);
  tabor_drum_destroy(drum);
  tabor_model_release(other);
  tabor_model_release(model);
}

/* ---- drums that do not continue each other --------------------------------------------------- */

enum { FADE = 1440 }; /* 30 ms, as the engine has it */

/* The frame drum's microphones, top, bottom and far, as far, top and close. */
static TaborDrumDef other_drum(void) {
  TaborDrumDef def = physics_preset("frame-drum");
  def.shell.radius *= 0.8;
  const TaborMicDef far = def.mic[2];
  def.mic[2] = def.mic[1];
  def.mic[1] = def.mic[0];
  def.mic[0] = far;
  (void)snprintf(def.mic[2].name, sizeof def.mic[2].name, "close");
  return def;
}

static void play(TaborDrum *drum, const TaborEvent *event, uint32_t frames,
                 float sound[3][2 * FADE]) {
  float *outputs[TABOR_MAX_MICS] = {sound[0], sound[1], sound[2]};
  tabor_drum_process(drum, event, event ? 1 : 0, outputs, frames);
}

/* What was at full level @p ago frames before, and has faded since. */
static double faded(const float *sound, uint32_t i, uint32_t ago) {
  const uint32_t gone = i + ago;
  return gone < FADE ? (FADE - gone) / (FADE + 1.0) * (double)sound[i] : 0;
}

static const double ROUNDING =
  2e-7; /* of single precision, to which samples are rounded here and there */

static void assert_sum(double value, double a, double b) {
  const double sum = a + b, tolerance = ROUNDING * (fabs(a) + fabs(b));
  if (fabs(value - sum) > tolerance) fail_msg("%.9g, not %.9g + %.9g", value, a, b);
}

/* One drum rings out into the names of the next; a third comes during the fade and cuts neither. */
static void old_drums_ring_out_by_name(void **state) {
  (void)state;
  enum { SECOND = 500 };
  const TaborDrumDef first = physics_preset("frame-drum"), second = other_drum();
  TaborDrumDef third = first;
  third.shell.radius *= 0.9;
  TaborModel *models[] = {physics_model(&first, 48000.0, TABOR_QUALITY_DRAFT),
                          physics_model(&second, 48000.0, TABOR_QUALITY_DRAFT),
                          physics_model(&third, 48000.0, TABOR_QUALITY_DRAFT)};
  TaborDrum *drum = physics_drum(models[0]), *first_alone = physics_drum(models[0]),
            *second_alone = physics_drum(models[1]);
  static float sound[3][2 * FADE], one[3][2 * FADE], two[3][2 * FADE];
  const TaborEvent strike = physics_strike(&first);
  TaborSwap *swaps[2];
  for (int i = 0; i < 2; i++) {
    assert_int_equal(tabor_swap_create(models[i], models[i + 1], &swaps[i], NULL), TABOR_OK);
  }
  play(drum, &strike, 2000, sound);
  play(first_alone, &strike, 2000, one);
  const TaborEvent events[] = {{.type = TABOR_EVENT_SWAP, .swap = swaps[0]}, strike};
  tabor_drum_process(drum, events, 2, NULL, 0);
  play(drum, NULL, SECOND, sound);
  play(first_alone, NULL, SECOND, one);
  play(second_alone, &strike, SECOND, two);
  double loudest = 0;
  for (uint32_t i = 0; i < SECOND; i++) {
    assert_sum(sound[0][i], faded(one[2], i, 0), (double)two[0][i]); /* far */
    assert_sum(sound[1][i], faded(one[0], i, 0), (double)two[1][i]); /* top */
    assert_sum(sound[2][i], 0, (double)two[2][i]); /* the first has no close one */
    loudest = fmax(loudest, fabs(faded(one[0], i, 0)));
  }
  assert_true(loudest > 1e-3);
  const TaborEvent again = {.type = TABOR_EVENT_SWAP, .swap = swaps[1]};
  tabor_drum_process(drum, &again, 1, NULL, 0);
  play(drum, NULL, 2 * FADE, sound);
  play(first_alone, NULL, 2 * FADE, one);
  play(second_alone, NULL, 2 * FADE, two);
  for (uint32_t i = 0; i < 2 * FADE; i++) {
    assert_sum(sound[0][i], faded(one[0], i, SECOND), faded(two[1], i, 0)); /* top */
    assert_true(sound[1][i] == 0); /* bottom: the second has none, and so lost the first one's */
    assert_sum(sound[2][i], faded(one[2], i, SECOND), faded(two[0], i, 0)); /* far */
  }
  assert_true(tabor_drum_is_silent(drum));
  for (int i = 0; i < 2; i++) {
    assert_true(tabor_swap_done(swaps[i]));
    tabor_swap_destroy(swaps[i]);
  }
  TaborDrum *drums[] = {drum, first_alone, second_alone};
  for (int i = 0; i < 3; i++) {
    tabor_drum_destroy(drums[i]);
    tabor_model_release(models[i]);
  }
}

/* However many come at once, the work is bounded, and the oldest fades are cut, not lost. */
static void the_oldest_of_many_fades_ends(void **state) {
  (void)state;
  enum { CHANGES = 6, MOST = 4 };
  TaborModel *models[CHANGES + 1];
  TaborSwap *swaps[CHANGES];
  for (int i = 0; i <= CHANGES; i++) {
    TaborDrumDef def = physics_preset("frame-drum");
    def.shell.radius -= 0.005 * i;
    models[i] = physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT);
  }
  const TaborDrumDef def = physics_preset("frame-drum");
  const TaborEvent strike = physics_strike(&def);
  TaborDrum *drum = physics_drum(models[0]);
  for (int i = 0; i < CHANGES; i++) {
    assert_int_equal(tabor_swap_create(models[i], models[i + 1], &swaps[i], NULL), TABOR_OK);
    const TaborEvent swap = {.type = TABOR_EVENT_SWAP, .swap = swaps[i]};
    tabor_drum_process(drum, &strike, 1, NULL, 50);
    tabor_drum_process(drum, &swap, 1, NULL, 50);
    for (int j = 0; j <= i; j++) assert_int_equal(tabor_swap_done(swaps[j]), i - j >= MOST);
  }
  tabor_drum_reset(drum);
  assert_true(tabor_drum_is_silent(drum));
  for (int i = 0; i < CHANGES; i++) {
    assert_true(tabor_swap_done(swaps[i]));
    tabor_swap_destroy(swaps[i]);
  }
  tabor_drum_destroy(drum);
  for (int i = 0; i <= CHANGES; i++) tabor_model_release(models[i]);
}

/* ---- the same drum on another model ---------------------------------------------------------- */

/* 8 ms of the former model alone, struck as the new one is, then 8 ms from one to the other. */
static void the_former_model_gives_way_to_the_new_one(void **state) {
  (void)state;
  enum { HOLD = 384, CROSS = 384 };
  const TaborDrumDef def = physics_preset("frame-drum");
  TaborDrumDef tense = def;
  tense.batter.tension *= 1.1;
  TaborModel *models[] = {physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT),
                          physics_model(&tense, 48000.0, TABOR_QUALITY_DRAFT)};
  TaborDrum *drum = physics_drum(models[0]), *former = physics_drum(models[0]),
            *hidden = physics_drum(models[0]);
  static float sound[3][2 * FADE], old[3][2 * FADE], heard[3][2 * FADE];
  TaborSwap *swap, *other;
  const TaborEvent strike = physics_strike(&def), later = {.type = TABOR_EVENT_STRIKE,
                                                           .frame = 100,
                                                           .velocity = strike.velocity,
                                                           .radius = 0.1};
  assert_int_equal(tabor_swap_create(models[0], models[1], &swap, NULL), TABOR_OK);
  assert_int_equal(tabor_swap_create(models[0], models[1], &other, NULL), TABOR_OK);
  play(drum, &strike, 2000, sound);
  play(former, &strike, 2000, old);
  play(hidden, &strike, 2000, heard);
  const TaborEvent events[] = {{.type = TABOR_EVENT_SWAP, .swap = swap}, later};
  const TaborEvent hidden_events[] = {{.type = TABOR_EVENT_SWAP, .swap = other}, later};
  float *outputs[TABOR_MAX_MICS] = {sound[0], sound[1], sound[2]};
  float *hidden_outputs[TABOR_MAX_MICS] = {heard[0], heard[1], heard[2]};
  tabor_drum_process(drum, events, 2, outputs, 2 * FADE);
  tabor_drum_process(hidden, hidden_events, 2, hidden_outputs, 2 * FADE);
  play(former, &later, 2 * FADE, old);
  for (uint32_t mic = 0; mic < 3; mic++) {
    for (uint32_t i = 0; i < HOLD; i++) assert_true(sound[mic][i] == old[mic][i]);
    for (uint32_t i = HOLD + CROSS; i < 2 * FADE; i++) {
      assert_true(sound[mic][i] == heard[mic][i]);
      assert_true(i < HOLD + CROSS + 100 || sound[mic][i] != old[mic][i]);
    }
    assert_true(sound[mic][HOLD + CROSS / 2] != old[mic][HOLD + CROSS / 2]);
  }
  TaborStatistics statistics;
  tabor_drum_statistics(drum, &statistics);
  assert_int_equal(statistics.strikes, 2);
  assert_true(tabor_swap_done(swap));
  tabor_drum_destroy(drum);
  tabor_drum_destroy(former);
  tabor_drum_destroy(hidden);
  tabor_swap_destroy(swap);
  tabor_swap_destroy(other);
  for (int i = 0; i < 2; i++) tabor_model_release(models[i]);
}

/* A drum that could continue is at rest, with the definition's values; the old one rings out beside
 * it. */
static void a_replaced_drum_begins_anew(void **state) {
  (void)state;
  const TaborDrumDef def = physics_preset("frame-drum");
  TaborDrumDef tense = def;
  tense.batter.tension *= 1.1;
  TaborModel *models[] = {physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT),
                          physics_model(&tense, 48000.0, TABOR_QUALITY_DRAFT)};
  TaborDrum *drum = physics_drum(models[0]), *alone = physics_drum(models[0]);
  static float sound[3][2 * FADE], old[3][2 * FADE];
  TaborSwap *swap;
  const TaborEvent strike = physics_strike(&def);
  const TaborEvent louder = {.type = TABOR_EVENT_PARAMETER,
                             .parameter = tabor_parameter_find("output.full_scale")->id,
                             .value = 0.5 * def.full_scale};
  assert_int_equal(tabor_swap_create(models[0], models[1], &swap, NULL), TABOR_OK);
  tabor_drum_process(drum, &louder, 1, NULL, 0);
  tabor_drum_process(alone, &louder, 1, NULL, 0);
  play(drum, &strike, 2000, sound);
  play(alone, &strike, 2000, old);
  TaborLedger before, after;
  tabor_drum_ledger(drum, &before);
  const TaborEvent replace = {.type = TABOR_EVENT_REPLACE, .swap = swap};
  play(drum, &replace, 2 * FADE, sound);
  play(alone, NULL, 2 * FADE, old);
  for (uint32_t mic = 0; mic < 3; mic++) {
    for (uint32_t i = 0; i < 2 * FADE; i++) assert_sum(sound[mic][i], faded(old[mic], i, 0), 0);
  }
  assert_true(tabor_swap_done(swap) && tabor_drum_is_silent(drum));
  tabor_drum_ledger(drum, &after);
  assert_true(after.injected == before.injected && after.stored == 0);
  assert_true(fabs(after.control - (before.control - before.stored)) < 1e-12 * before.injected);
  TaborDrum *fresh = physics_drum(models[1]);
  play(drum, &strike, 2 * FADE, sound);
  play(fresh, &strike, 2 * FADE, old);
  assert_memory_equal(sound, old, sizeof sound);
  TaborStatistics statistics;
  tabor_drum_statistics(drum, &statistics);
  assert_int_equal(statistics.strikes, 2);
  tabor_drum_destroy(fresh);
  tabor_drum_destroy(alone);
  tabor_drum_destroy(drum);
  tabor_swap_destroy(swap);
  for (int i = 0; i < 2; i++) tabor_model_release(models[i]);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(a_tension_toggled_by_ten_per_cent_pumps_no_energy),
    cmocka_unit_test(steps_half_as_long_keep_the_motion),
    cmocka_unit_test(another_own_stroke_keeps_the_motion),
    cmocka_unit_test(a_swap_for_another_model_is_dropped_and_done),
    cmocka_unit_test(old_drums_ring_out_by_name),
    cmocka_unit_test(the_oldest_of_many_fades_ends),
    cmocka_unit_test(the_former_model_gives_way_to_the_new_one),
    cmocka_unit_test(a_replaced_drum_begins_anew),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
