/* SPDX-License-Identifier: MIT */
/* The energy ledger: over 0.13 s of every preset at draft and live; at studio of one preset of each
 * kind, and over 0.2 s of these without their losses.
 *
 * usage: test_system_energy [brief | narrow | long]: a sixtieth of a second of every fifth preset;
 * the same with few modes; or a second and half a second of each, all of them at studio, too. */
#include "physics.h"

static const double RATE = 48000.0;

static uint32_t blocks = 150, lossy_blocks = 94, preset_step = 1;
static bool all_at_studio, narrow;

/* Lossless drums conserve: rounding only, over up to 96,000 steps. */
static const double DRIFT = 1e-11;
/* With losses every joule is accounted for. */
static const double RESIDUAL = 1e-9;
/* At draft, two Newton iterations often end before convergence: the remedies may lose, never
 * create. */
static const double DRAFT_LOSS = 1e-5;
/* What rounding may leave where wires hang 2 cm from their rest [J]. */
static const double DROPPED = 2e-15;

static TaborDrumDef drum_def(const char *name) {
  TaborDrumDef def = physics_preset(name);
  if (narrow) def.quality.two_way_bandwidth = 1000.0;
  return def;
}

/* One head, strings below it, a closed shell, two heads, and wires below these. */
static const char *const kinds[] = {"frame-drum", "bodhran-d-string", "timpani-26", "tom-12",
                                    "snare-14x5.5"};

/* The finest quality at which a preset is looked at: models and steps of studio take many times
 * those of live. */
static uint32_t finest_quality(const char *preset) {
  if (all_at_studio) return TABOR_QUALITY_STUDIO;
  for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
    if (strcmp(preset, kinds[i]) == 0) return TABOR_QUALITY_STUDIO;
  }
  return TABOR_QUALITY_LIVE;
}

/* Extremes of the residual over so many blocks, in units of the energy injected. */
static TaborLedger a_stroke(const TaborDrumDef *def, uint32_t quality, uint32_t count,
                            double *largest, double *smallest) {
  TaborModel *model = physics_model(def, RATE, quality);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent strike = physics_strike(def);
  TaborLedger ledger;
  *largest = *smallest = 0.0;
  for (uint32_t block = 0; block < count; block++) {
    tabor_drum_process(drum, &strike, block == 0 ? 1 : 0, NULL, 64);
    tabor_drum_ledger(drum, &ledger);
    *largest = fmax(*largest, ledger.residual / ledger.injected);
    *smallest = fmin(*smallest, ledger.residual / ledger.injected);
  }
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  return ledger;
}

static void lossless_drums_keep_their_energy(void **state) {
  (void)state;
  for (uint32_t p = 0; p < physics_drum_count(); p += preset_step) {
    const char *name = tabor_preset(p)->name;
    if (finest_quality(name) < TABOR_QUALITY_STUDIO) continue;
    TaborDrumDef def = drum_def(name);
    def.quality.losses = 0;
    double most, least;
    const TaborLedger ledger = a_stroke(&def, TABOR_QUALITY_STUDIO, blocks, &most, &least);
    const double drift = fmax(most, -least);
    print_message("%-20s drift %.1e of %.3g J\n", name, drift, ledger.injected);
    assert_true(drift < DRIFT);
    assert_true(ledger.head_loss == 0.0 && ledger.wire_loss == 0.0 && ledger.radiated == 0.0);
    assert_true(ledger.contact_loss == 0.0);
    assert_true(ledger.stored + ledger.removed > 0.999 * ledger.injected);
  }
}

static void with_losses_every_joule_is_accounted_for(void **state) {
  (void)state;
  for (uint32_t p = 0; p < physics_drum_count(); p += preset_step) {
    for (uint32_t quality = TABOR_QUALITY_DRAFT; quality <= finest_quality(tabor_preset(p)->name);
         quality++) {
      const TaborDrumDef def = drum_def(tabor_preset(p)->name);
      double most, least;
      const TaborLedger ledger = a_stroke(&def, quality, lossy_blocks, &most, &least);
      print_message(
        "%-20s quality %u: residual %.1e to %.1e; head %.2g wire %.2g contact %.2g radiated "
        "%.2g J\n",
        tabor_preset(p)->name, quality, least, most, ledger.head_loss, ledger.wire_loss,
        ledger.contact_loss, ledger.radiated);
      assert_true(least > -physics_residual(quality));
      assert_true(most < (quality == TABOR_QUALITY_DRAFT ? DRAFT_LOSS : physics_residual(quality)));
      assert_true(ledger.head_loss > 0.0 && ledger.radiated > 0.0);
    }
  }
}

/* What a stroke brings is M v^2/2, and what it hits decides what it loses. */
static TaborDrumDef with_damping_k(double damping_k) {
  TaborDrumDef def = drum_def("tom-12");
  def.batter.damping_k = def.resonant.damping_k = damping_k;
  return def;
}

/* What a loss in proportion to the wavenumber takes is lost in the heads. */
static void film_loss_is_accounted_for(void **state) {
  (void)state;
  for (uint32_t q = TABOR_QUALITY_LIVE; q <= TABOR_QUALITY_STUDIO; q++) {
    const TaborDrumDef without = with_damping_k(0.0), with = with_damping_k(0.3);
    double most, least;
    const TaborLedger before = a_stroke(&without, q, lossy_blocks, &most, &least);
    const TaborLedger after = a_stroke(&with, q, lossy_blocks, &most, &least);
    print_message("head_loss %.4g J, with damping_k %.4g J, residual %.1e\n", before.head_loss,
                  after.head_loss, fmax(most, -least));
    assert_true(fmax(most, -least) < physics_residual(q));
    assert_true(after.head_loss > 1.05 * before.head_loss);
  }
}

static void a_stroke_brings_its_kinetic_energy(void **state) {
  (void)state;
  const TaborDrumDef def = physics_preset("frame-drum");
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  TaborDrum *drum = physics_drum(model);
  TaborEvent strike = physics_strike(&def);
  double expected = 0.0;
  for (int i = 0; i < 5; i++) { /* onto a head that moves by now */
    strike.velocity = 0.3 + 2.0 * i;
    tabor_drum_process(drum, &strike, 1, NULL, 700);
    expected += 0.5 * def.striker[strike.striker].mass * strike.velocity * strike.velocity;
  }
  TaborLedger ledger;
  tabor_drum_ledger(drum, &ledger);
  assert_true(fabs(ledger.injected / expected - 1.0) < 1e-9);
  assert_true(fabs(ledger.residual) < 1e-9 * expected);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

/* Moving parameters do work, either sign, and the balance still closes. */
static void moving_parameters_are_accounted_for(void **state) {
  (void)state;
  const TaborDrumDef preset = drum_def("tabor"), def = physics_small(&preset);
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_STUDIO);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent strike = physics_strike(&def);
  static const char *const keys[] = {"wires.strainer", "wires.tension", "wires.damping_1",
                                     "wires.damping_0"};
  const double values[] = {0.2, 1.3 * def.wires.tension, 0.001, 10.0};
  tabor_drum_process(drum, &strike, 1, NULL, 480);
  for (int i = 0; i < 8; i++) {
    const TaborParameter *parameter = tabor_parameter_find(keys[i % 4]);
    assert_non_null(parameter);
    TaborEvent move = {.type = TABOR_EVENT_PARAMETER, .parameter = parameter->id};
    move.value = i < 4 ? values[i] : (i == 4 ? 1.0 : (i == 5 ? def.wires.tension : 0.0));
    tabor_drum_process(drum, &move, 1, NULL, 2000);
  }
  TaborLedger ledger;
  tabor_drum_ledger(drum, &ledger);
  print_message("control %.3g J, residual %.1e J of %.3g J\n", ledger.control, ledger.residual,
                ledger.injected);
  assert_true(ledger.control != 0.0);
  assert_true(fabs(ledger.residual) < RESIDUAL * (ledger.injected + fabs(ledger.control)));
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

/* A drum at rest is exactly at rest, awake too: its ledger does not move. */
static void a_drum_at_rest_stays_there(void **state) {
  (void)state;
  const TaborDrumDef def = drum_def("bodhran-d-string");
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_STUDIO);
  TaborDrum *drum = physics_drum(model);
  /* A parameter set to the value that it has wakes the drum without moving anything. */
  const TaborEvent wake = {.type = TABOR_EVENT_PARAMETER,
                           .parameter = tabor_parameter_find("wires.tension")->id,
                           .value = def.wires.tension};
  float samples[512];
  float *outputs[TABOR_MAX_MICS] = {samples};
  for (int block = 0; block < 20; block++) {
    tabor_drum_process(drum, &wake, block == 0 ? 1 : 0, outputs, 512);
    for (int i = 0; i < 512; i++) assert_true(samples[i] == 0.0f);
  }
  TaborLedger ledger;
  tabor_drum_ledger(drum, &ledger);
  assert_true(ledger.stored == 0.0 && ledger.residual == 0.0 && ledger.contact_loss == 0.0);
  TaborStatistics statistics;
  tabor_drum_statistics(drum, &statistics);
  assert_true(statistics.solves > 100); /* it really was awake */
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

/* A hand on a ringing head takes its energy, and the ledger says so. */
static void a_hand_damps_the_head(void **state) {
  (void)state;
  const TaborDrumDef def = physics_preset("frame-drum");
  double left[2];
  for (int damped = 0; damped < 2; damped++) {
    TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_LIVE);
    TaborDrum *drum = physics_drum(model);
    const TaborEvent strike = physics_strike(&def);
    tabor_drum_process(drum, &strike, 1, NULL, 2400);
    const TaborEvent hand = {
      .type = TABOR_EVENT_DAMP, .id = 7, .radius = 0.06, .angle = 40.0, .value = 10.0};
    tabor_drum_process(drum, &hand, damped ? 1 : 0, NULL, 7200);
    TaborLedger ledger;
    tabor_drum_ledger(drum, &ledger);
    left[damped] = ledger.stored;
    assert_true((ledger.damper_loss > 0.0) == (damped == 1));
    assert_true(fabs(ledger.residual) < RESIDUAL * ledger.injected);
    tabor_drum_destroy(drum);
    tabor_model_release(model);
  }
  print_message("energy left after 150 ms: %.2g J free, %.2g J damped\n", left[0], left[1]);
  assert_true(left[1] < 0.1 * left[0]);
}

/* Twelve gut strands thrown about: one sample ends at the cap of 4 with both remedies spent. The
 * step is then shortened by as little as the energy asks for, not by a fifth of all motion, which
 * clicks. */
static void the_guard_takes_next_to_nothing(void **state) {
  (void)state;
  TaborDrumDef def = physics_preset("marching-14x12");
  def.wires.contact_stiffness = 2e5;
  def.wires.contact_exponent = 1.0;
  def.quality.newton_cap = 4;
  def = physics_small(&def);
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_STUDIO);
  TaborDrum *drum = physics_drum(model);
  TaborEvent strike = physics_strike(&def);
  strike.velocity = 12.0;
  TaborLedger ledger;
  for (uint32_t block = 0; block < 10; block++) {
    tabor_drum_process(drum, &strike, block == 0 ? 1 : 0, NULL, 64);
  }
  tabor_drum_ledger(drum, &ledger);
  TaborStatistics statistics;
  tabor_drum_statistics(drum, &statistics);
  print_message("guarded %llu times, residual %.1e J of %.3g J\n",
                (unsigned long long)statistics.guarded, ledger.residual, ledger.injected);
  assert_true(fabs(ledger.residual) < RESIDUAL * ledger.injected);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

/* Wires of heavy damping drop 2 cm from a head. Their displacements are rounded to a part 1e-16, as
 * if springs of 1e-16 m/k^2 held them, mass m: 1e-13 J at 2 cm. A recursion that rounds always to
 * one side, because its coefficients do, brings them a tenth of that, one that adds up changes a
 * thousandth. */
static void wires_far_from_rest_gain_nothing_by_rounding(void **state) {
  (void)state;
  TaborDrumDef def = physics_preset("snare-14x6.5-loose");
  def.shell.mass = 0.0; /* whose own rounding is not meant */
  def.wires.count = 2;
  def.wires.rest_offset = -0.01; /* pressed against the head, and bent by it */
  def.wires.strainer_travel = 0.02;
  def.wires.damping_0 = 200.0;
  def.wires.tension = 3.3; /* slack wires, whose bound this is */
  def = physics_small(&def);
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_STUDIO);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent drop = {.type = TABOR_EVENT_PARAMETER,
                           .parameter = tabor_parameter_find("wires.strainer")->id,
                           .value = 0.0};
  tabor_drum_process(drum, &drop, 1, NULL, 4800);
  TaborLedger ledger;
  tabor_drum_ledger(drum, &ledger);
  print_message("dropped wires: lost %.2g J, residual %.1e J\n", ledger.wire_loss, ledger.residual);
  assert_true(fabs(ledger.residual) < DROPPED);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

int main(int argc, char **argv) {
  narrow = argc > 1 && strcmp(argv[1], "narrow") == 0;
  if (narrow || (argc > 1 && strcmp(argv[1], "brief") == 0)) {
    blocks = lossy_blocks = 12;
    preset_step = 5;
  }
  if (argc > 1 && strcmp(argv[1], "long") == 0) {
    blocks = 750;
    lossy_blocks = 375;
    all_at_studio = true;
  }
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(lossless_drums_keep_their_energy),
    cmocka_unit_test(with_losses_every_joule_is_accounted_for),
    cmocka_unit_test(film_loss_is_accounted_for),
    cmocka_unit_test(a_stroke_brings_its_kinetic_energy),
    cmocka_unit_test(moving_parameters_are_accounted_for),
    cmocka_unit_test(a_drum_at_rest_stays_there),
    cmocka_unit_test(a_hand_damps_the_head),
    cmocka_unit_test(the_guard_takes_next_to_nothing),
    cmocka_unit_test(wires_far_from_rest_gain_nothing_by_rounding),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
