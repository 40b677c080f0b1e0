/* SPDX-License-Identifier: MIT */
/* Heads that stretch: the frequency rises with amplitude as Duffing's oscillator has it, energy stays.
 *
 * usage: test_system_stretch [brief]: one mode at one amplitude. */
#include "physics.h"

#include "drum/drum.h"
#include "step/stretch.h"

static const double PI = 3.14159265358979323846;
static const double RATE = 192000.0;
static bool brief;

static TaborDrumDef one_head(double stretch) {
  TaborDrumDef def = physics_preset("frame-drum");
  def.quality.losses = 0;
  def.air.gravity = 0.0;
  def.batter.stretch_stiffness = stretch;
  def.quality.two_way_bandwidth = 2000.0;
  return def;
}

/* Frequency [rad/s] at which mode `index` alone swings with this amplitude, from its zero crossings. */
static double swing(const TaborModel *model, TaborDrum *drum, uint32_t index, double amplitude) {
  TbView view = tb_view(drum->state, model);
  view.now.q[index] = view.last.q[index] = amplitude;
  view.state->asleep = 0;
  double first = 0.0, last = 0.0, before = amplitude;
  uint32_t crossings = 0;
  for (uint32_t n = 1; n < 40000; n++) {
    tabor_drum_process(drum, NULL, 0, NULL, 1);
    view = tb_view(drum->state, model);
    const double q = view.now.q[index];
    if (before > 0.0 && q <= 0.0) {
      last = (double)n - q / (q - before);
      if (crossings++ == 0) first = last;
    }
    before = q;
  }
  return 2.0 * PI * (double)(crossings - 1) / ((last - first) / RATE);
}

/* q'' + w^2 q + beta q^3 = 0, beta = S G^2/(2A): w_nl/w = 1 + 3e/8 - 21 e^2/256, e = beta a^2/w^2
 * (Lindstedt and Poincare). */
static void one_mode_swings_like_duffings_oscillator(void **state) {
  (void)state;
  const TaborDrumDef def = one_head(1e6);
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_LIVE);
  for (uint32_t i = 0; i < model->modes.padded; i += 7) {
    if (model->modes.row[i] == TB_NO_MODE || model->modes.row[i] > 9) continue;
    const TbHeadMode *mode = &model->head.modes[model->modes.row[i]];
    const double gain = model->stretch.gain[0][i];
    const double beta = model->stretch.factor[0] * gain * gain;
    for (double e = 0.02; e < 0.3; e *= 2.0) {
      const double amplitude = sqrt(e) * mode->omega / sqrt(beta);
      TaborDrum *drum = physics_drum(model);
      const double ratio = swing(model, drum, i, amplitude) / mode->omega;
      tabor_drum_destroy(drum);
      const double expected = 1.0 + 3.0 * e / 8.0 - 21.0 * e * e / 256.0;
      print_message("(%u,%u) e %.2f: %.5f, expected %.5f\n", mode->m, mode->n, e, ratio, expected);
      assert_true(fabs(ratio - expected) < 2e-4 + 0.1 * e * e * e);
      if (brief) break;
    }
    if (brief) break;
  }
  tabor_model_release(model);
}

/* G of a lone Bessel function in vacuo: Int |grad w|^2 dA = K^2 Int w^2 dA = K^2/rho at unit mass. */
static void the_gain_of_a_mode_is_its_wavenumber_squared(void **state) {
  (void)state;
  TaborDrumDef def = one_head(1e6);
  def.air.density = 0.0;
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_LIVE);
  for (uint32_t i = 0; i < model->modes.padded; i++) {
    if (model->modes.row[i] == TB_NO_MODE) continue;
    const TbHeadMode *mode = &model->head.modes[model->modes.row[i]];
    if (mode->omega > 12.0 * model->head.modes[0].omega) continue; /* does not count */
    const double k = model->head.orders[mode->m].zeros[mode->n - 1] / def.shell.radius;
    assert_true(fabs(model->stretch.gain[0][i] * def.batter.surface_density / (k * k) - 1.0) <
                1e-9);
  }
  tabor_model_release(model);
}

/* The ledger closes to rounding. */
static void check_balance(const TaborDrum *drum) {
  TaborLedger ledger;
  tabor_drum_ledger(drum, &ledger);
  print_message("residual %g J of %g J\n", ledger.residual, ledger.injected);
  assert_true(fabs(ledger.residual) < 1e-11 * ledger.injected);
}

/* Struck hard, two heads, wires and all: a lossless drum keeps its energy to rounding. */
static void a_struck_drum_that_stretches_keeps_its_energy(void **state) {
  (void)state;
  TaborDrumDef def = physics_preset("tabor");
  def.quality.losses = 0;
  def.batter.tension = 1500.0;
  def.batter.stretch_stiffness = 1.2e6;
  TaborError error;
  assert_int_equal(tabor_drum_def_set(&def, "resonant.stretch_stiffness", "4e5", &error), TABOR_OK);
  def.shell.depth = 0.1;
  def.wires.head = TABOR_HEAD_RESONANT;
  def.wires.side = TABOR_SIDE_BELOW;
  def.quality.two_way_bandwidth = 2500.0;
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_STUDIO);
  TaborDrum *drum = physics_drum(model);
  TaborEvent strike = physics_strike(&def);
  strike.velocity = 12.0;
  tabor_drum_process(drum, &strike, 1, NULL, 0);
  for (int block = 0; block < 100; block++) tabor_drum_process(drum, NULL, 0, NULL, 480);
  check_balance(drum);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

/* Live stops the contact solve early and moves the forces to an exact balance: along the response of the
 * last forces, which a stretch that changes from sample to sample makes another. Hard strokes one upon the
 * other at a low rate, where it changes most. */
static void an_early_end_of_the_solve_knows_the_stretch(void **state) {
  (void)state;
  TaborDrumDef def = one_head(1e6);
  def.quality.losses = 1;
  TaborModel *model = physics_model(&def, 22050.0, TABOR_QUALITY_LIVE);
  TaborDrum *drum = physics_drum(model);
  TaborEvent strike = physics_strike(&def);
  for (int i = 0; i < 12; i++) {
    strike.velocity = 3.0 + 2.0 * i;
    strike.radius = 0.01 * i;
    tabor_drum_process(drum, &strike, 1, NULL, 380);
  }
  check_balance(drum);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

int main(int argc, char **argv) {
  brief = argc > 1 && strcmp(argv[1], "brief") == 0;
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(one_mode_swings_like_duffings_oscillator),
    cmocka_unit_test(the_gain_of_a_mode_is_its_wavenumber_squared),
    cmocka_unit_test(a_struck_drum_that_stretches_keeps_its_energy),
    cmocka_unit_test(an_early_end_of_the_solve_knows_the_stretch),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
