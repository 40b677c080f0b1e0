/* SPDX-License-Identifier: MIT */
/* Mufflers: a light one adds c phi^2/2 to each mode's decay rate; one of strength 0 is not there.
 */
#include "physics.h"

#include "definition/params.h"
#include "step/live_params.h"

/* One mode rings alone in vacuo: all others die at once. */
static TaborDrumDef lone_mode(double strength) {
  TaborDrumDef def = physics_preset("frame-drum");
  def.air.density = 0.0;
  def.air.gravity = 0.0;
  def.batter.damping_0 = 0.5;
  def.batter.damping_1 = 0.1;
  def.batter.muffle_strength = strength;
  def.batter.muffle_radius = 0.05;
  def.batter.muffle_angle = 20.0;
  def.strike.radius = 0.0;
  def.quality.two_way_bandwidth = 3000.0;
  return def;
}

static TaborDrumDef muffled(void) {
  TaborDrumDef def = physics_preset("frame-drum");
  def.batter.muffle_strength = 5.0;
  def.batter.muffle_radius = 0.1;
  return def;
}

static void run(TaborDrum *drum, double seconds) {
  float samples[480];
  float *outputs[TABOR_MAX_MICS] = {samples};
  for (int block = 0; block < (int)(seconds * 100.0); block++) {
    tabor_drum_process(drum, NULL, 0, outputs, 480);
  }
}

static double decay_rate(const TaborDrumDef *def, double *expected) {
  TaborModel *model = physics_model(def, 48000.0, TABOR_QUALITY_LIVE);
  double radial[4096], shape[4096];
  tb_model_shape(model, TABOR_HEAD_BATTER, def->batter.muffle_radius, def->batter.muffle_angle,
                 model->patches[TABOR_MAX_STRIKERS], radial, shape);
  for (uint32_t i = 0; i < model->modes.padded; i++) {
    if (model->modes.row[i] != 0) continue;
    *expected =
      model->body.modes[0].decay_rate + 0.5 * def->batter.muffle_strength * shape[i] * shape[i];
  }
  TaborDrum *drum = physics_drum(model);
  const TaborEvent strike = physics_strike(def);
  tabor_drum_process(drum, &strike, 1, NULL, 0);
  TaborLedger early, late;
  run(drum, 0.3);
  tabor_drum_ledger(drum, &early);
  run(drum, 0.1);
  tabor_drum_ledger(drum, &late);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  return log(early.stored / late.stored) / (2.0 * 0.1);
}

static void a_light_muffler_adds_its_share_to_the_decay(void **state) {
  (void)state;
  static const double STRENGTHS[] = {0.0, 0.01, 0.05};
  for (int i = 0; i < 3; i++) {
    const TaborDrumDef def = lone_mode(STRENGTHS[i]);
    double expected = NAN;
    const double measured = decay_rate(&def, &expected);
    print_message("c = %g N s/m: %.4f 1/s, expected %.4f\n", STRENGTHS[i], measured, expected);
    assert_true(fabs(measured / expected - 1.0) < 0.01);
  }
}

static void what_a_muffler_takes_is_booked_as_damper_loss(void **state) {
  (void)state;
  const TaborDrumDef def = muffled();
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent strike = physics_strike(&def);
  tabor_drum_process(drum, &strike, 1, NULL, 0);
  run(drum, 0.5);
  TaborLedger ledger;
  tabor_drum_ledger(drum, &ledger);
  print_message("damper %g J of %g J, residual %g\n", ledger.damper_loss, ledger.injected,
                ledger.residual);
  assert_true(ledger.damper_loss > 0.05 * ledger.injected);
  assert_true(fabs(ledger.residual) < 1e-9 * ledger.injected);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

/* Lifted while it rings, the muffler is as if it had not been: no more loss, no step in energy. */
static void a_lifted_muffler_takes_nothing(void **state) {
  (void)state;
  const TaborDrumDef def = muffled();
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent events[] = {physics_strike(&def),
                               {.type = TABOR_EVENT_PARAMETER,
                                .parameter = TB_PARAM_BATTER + TB_HEAD_MUFFLE_STRENGTH,
                                .value = 0.0}};
  tabor_drum_process(drum, events, 2, NULL, 0);
  run(drum, 0.02);
  TaborLedger lifted, later;
  tabor_drum_ledger(drum, &lifted);
  run(drum, 0.2);
  tabor_drum_ledger(drum, &later);
  assert_true(lifted.damper_loss > 0.0);
  assert_true(later.damper_loss == lifted.damper_loss);
  assert_true(fabs(later.residual) < 1e-9 * later.injected);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(a_light_muffler_adds_its_share_to_the_decay),
    cmocka_unit_test(what_a_muffler_takes_is_booked_as_damper_loss),
    cmocka_unit_test(a_lifted_muffler_takes_nothing),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
