/* SPDX-License-Identifier: MIT */
/* Drums whose wires lie unevenly and are bent: energy, strainer, limiting case, swaps. */
#include "physics.h"
#include "state/state.h"

enum { BLOCK = 64, BLOCKS = 94 };

static const double RATE = 48000.0;
/* As in test_system_energy.c. */
static const double DRIFT = 1e-11, RESIDUAL = 1e-9;

static TaborDrumDef uneven(double unevenness) {
  TaborDrumDef def = physics_preset("snare-14x5.5");
  def.wires.rest_spread = 1e-4;
  def.wires.bend_height = 2.5e-4;
  def.wires.bend_length = 0.02;
  def.wires.unevenness = unevenness;
  return def;
}

static TaborLedger ledger_of(const TaborDrum *drum) {
  TaborLedger ledger;
  tabor_drum_ledger(drum, &ledger);
  return ledger;
}

/* Largest residual over a stroke, in units of the energy injected. */
static double residual_of_a_stroke(const TaborDrumDef *def, uint32_t quality) {
  TaborModel *model = physics_model(def, RATE, quality);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent strike = physics_strike(def);
  double worst = 0.0;
  for (uint32_t block = 0; block < BLOCKS; block++) {
    tabor_drum_process(drum, &strike, block == 0 ? 1 : 0, NULL, BLOCK);
    const TaborLedger ledger = ledger_of(drum);
    worst = fmax(worst, fabs(ledger.residual) / ledger.injected);
  }
  print_message("unevenness %g, quality %u: residual %.1e\n", def->wires.unevenness, quality,
                worst);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  return worst;
}

static void every_joule_is_accounted_for(void **state) {
  (void)state;
  TaborDrumDef def = uneven(1.0);
  assert_true(residual_of_a_stroke(&def, TABOR_QUALITY_LIVE) <
              physics_residual(TABOR_QUALITY_LIVE));
  def = physics_small(&def);
  assert_true(residual_of_a_stroke(&def, TABOR_QUALITY_STUDIO) < RESIDUAL);
  def.wires.unevenness = 3.0;
  assert_true(residual_of_a_stroke(&def, TABOR_QUALITY_STUDIO) < RESIDUAL);
  def.quality.losses = 0;
  assert_true(residual_of_a_stroke(&def, TABOR_QUALITY_STUDIO) < DRIFT);
}

static void move(TaborDrum *drum, const char *key, double value) {
  const TaborEvent event = {
    .type = TABOR_EVENT_PARAMETER, .parameter = tabor_parameter_find(key)->id, .value = value};
  tabor_drum_process(drum, &event, 1, NULL, 2000);
}

/* Tension and strainer do work on bent wires, which the ledger has. */
static void live_changes_are_accounted_for(void **state) {
  (void)state;
  TaborDrumDef def = uneven(3.0);
  def = physics_small(&def);
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_STUDIO);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent strike = physics_strike(&def);
  tabor_drum_process(drum, &strike, 1, NULL, 480);
  move(drum, "wires.tension", 1.3 * def.wires.tension);
  move(drum, "wires.strainer", 0.3);
  move(drum, "wires.tension", 0.7 * def.wires.tension);
  move(drum, "wires.strainer", 1.0);
  const TaborLedger ledger = ledger_of(drum);
  print_message("control %.3g J, residual %.1e of %.3g J\n", ledger.control, ledger.residual,
                ledger.injected);
  assert_true(ledger.control != 0.0);
  assert_true(fabs(ledger.residual) < RESIDUAL * (ledger.injected + fabs(ledger.control)));
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

static double least_gap(const TaborModel *model) {
  double gap = INFINITY;
  for (uint32_t row = 0; row < model->wires.stride; row++) {
    if (model->wires.real[row] != 0.0) gap = fmin(gap, -model->rest.eta[row]);
  }
  return gap;
}

/* The lowest point of the most uneven wires comes as far off as even wires do. */
static void thrown_off_all_wires_hang_clear(void **state) {
  (void)state;
  uint64_t random = physics_seed();
  TaborDrumDef def = uneven(0.0);
  def.wires.strainer = 0.0;
  def = physics_small(&def);
  TaborModel *even = physics_model(&def, RATE, TABOR_QUALITY_STUDIO);
  const double clear = least_gap(even);
  tabor_model_release(even);
  def.wires.rest_spread = def.wires.bend_height = 1e-3;
  def.wires.unevenness = 3.0;
  for (int i = 0; i < 5; i++) {
    def.wires.seed = (uint32_t)physics_random(&random);
    TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_STUDIO);
    print_message("seed %u: %.4f mm, even %.4f mm\n", def.wires.seed, 1e3 * least_gap(model),
                  1e3 * clear);
    assert_true(least_gap(model) > clear - 1e-12);
    tabor_model_release(model);
  }
}

/* Strokes of the same drum with wires on, thrown off by the lever: silent wires, which are lifted
 * in the end. */
static void thrown_off_wires_are_silent(void **state) {
  (void)state;
  TaborDrumDef def = uneven(3.0);
  def.wires.damping_0 = 100.0; /* they come to rest soon */
  def = physics_small(&def);
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_STUDIO);
  TaborDrum *drum = physics_drum(model);
  move(drum, "wires.strainer", 0.0);
  tabor_drum_process(drum, NULL, 0, NULL, 24000);
  TaborEvent strike = physics_strike(&def);
  strike.velocity = 2.0;
  for (uint32_t block = 0; block < 4 * BLOCKS; block++) {
    tabor_drum_process(drum, &strike, block == 0 ? 1 : 0, NULL, BLOCK);
    TaborProbe probe;
    tabor_drum_probe(drum, &probe);
    assert_true(probe.wire_force == 0.0);
  }
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

static void render(const TaborDrumDef *def, uint32_t quality, float *samples) {
  TaborModel *model = physics_model(def, RATE, quality);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent strike = physics_strike(def);
  float *outputs[TABOR_MAX_MICS] = {samples};
  tabor_drum_process(drum, &strike, 1, outputs, BLOCKS * BLOCK);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

/* Limiting case: without unevenness every bit is that of even wires. Another seed sounds different.
 */
static void without_unevenness_nothing_changes(void **state) {
  (void)state;
  static float heard[4][BLOCKS * BLOCK];
  TaborDrumDef even = physics_preset("snare-14x5.5"), def = uneven(0.0);
  even.wires.rest_spread = 0.0;
  render(&even, TABOR_QUALITY_LIVE, heard[0]);
  render(&def, TABOR_QUALITY_LIVE, heard[1]);
  assert_memory_equal(heard[0], heard[1], sizeof heard[0]);
  def.wires.unevenness = 1.0;
  render(&def, TABOR_QUALITY_LIVE, heard[1]);
  render(&def, TABOR_QUALITY_LIVE, heard[2]);
  assert_memory_equal(heard[1], heard[2], sizeof heard[1]);
  def.wires.seed += 1;
  render(&def, TABOR_QUALITY_LIVE, heard[3]);
  assert_memory_not_equal(heard[1], heard[3], sizeof heard[1]);
  assert_memory_not_equal(heard[0], heard[1], sizeof heard[0]);
}

/* At rest, the probe's wire is where the contact is, bent or not. */
static void the_probe_sees_the_shape(void **state) {
  (void)state;
  TaborDrumDef def = uneven(3.0);
  def.wires.count = 1;
  def.wires.offset = 0.0;
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_LIVE);
  TaborDrum *drum = physics_drum(model);
  TaborProbe probe;
  tabor_drum_probe(drum, &probe);
  const double eta = model->rest.eta[model->wires.middle];
  print_message("head %.6f mm, wire %.6f mm, penetration %.6f mm\n", 1e3 * probe.head,
                1e3 * probe.wire, 1e3 * eta);
  assert_true(model->wires.shape[model->wires.middle] != 0.0);
  /* The probe's head sags in all modes, by 13 um, that under the contacts in two-way modes only. */
  assert_true(fabs(model->wires.side * (probe.head - probe.wire) - eta) < 1e-7);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

/* A ringing drum goes on with other wires, and its energy account with it. */
static void a_swap_to_another_seed_keeps_the_account(void **state) {
  (void)state;
  TaborDrumDef def = uneven(2.0);
  def = physics_small(&def);
  for (int off = 0; off < 2; off++) {
    def.wires.strainer = off ? 0.0 : 1.0;
    TaborModel *from = physics_model(&def, RATE, TABOR_QUALITY_STUDIO);
    TaborDrumDef other = def;
    other.wires.seed += 1;
    TaborModel *to = physics_model(&other, RATE, TABOR_QUALITY_STUDIO);
    TaborDrum *drum = physics_drum(from);
    const TaborEvent strike = physics_strike(&def);
    tabor_drum_process(drum, &strike, 1, NULL, 2000);
    TaborSwap *swap;
    assert_int_equal(tabor_swap_create(from, to, &swap, NULL), TABOR_OK);
    const TaborEvent event = {.type = TABOR_EVENT_SWAP, .swap = swap};
    tabor_drum_process(drum, &event, 1, NULL, 4000);
    const TaborLedger ledger = ledger_of(drum);
    print_message("strainer %g: residual %.1e of %.3g J, control %.2g J\n", def.wires.strainer,
                  ledger.residual, ledger.injected, ledger.control);
    assert_true(fabs(ledger.residual) < RESIDUAL * (ledger.injected + fabs(ledger.control)));
    assert_true(from->fingerprint != to->fingerprint);
    tabor_drum_destroy(drum);
    tabor_swap_destroy(swap);
    tabor_model_release(from);
    tabor_model_release(to);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(every_joule_is_accounted_for),
    cmocka_unit_test(live_changes_are_accounted_for),
    cmocka_unit_test(thrown_off_all_wires_hang_clear),
    cmocka_unit_test(thrown_off_wires_are_silent),
    cmocka_unit_test(without_unevenness_nothing_changes),
    cmocka_unit_test(the_probe_sees_the_shape),
    cmocka_unit_test(a_swap_to_another_seed_keeps_the_account),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
