/* SPDX-License-Identifier: MIT */
/* The air between a hi-hat's plates: its volume, plates that close at a steady speed, plates
 * without a gap, and its energy. */
#include "heads/hihat_air.h"

#include "drum/drum.h"
#include "heads/mode_force.h"
#include "physics.h"

static const double PI = 3.14159265358979323846;
static const double RATE = 48000.0;

/* Stiff plates, `gap` apart all around, the upper one bowed. */
static TaborDrumDef stiff_def(double gap) {
  TaborDrumDef def = physics_stiff_hihat();
  def.plate.bow = 0.02;
  def.hihat.opening = gap;
  return def;
}

/* pi R^2 b/2 below a bow b, pi a^2 H/3 below a bell; a tilt opens the edges by half of it. */
static void its_volume_is_that_of_domes(void **state) {
  (void)state;
  TaborDrumDef def = stiff_def(1e-3);
  def.plate.bell_radius = 0.04;
  def.plate.bell_height = 0.012;
  def.bottom.bow = 0.01;
  def.hihat.tilt = 2e-3;
  const double area = PI * 0.15 * 0.15;
  const double volume = area * (0.5 * 0.02 + 0.5 * 0.01 + 1e-3) + PI * 0.04 * 0.04 * 0.012 / 3.0;
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  const double c = def.air.sound_speed;
  const double found = def.air.density * c * c / model->hihat_air.stiffness;
  print_message("%.6f l, %.6f l expected\n", 1e3 * found, 1e3 * volume);
  assert_true(fabs(found / volume - 1.0) < 1e-5);
  tabor_model_release(model);
  def.air.density = 0.0;
  model = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  assert_true(model->hihat_air.stiffness == 0.0);
  tabor_model_release(model);
}

/* A rigid plate that rises takes its area: Sum along_i phi_i of the rigid motion. In thin air the
 * force of the rod, omega^2 times the momentum of each mode, is a rigid motion's. */
static void a_rising_plate_takes_its_area(void **state) {
  (void)state;
  TaborDrumDef def = stiff_def(1e-3);
  def.air.density = 1e-6;
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  const double omega = 2.0 * PI * def.plate.heave_frequency;
  const double area =
    tb_mode_force_along(&model->hihat_air.volume, model->rod.along) / omega / omega;
  print_message("%.6f m2, %.6f m2 expected\n", area, PI * 0.15 * 0.15);
  assert_true(fabs(area / (PI * 0.15 * 0.15) - 1.0) < 1e-4);
  tabor_model_release(model);
}

/* Moves the upper plate by a speed [m/s] in one step, and the lower one not, whatever the air does.
 */
static void move_plate(TbView *view, double speed) {
  const TbModeForce *rod = &view->model->rod;
  const double omega = 2.0 * PI * view->model->def.plate.heave_frequency;
  for (uint32_t i = 0; i < view->model->modes.padded; i++) {
    const double way = speed * rod->along[i] / (omega * omega) / RATE;
    view->next.q[i] = view->last.q[i] + 2.0 * way;
  }
}

/* Returns the pressure after `steps` steps at a speed, with what the jet and the air took of the
 * work, and that. */
static double pressure_after(TaborDrum *drum, double speed, uint32_t steps, double *taken,
                             double *work) {
  TbView view = tb_view(drum->state, drum->model);
  *taken = *work = 0.0;
  for (uint32_t i = 0; i < steps; i++) {
    move_plate(&view, speed);
    tb_hihat_air_push(&view);
    move_plate(&view, speed);
    *work -= tb_hihat_air_work(&view);
    *taken += tb_hihat_air_end(&view);
  }
  *taken += drum->state->air.energy;
  return drum->state->air.pressure;
}

/* rho (u R/(2 C h))^2/2, up or down. */
static void a_steady_jet_carries_the_flow(void **state) {
  (void)state;
  static const double gaps[] = {0.3e-3, 1e-3, 3e-3}, speeds[] = {-0.3, 0.5};
  for (uint32_t i = 0; i < 6; i++) {
    const TaborDrumDef def = stiff_def(gaps[i / 2]);
    TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
    TaborDrum *drum = physics_drum(model);
    double taken, work;
    const double found = pressure_after(drum, speeds[i % 2], 48000, &taken, &work);
    const double jet = speeds[i % 2] * 0.15 / (2.0 * PI / (PI + 2.0) * gaps[i / 2]);
    const double expected = copysign(0.5 * def.air.density * jet * jet, -speeds[i % 2]);
    print_message("%.1f mm, %.1f m/s: %.3f Pa, %.3f Pa expected\n", 1e3 * gaps[i / 2],
                  speeds[i % 2], found, expected);
    assert_true(fabs(found / expected - 1.0) < 0.03);
    assert_true(fabs(taken / work - 1.0) < 1e-9);
    tabor_drum_destroy(drum);
    tabor_model_release(model);
  }
}

/* -rho c^2 A x/V. */
static void without_a_gap_it_is_a_spring(void **state) {
  (void)state;
  const TaborDrumDef def = stiff_def(-1e-3);
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  TaborDrum *drum = physics_drum(model);
  double taken, work;
  const double way = 100 * -0.01 / RATE;
  const double found = pressure_after(drum, -0.01, 100, &taken, &work);
  const double expected = -model->hihat_air.stiffness * PI * 0.15 * 0.15 * way;
  print_message("%.4f Pa, %.4f Pa expected\n", found, expected);
  assert_true(fabs(found / expected - 1.0) < 0.01);
  assert_true(fabs(taken / work - 1.0) < 1e-9);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(its_volume_is_that_of_domes),
    cmocka_unit_test(a_rising_plate_takes_its_area),
    cmocka_unit_test(a_steady_jet_carries_the_flow),
    cmocka_unit_test(without_a_gap_it_is_a_spring),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
