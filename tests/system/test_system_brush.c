/* SPDX-License-Identifier: MIT */
/* Brushes: slaps and sweeps close their accounts, sound like a rough coat and not like a tone, and
 * are the same whatever the blocks. */

#include "event_script.h"

static const double RATE = 48000.0;

enum { BRUSH = 1 };

/* A drum with a brush as its second striker. */
static TaborDrumDef brushed(const char *preset) {
  TaborDrumDef def = physics_preset(preset);
  static const char *const BRISTLES[][2] = {{"kind", "brush"},
                                            {"mass", "0.0006"},
                                            {"contact_stiffness", "2e9"},
                                            {"contact_exponent", "2"},
                                            {"contact_loss", "0.5"}};
  def.striker_count = 1;
  for (size_t i = 0; i < sizeof BRISTLES / sizeof *BRISTLES; i++) {
    char key[64];
    TaborError error;
    snprintf(key, sizeof key, "striker.wires.%s", BRISTLES[i][0]);
    if (tabor_drum_def_set(&def, key, BRISTLES[i][1], &error) != TABOR_OK) {
      fail_msg("%s", error.message);
    }
  }
  return def;
}

static const TaborEvent SLAP = {.type = TABOR_EVENT_STRIKE,
                                .id = 1,
                                .striker = BRUSH,
                                .velocity = 2.0,
                                .radius = 0.08,
                                .angle = 30.0};
static const TaborEvent SWEEP = {.type = TABOR_EVENT_STRIKE,
                                 .id = 1,
                                 .striker = BRUSH,
                                 .technique = TABOR_TECHNIQUE_SWEEP,
                                 .velocity = 0.8,
                                 .radius = 0.09,
                                 .angle = 30.0,
                                 .value = 0.5};

static void check_closed(const TaborDrum *drum) {
  TaborLedger ledger;
  tabor_drum_ledger(drum, &ledger);
  assert_true(ledger.injected > 0.0);
  assert_true(fabs(ledger.residual) < physics_residual(TABOR_QUALITY_DRAFT) * ledger.injected);
}

/* ---- slaps ----------------------------------------------------------------------------------- */

static void a_slap_brings_the_energy_of_its_wires(void **state) {
  (void)state;
  TaborDrumDef def = brushed("frame-drum");
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_LIVE);
  TaborDrum *drum = physics_drum(model);
  tabor_drum_process(drum, &SLAP, 1, NULL, 0);
  TaborLedger ledger;
  tabor_drum_ledger(drum, &ledger);
  assert_true(fabs(ledger.injected - 0.5 * 0.0006 * 4.0) < 1e-12);
  tabor_drum_process(drum, NULL, 0, NULL, 9600);
  check_closed(drum);
  TaborStatistics statistics;
  tabor_drum_statistics(drum, &statistics);
  assert_int_equal(statistics.strikes, 1);
  assert_int_equal(statistics.in_play, 0); /* it has flown off */
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

static void a_stick_does_not_sweep(void **state) {
  (void)state;
  TaborDrumDef def = brushed("frame-drum");
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  TaborDrum *drum = physics_drum(model);
  TaborEvent sweep = SWEEP;
  sweep.striker = 0;
  tabor_drum_process(drum, &sweep, 1, NULL, 64);
  TaborStatistics statistics;
  tabor_drum_statistics(drum, &statistics);
  assert_int_equal(statistics.dropped_events, 1);
  assert_true(tabor_drum_is_silent(drum));
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

/* ---- sweeps ---------------------------------------------------------------------------------- */

static void a_sweep_goes_on_until_it_is_lifted_and_then_all_is_silent(void **state) {
  (void)state;
  TaborDrumDef def = brushed("snare-14x5.5");
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  TaborDrum *drum = physics_drum(model);
  tabor_drum_process(drum, &SWEEP, 1, NULL, 48000);
  check_closed(drum);
  TaborProbe probe;
  tabor_drum_probe(drum, &probe);
  assert_false(isnan(probe.striker));
  const TaborEvent release = {.type = TABOR_EVENT_RELEASE, .id = 1};
  tabor_drum_process(drum, &release, 1, NULL, 12000);
  tabor_drum_probe(drum, &probe);
  assert_true(isnan(probe.striker));
  for (int i = 0; i < 40 && !tabor_drum_is_silent(drum); i++) {
    tabor_drum_process(drum, NULL, 0, NULL, 9600);
  }
  assert_true(tabor_drum_is_silent(drum));
  check_closed(drum);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

/* Level of half a second of a sweep, once it is under way [dB]. */
static double level_of(TaborModel *model, double velocity, double pressure) {
  static float sound[24000];
  TaborDrum *drum = physics_drum(model);
  TaborEvent sweep = SWEEP;
  sweep.velocity = velocity;
  sweep.value = pressure;
  tabor_drum_process(drum, &sweep, 1, NULL, 7200);
  float *outputs[TABOR_MAX_MICS] = {sound};
  tabor_drum_process(drum, NULL, 0, outputs, 24000);
  tabor_drum_destroy(drum);
  double sum = 0.0;
  for (int i = 0; i < 24000; i++) sum += (double)sound[i] * sound[i];
  return 10.0 * log10(sum / 24000.0);
}

static void the_level_follows_speed_and_pressure(void **state) {
  (void)state;
  TaborDrumDef def = brushed("frame-drum");
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_LIVE);
  double last = -INFINITY;
  for (double speed = 0.2; speed < 4.0; speed *= 2.0) {
    const double level = level_of(model, speed, 0.5);
    print_message("%.1f m/s: %.1f dB\n", speed, level);
    assert_true(level > last + 2.0);
    last = level;
  }
  last = -INFINITY;
  for (double pressure = 0.0; pressure <= 1.0; pressure += 0.5) {
    const double level = level_of(model, 0.8, pressure);
    print_message("pressure %.1f: %.1f dB\n", pressure, level);
    assert_true(level > last + 2.0);
    last = level;
  }
  tabor_model_release(model);
}

static void a_brush_that_stays_is_not_heard(void **state) {
  (void)state;
  TaborDrumDef def = brushed("frame-drum");
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_LIVE);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent stay = {.type = TABOR_EVENT_MOVE, .id = 1, .radius = 0.09, .angle = 60.0};
  tabor_drum_process(drum, &SWEEP, 1, NULL, 4800);
  tabor_drum_process(drum, &stay, 1, NULL, 96000);
  for (int i = 0; i < 40 && !tabor_drum_is_silent(drum); i++) {
    tabor_drum_process(drum, NULL, 0, NULL, 9600);
  }
  assert_true(tabor_drum_is_silent(drum)); /* with the brush on it */
  TaborProbe probe;
  tabor_drum_probe(drum, &probe);
  assert_true(probe.striker_force > 0.1);
  const TaborEvent on = {.type = TABOR_EVENT_MOVE, .id = 1, .radius = 0.05, .angle = 90.0};
  tabor_drum_process(drum, &on, 1, NULL, 4800);
  assert_false(tabor_drum_is_silent(drum));
  check_closed(drum);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

/* ---- texture --------------------------------------------------------------------------------- */

enum { SEGMENT = 1024, SEGMENTS = 160, LOWEST = 10, HIGHEST = 250, NEIGHBOURS = 12 };

/* Power of bin `bin` of a segment under a Hann window. */
static double power_at(const double *x, int bin) {
  const double pi = 3.14159265358979323846, turn = 2.0 * pi * bin / SEGMENT;
  double re = 0.0, im = 0.0;
  for (int i = 0; i < SEGMENT; i++) {
    const double w = 0.5 - 0.5 * cos(2.0 * pi * i / SEGMENT);
    re += w * x[i] * cos(turn * i);
    im += w * x[i] * sin(turn * i);
  }
  return re * re + im * im;
}

static int compare(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return x < y ? -1 : x > y;
}

/* By how much some line of the spectrum stands above the median of its neighbours, at most [dB]. */
static double highest_line(const double *x) {
  static double power[HIGHEST + NEIGHBOURS + 1];
  for (int bin = LOWEST - NEIGHBOURS < 1 ? 1 : LOWEST - NEIGHBOURS; bin <= HIGHEST + NEIGHBOURS;
       bin++) {
    power[bin] = 0.0;
    for (int s = 0; s < SEGMENTS; s++) power[bin] += power_at(x + s * SEGMENT, bin);
  }
  double most = 0.0;
  for (int bin = LOWEST + NEIGHBOURS; bin <= HIGHEST; bin++) {
    double around[2 * NEIGHBOURS + 1];
    memcpy(around, power + bin - NEIGHBOURS, sizeof around);
    qsort(around, 2 * NEIGHBOURS + 1, sizeof *around, compare);
    most = fmax(most, 10.0 * log10(power[bin] / around[NEIGHBOURS]));
  }
  return most;
}

/* The force of a sweep on a head that rings no longer than it is pushed: 1 to 12 kHz. A tone of 15
 * % of its strength would be found. */
static void a_sweep_is_noise_without_a_tone(void **state) {
  (void)state;
  static double force[SEGMENT * SEGMENTS];
  TaborDrumDef def = brushed("frame-drum");
  def.batter.damping_0 = 1000.0;
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  for (double speed = 0.3; speed < 3.0; speed *= 3.0) {
    TaborDrum *drum = physics_drum(model);
    TaborEvent sweep = SWEEP;
    sweep.velocity = speed;
    tabor_drum_process(drum, &sweep, 1, NULL, 7200);
    double mean = 0.0, square = 0.0;
    for (int i = 0; i < SEGMENT * SEGMENTS; i++) {
      TaborProbe probe;
      tabor_drum_process(drum, NULL, 0, NULL, 1);
      tabor_drum_probe(drum, &probe);
      force[i] = probe.striker_force;
      mean += force[i] / (SEGMENT * SEGMENTS);
    }
    for (int i = 0; i < SEGMENT * SEGMENTS; i++) {
      force[i] -= mean;
      square += force[i] * force[i] / (SEGMENT * SEGMENTS);
    }
    const double line = highest_line(force);
    for (int i = 0; i < SEGMENT * SEGMENTS; i++) {
      force[i] += 0.15 * sqrt(2.0 * square) * sin(2.0 * 3.14159265358979323846 * 3000.0 / RATE * i);
    }
    const double with = highest_line(force);
    print_message(
      "%.1f m/s: force %.2f N, %.0f mN of noise, highest line %.1f dB; with a tone %.1f dB\n",
      speed, mean, 1e3 * sqrt(square), line, with);
    assert_true(line < 4.0);
    assert_true(with > 4.0);
    tabor_drum_destroy(drum);
  }
  tabor_model_release(model);
}

/* ---- two hands at work ----------------------------------------------------------------------- */

/* Sweeps, moves, presses, slaps and lifts, in turn and at once. */
static uint32_t hands_at_work(uint32_t frame, TaborEvent *event) {
  const uint32_t turn = frame / 317;
  if (frame % 317 != 40) return 0;
  *event = (TaborEvent){.type = TABOR_EVENT_MOVE,
                        .id = turn % 3,
                        .radius = 0.02 * (turn % 8),
                        .angle = 73.0 * turn,
                        .value = turn % 4 ? 0.0 : 0.01};
  if (turn % 7 == 0) {
    *event = SWEEP;
    event->id = 1 + turn % 2;
    event->velocity = 0.2 * (turn % 20);
    event->value = 0.1 * (turn % 9);
  } else if (turn % 7 == 3) {
    *event = SLAP;
    event->id = 1 + turn % 3;
    event->velocity = 0.3 * (turn % 17);
  } else if (turn % 7 == 5) {
    *event =
      (TaborEvent){.type = TABOR_EVENT_PRESS, .id = turn % 3, .value = (turn * 7 % 10) / 9.0};
  } else if (turn % 17 == 9) {
    *event = (TaborEvent){.type = TABOR_EVENT_RELEASE, .id = turn % 3};
  }
  return 1;
}

enum { FRAMES = 16000 };

static void all_is_accounted_for_at_every_cap(void **state) {
  (void)state;
  static float out[FRAMES];
  for (uint32_t cap = 1; cap <= 4; cap++) {
    for (uint32_t losses = 0; losses < 2; losses++) {
      TaborDrumDef def = brushed(cap % 2 ? "frame-drum" : "snare-14x5.5");
      def.quality.newton_cap = cap;
      def.quality.losses = losses;
      def.quality.two_way_bandwidth = 2000.0;
      def = physics_small(&def);
      TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_STUDIO);
      TaborDrum *drum = physics_drum(model);
      event_script_play(hands_at_work, drum, 0, FRAMES, 64, out);
      TaborLedger ledger;
      TaborStatistics statistics;
      tabor_drum_ledger(drum, &ledger);
      tabor_drum_statistics(drum, &statistics);
      print_message("%s, cap %u, losses %u: residual %.1e of %.2g J, %llu capped\n", def.name, cap,
                    losses, ledger.residual / ledger.injected, ledger.injected,
                    (unsigned long long)statistics.newton_capped);
      assert_true(ledger.residual > -1e-9 * ledger.injected);
      if (!statistics.newton_capped) assert_true(ledger.residual < 1e-9 * ledger.injected);
      assert_true(losses || ledger.contact_loss + ledger.damper_loss + ledger.head_loss == 0.0);
      assert_int_equal(statistics.recovered, 0);
      tabor_drum_destroy(drum);
      tabor_model_release(model);
    }
  }
}

static void blocks_saves_and_swaps_change_no_bit(void **state) {
  (void)state;
  static float whole[FRAMES], pieces[FRAMES];
  TaborDrumDef def = brushed("snare-14x5.5");
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  TaborModel *again = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  TaborDrum *drum = physics_drum(model);
  event_script_play(hands_at_work, drum, 0, FRAMES, 1024, whole);
  tabor_drum_destroy(drum);

  drum = physics_drum(model);
  event_script_play(hands_at_work, drum, 0, 5000, 37, pieces);
  const size_t size = tabor_drum_state_size(drum);
  void *bytes = malloc(size);
  tabor_drum_state_save(drum, bytes);
  tabor_drum_destroy(drum);
  drum = physics_drum(model);
  assert_int_equal(tabor_drum_state_load(drum, bytes, size), TABOR_OK);
  free(bytes);
  event_script_play(hands_at_work, drum, 5000, 9000, 64, pieces);
  TaborSwap *swap;
  assert_int_equal(tabor_swap_create(model, again, &swap, NULL), TABOR_OK);
  const TaborEvent event = {.type = TABOR_EVENT_SWAP, .swap = swap};
  tabor_drum_process(drum, &event, 1, NULL, 0);
  event_script_play(hands_at_work, drum, 9000, FRAMES, 1, pieces);
  assert_true(tabor_swap_done(swap));
  assert_memory_equal(whole, pieces, sizeof whole);
  tabor_drum_reset(drum);
  assert_true(tabor_drum_is_silent(drum));
  tabor_drum_destroy(drum);
  tabor_swap_destroy(swap);
  tabor_model_release(model);
  tabor_model_release(again);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(a_slap_brings_the_energy_of_its_wires),
    cmocka_unit_test(a_stick_does_not_sweep),
    cmocka_unit_test(a_sweep_goes_on_until_it_is_lifted_and_then_all_is_silent),
    cmocka_unit_test(the_level_follows_speed_and_pressure),
    cmocka_unit_test(a_brush_that_stays_is_not_heard),
    cmocka_unit_test(a_sweep_is_noise_without_a_tone),
    cmocka_unit_test(all_is_accounted_for_at_every_cap),
    cmocka_unit_test(blocks_saves_and_swaps_change_no_bit),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
