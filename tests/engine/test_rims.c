/* SPDX-License-Identifier: MIT */
/* A hi-hat at rest: its edges carry the force of the rod, as springs in series do; open, they carry
 * none. */
#include "bodies/plate/plate_modes.h"
#include "drum/drum.h"
#include "model/model.h"
#include "physics.h"

static const double PI = 3.14159265358979323846;

/* On soft mounts, in a vacuum. */
static TaborDrumDef stiff_def(void) {
  TaborDrumDef def = physics_stiff_hihat();
  def.plate.heave_frequency = 6.0;
  def.bottom.heave_frequency = 9.0;
  def.hihat.opening = -2e-3;
  def.hihat.contact_stiffness = 1e12;
  def.air.density = 0.0;
  return def;
}

/* k of the mount [N/m]. */
static double mount_stiffness(const TaborDrumDef *def, const TaborPlateDef *plate) {
  const double mass =
    plate->density * plate->thickness * PI * def->shell.radius * def->shell.radius;
  const double omega = 2.0 * PI * plate->heave_frequency;
  return mass * omega * omega;
}

static double edges_force(const TaborModel *model, double *least, double *most) {
  double sum = 0.0;
  *least = INFINITY;
  *most = 0.0;
  for (uint32_t row = 0; row < model->def.hihat.points; row++) {
    sum += model->rest.force[row];
    *least = fmin(*least, model->rest.force[row]);
    *most = fmax(*most, model->rest.force[row]);
  }
  return sum;
}

/* F = z k k'/(k + k') of the rod's way z past contact, in equal parts at all places. */
static void pressed_edges_are_springs_in_series(void **state) {
  (void)state;
  static const uint32_t points[] = {4, 16, 17, 64};
  for (uint32_t i = 0; i < sizeof points / sizeof *points; i++) {
    TaborDrumDef def = stiff_def();
    def.hihat.points = points[i];
    TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
    const double upper = mount_stiffness(&def, &def.plate);
    const double lower = mount_stiffness(&def, &def.bottom);
    const double expected = -def.hihat.opening * upper * lower / (upper + lower);
    double least, most;
    const double found = edges_force(model, &least, &most);
    print_message("%u places: %.5f N, %.5f expected\n", points[i], found, expected);
    assert_true(fabs(found / expected - 1.0) < 3e-3);
    assert_true(most - least < 1e-4 * most);
    assert_int_equal(model->wires.contact_points, points[i]);
    tabor_model_release(model);
  }
}

static void open_edges_carry_nothing(void **state) {
  (void)state;
  TaborDrumDef def = stiff_def();
  def.hihat.opening = 5e-3;
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
  double least, most;
  assert_true(edges_force(model, &least, &most) == 0.0);
  for (uint32_t row = 0; row < def.hihat.points; row++) {
    assert_true(fabs(model->rest.eta[row] + 5e-3) < 1e-5);
  }
  tabor_model_release(model);
}

/* The gap is least at the angle 0 from the model's axis, and wider by the tilt opposite. */
static void a_tilt_opens_one_side(void **state) {
  (void)state;
  TaborDrumDef def = stiff_def();
  def.hihat.opening = 5e-3;
  def.hihat.tilt = 2e-3;
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
  const double *eta = model->rest.eta;
  assert_true(fabs(eta[0] + 5e-3) < 1e-5 && fabs(eta[8] + 7e-3) < 1e-5);
  assert_true(fabs(eta[4] - 0.5 * (eta[0] + eta[8])) < 1e-5);
  tabor_model_release(model);
}

/* Modes of the upper plate alone are those of a plate, and each moves one edge alone. */
static void each_plate_has_its_own_modes(void **state) {
  (void)state;
  TaborDrumDef def = stiff_def(), alone = def;
  alone.body.kind = TABOR_BODY_PLATE;
  TaborModel *both = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
  TaborModel *one = physics_model(&alone, 48000.0, TABOR_QUALITY_LIVE);
  uint32_t upper = 0, lower = 0;
  TaborModeInfo mode, own;
  for (uint32_t row = 0; tabor_model_mode(both, row, &mode); row++) {
    const TbBodyMode *m = &both->body.modes[row];
    const TbBodyOrder *order = &both->body.orders[m->m];
    const bool is_upper = mode.part == TABOR_PART_PLATE;
    assert_true(order->edge[is_upper ? 1 : 0][m->place] == 0.0);
    assert_true(order->edge[is_upper ? 0 : 1][m->place] != 0.0);
    lower += !is_upper;
    if (!is_upper) continue;
    assert_true(tabor_model_mode(one, upper++, &own));
    assert_true(fabs(own.frequency / mode.frequency - 1.0) < 1e-9);
  }
  assert_true(upper > 10 && lower > 10);
  assert_false(tabor_model_mode(one, upper, &own));
  tabor_model_release(both);
  tabor_model_release(one);
}

/* Without a pedal nobody stamps; a hi-hat has no wires to pluck. */
static void drums_without_a_pedal_refuse_it(void **state) {
  (void)state;
  TaborDrumDef def;
  TaborError error;
  tabor_drum_def_default(&def);
  def.strike.technique = TABOR_TECHNIQUE_PEDAL;
  assert_int_equal(tabor_drum_def_validate(&def, &error), TABOR_ERROR_RANGE);
  assert_string_equal(error.key, "strike.technique");
  def = stiff_def();
  def.wires.count = 1;
  assert_int_equal(tabor_drum_def_validate(&def, &error), TABOR_ERROR_RANGE);
  assert_string_equal(error.key, "wires.count");
  def = stiff_def();
  def.bottom.flange_slope = 0.1;
  def.bottom.flange_width = 0.2;
  assert_int_equal(tabor_drum_def_validate(&def, &error), TABOR_ERROR_RANGE);
  assert_string_equal(error.key, "bottom.flange_width");
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(pressed_edges_are_springs_in_series),
    cmocka_unit_test(open_edges_carry_nothing),
    cmocka_unit_test(a_tilt_opens_one_side),
    cmocka_unit_test(each_plate_has_its_own_modes),
    cmocka_unit_test(drums_without_a_pedal_refuse_it),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
