/* SPDX-License-Identifier: MIT */
/* Strokes on the hoop: how it yields, that it shakes the heads and loses nothing by itself, and
 * that a rim at rest is a wall. */
#include "physics.h"

#include "bodies/drum/rim.h"
#include "model/model.h"
#include "state/state.h"

static const double RATE = 48000.0;

static TaborDrumDef rim_at_rest(void) {
  const TaborDrumDef preset = physics_preset("snare-14x5.5-off");
  TaborDrumDef def = physics_small(&preset);
  def.shell.mass = def.hoop.bending_stiffness = 0.0;
  return def;
}

/* On a shell at rest, all around, with orders n < N below 8 kHz, an impulse moves the hoop by (1/m)
 * (1 + 2 Sum cos n t). */
static void an_impulse_finds_the_same_mass_everywhere(void **state) {
  (void)state;
  TaborDrumDef def = rim_at_rest();
  def.hoop.bending_stiffness = 50.0;
  def.hoop.tie_frequency = 50.0;
  def.quality.losses = 0;
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_STUDIO);
  double *shape = calloc(3 * model->modes.padded + model->body.row_count, sizeof *shape);
  double *here = shape, *there = here + model->modes.padded, *radial = there + model->modes.padded;
  const double k2 = model->time_step * model->time_step;
  for (double angle = 0.0; angle < 360.0; angle += 41.0) {
    tb_model_hoop_shape(model, angle, radial, here);
    tb_model_hoop_shape(model, angle + 20.0, radial, there);
    double own = 0.0, across = 0.0, expected = 1.0, apart = 1.0;
    for (uint32_t i = 0; i < model->modes.padded; i++) {
      own += model->modes.g[i] * here[i] * here[i];
      across += model->modes.g[i] * here[i] * there[i];
    }
    for (uint32_t n = 1; n < TB_RIM_ORDERS; n++) {
      expected += 2.0;
      apart += 2.0 * cos(n * 20.0 * 3.14159265358979323846 / 180.0);
    }
    assert_true(fabs(own * def.hoop.mass / k2 / expected - 1.0) < 1e-6);
    assert_true(fabs(across / own - apart / expected) < 1e-6);
  }
  free(shape);
  tabor_model_release(model);
}

/* The ledger 20 ms after a stroke on the rim, when the stick has left, and 40 ms later. */
static void strike_rim(const TaborDrumDef *def, TaborLedger ledger[2]) {
  TaborModel *model = physics_model(def, RATE, TABOR_QUALITY_STUDIO);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent rim = {
    .type = TABOR_EVENT_STRIKE, .velocity = 1.0, .technique = TABOR_TECHNIQUE_RIM};
  tabor_drum_process(drum, &rim, 1, NULL, 960);
  tabor_drum_ledger(drum, &ledger[0]);
  tabor_drum_process(drum, NULL, 0, NULL, 1920);
  tabor_drum_ledger(drum, &ledger[1]);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

static void a_struck_rim_shakes_the_heads(void **state) {
  (void)state;
  const TaborDrumDef preset = physics_preset("snare-14x5.5-off");
  TaborDrumDef def = physics_small(&preset);
  TaborLedger ledger[2];
  strike_rim(&def, ledger);
  print_message("of %.3g J the rim takes %.3g J, the heads %.3g J, %.3g J are radiated\n",
                ledger[1].injected - ledger[1].removed, ledger[1].shell_loss, ledger[1].head_loss,
                ledger[1].radiated);
  assert_true(ledger[1].shell_loss > 0.0 && ledger[1].head_loss > 0.0 && ledger[1].radiated > 0.0);
  assert_true(ledger[1].stored < ledger[0].stored);
  assert_true(fabs(ledger[1].residual) < 1e-12 * ledger[1].injected);
}

static void without_losses_nothing_is_lost(void **state) {
  (void)state;
  const TaborDrumDef preset = physics_preset("snare-14x5.5-off");
  TaborDrumDef def = physics_small(&preset);
  def.quality.losses = 0;
  TaborLedger ledger[2];
  strike_rim(&def, ledger);
  assert_true(ledger[1].shell_loss == 0.0 && ledger[1].head_loss == 0.0);
  assert_true(ledger[0].stored > 0.0);
  assert_true(fabs(ledger[1].stored / ledger[0].stored - 1.0) < 1e-9);
}

/* A rim at rest is a wall: an elastic stick that does not bend comes back as fast as it came. */
static void a_rim_at_rest_does_not_yield(void **state) {
  (void)state;
  TaborDrumDef def = rim_at_rest();
  def.hoop.contact_loss = 0.0;
  def.striker[0].bending_frequency = 0.0;
  TaborLedger ledger[2];
  strike_rim(&def, ledger);
  assert_true(ledger[1].stored == 0.0 && ledger[1].contact_loss == 0.0);
  assert_true(fabs(ledger[1].removed / ledger[1].injected - 1.0) < 1e-12);
}

/* Hertz: a mass M at speed v against a rigid rim presses it with K (5 M v^2/(4 K))^(3/5) at most.
 */
static void a_hard_rim_is_met_as_hertz_says(void **state) {
  (void)state;
  TaborDrumDef def = rim_at_rest();
  def.hoop.contact_loss = 0.0;
  def.striker[0].bending_frequency = 0.0;
  TaborModel *model = physics_model(&def, 192000.0, TABOR_QUALITY_STUDIO);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent rim = {
    .type = TABOR_EVENT_STRIKE, .velocity = 2.0, .technique = TABOR_TECHNIQUE_RIM};
  double most = 0.0;
  for (int i = 0; i < 200; i++) {
    TaborProbe probe;
    tabor_drum_process(drum, &rim, i == 0, NULL, 1);
    tabor_drum_probe(drum, &probe);
    most = fmax(most, probe.striker_force);
  }
  const double k = def.hoop.contact_stiffness;
  const double expected = k * pow(1.25 * def.striker[0].mass * 4.0 / k, 0.6);
  print_message("%.1f N, %.1f N expected\n", most, expected);
  assert_true(fabs(most / expected - 1.0) < 0.005);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(an_impulse_finds_the_same_mass_everywhere),
    cmocka_unit_test(a_struck_rim_shakes_the_heads),
    cmocka_unit_test(without_losses_nothing_is_lost),
    cmocka_unit_test(a_rim_at_rest_does_not_yield),
    cmocka_unit_test(a_hard_rim_is_met_as_hertz_says),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
