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

static void exchange(TaborDrum *drum, TaborModel *from, TaborModel *to) {
  TaborSwap *swap;
  TaborError error;
  assert_int_equal(tabor_swap_create(from, to, &swap, &error), TABOR_OK);
  const TaborEvent event = {.type = TABOR_EVENT_SWAP, .swap = swap};
  tabor_drum_process(drum, &event, 1, NULL, 64);
  assert_true(tabor_swap_done(swap));
  tabor_swap_destroy(swap);
}

/* Phase and action are kept per mode, so the energy follows the frequencies: it swings by sqrt(1.1) at
 * most and comes back, but for the modes that only one of the models keeps. Carrying displacements over
 * multiplied it by 2e9 in this second. */
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
    for (int toggle = 0; toggle < 750; toggle++) {
      exchange(drum, models[toggle % 2], models[1 - toggle % 2]);
      most = fmax(most, stored(drum));
    }
    print_message("%s: energy rises to %.4f of its start at most, ends at %.6f\n",
                  head ? "resonant" : "batter", most / start, stored(drum) / start);
    assert_true(most < sqrt(1.1) * start * (1.0 + 1e-9));
    assert_true(fabs(stored(drum) / start - 1.0) < 1e-4);
    TaborLedger ledger;
    tabor_drum_ledger(drum, &ledger);
    assert_true(fabs(ledger.residual) < 1e-9 * (ledger.injected + fabs(ledger.control)));
    tabor_drum_destroy(drum);
    for (int i = 0; i < 2; i++) tabor_model_release(models[i]);
  }
}

/* Made for another model, it cannot act: the drum stays as it is, and the swap may be freed. */
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

/* ---- drums that do not continue each other ---------------------------------------------------- */

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

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(a_tension_toggled_by_ten_per_cent_pumps_no_energy),
    cmocka_unit_test(a_swap_for_another_model_is_dropped_and_done),
    cmocka_unit_test(old_drums_ring_out_by_name),
    cmocka_unit_test(the_oldest_of_many_fades_ends),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
