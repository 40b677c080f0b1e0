/* SPDX-License-Identifier: MIT */
/* A felt ring: its limits in closed form, and beside hands that damp along the same circle. */
#include "bodies/body.h"
#include "bodies/felt_ring.h"
#include "math/bessel.h"
#include "model/model.h"
#include "physics.h"

static const double PI = 3.14159265358979323846;

static const double STRENGTH = 0.4; /* [N s/m] */

static TaborDrumDef ringed(double radius, double width) {
  TaborDrumDef def = physics_membrane();
  def.batter.ring_radius = radius;
  def.batter.ring_width = width;
  def.batter.ring_strength = STRENGTH;
  return def;
}

/* c/(2 rho A) of an area pi R^2. */
static double everywhere(const TaborModel *model, uint32_t row) {
  (void)row;
  const double area = PI * model->def.shell.radius * model->def.shell.radius;
  return 0.5 * STRENGTH / (model->def.batter.surface_density * area);
}

/* The modes' decay rates, with and without a ring, differ by expected(model, row), within a part of
 * everywhere(). */
static void check_rates(const TaborDrumDef *def, double tolerance,
                        double (*expected)(const TaborModel *model, uint32_t row)) {
  TaborDrumDef bare = *def;
  bare.batter.ring_strength = 0.0;
  TaborModel *with = physics_model(def, 48000.0, TABOR_QUALITY_LIVE);
  TaborModel *without = physics_model(&bare, 48000.0, TABOR_QUALITY_LIVE);
  TaborModeInfo a, b;
  uint32_t row = 0;
  for (; tabor_model_mode(with, row, &a) && tabor_model_mode(without, row, &b); row++) {
    const double rate = expected(without, row);
    assert_true(a.frequency == b.frequency);
    assert_true(fabs(a.decay_rate - b.decay_rate - rate) < tolerance * everywhere(without, row));
  }
  assert_true(row > 40);
  tabor_model_release(with);
  tabor_model_release(without);
}

static void over_the_whole_head_it_is_a_loss_of_the_head(void **state) {
  (void)state;
  const TaborDrumDef disc = ringed(0.0, 0.4), wide = ringed(0.1, 0.2);
  check_rates(&disc, 1e-9, everywhere);
  check_rates(&wide, 1e-9, everywhere);
}

/* The same with air inside and outside and a rim that moves, where modes mix Bessel functions. */
static void over_the_whole_head_of_a_snare_drum(void **state) {
  (void)state;
  TaborDrumDef ring = physics_preset("snare-14x5.5"), loss;
  const double radius = ring.shell.radius;
  ring.batter.ring_strength = ring.resonant.ring_strength = 0.0;
  loss = ring;
  ring.batter.ring_radius = ring.resonant.ring_radius = 0.5 * radius;
  ring.batter.ring_width = ring.resonant.ring_width = radius;
  ring.batter.ring_strength = STRENGTH;
  ring.resonant.ring_strength = 0.1;
  const double area = PI * radius * radius;
  loss.batter.damping_0 += STRENGTH / (loss.batter.surface_density * area);
  loss.resonant.damping_0 += 0.1 / (loss.resonant.surface_density * area);
  TaborModel *a = physics_model(&ring, 48000.0, TABOR_QUALITY_DRAFT);
  TaborModel *b = physics_model(&loss, 48000.0, TABOR_QUALITY_DRAFT);
  TaborModeInfo x, y;
  uint32_t row = 0;
  for (; tabor_model_mode(a, row, &x) && tabor_model_mode(b, row, &y); row++) {
    assert_true(fabs(x.decay_rate / y.decay_rate - 1.0) < 1e-9);
  }
  assert_true(row > 40);
  tabor_model_release(a);
  tabor_model_release(b);
}

static const double PLACE = 0.12; /* [m] */

/* c phi^2/2 in the mean over the angle. */
static double on_a_circle(const TaborModel *model, uint32_t row) {
  double radial[4096];
  tb_body_radial(&model->body, 0, PLACE, NULL, radial);
  return 0.5 * STRENGTH * radial[row] * radial[row] * (model->body.modes[row].m ? 0.5 : 1.0);
}

static void a_narrow_ring_brakes_by_the_motion_at_its_place(void **state) {
  (void)state;
  TaborDrumDef def = ringed(PLACE, 0.001);
  def.quality.two_way_bandwidth = 2000.0; /* waves of 50 mm and more */
  check_rates(&def, 2e-3, on_a_circle);
}

/* By quadrature. */
static void one_function_loses_by_its_mean_square_on_the_ring(void **state) {
  (void)state;
  enum { POINTS = 2000 };
  const TaborDrumDef def = ringed(0.13, 0.05);
  const double inner = 0.105 / 0.2, outer = 0.155 / 0.2;
  static const uint32_t ORDERS[] = {0, 1, 5, 40};
  for (int i = 0; i < 4; i++) {
    const uint32_t m = ORDERS[i];
    double zeros[8], sum = 0.0;
    assert_int_equal(tb_bessel_zeros(m, 80.0, zeros, 8), 8);
    const double zero = zeros[7], slope = tb_bessel_j(m + 1, zero);
    for (int p = 0; p < POINTS; p++) {
      const double x = inner + (outer - inner) * (p + 0.5) / POINTS, j = tb_bessel_j(m, zero * x);
      sum += j * j * x * (outer - inner) / POINTS;
    }
    const double per_area = STRENGTH / (PI * 0.04 * (outer * outer - inner * inner));
    const double sigma = per_area / def.batter.surface_density * sum / (0.5 * slope * slope);
    assert_true(fabs(tb_felt_ring_sigma(&def.batter, 0.2, m, zero, slope) / sigma - 1.0) < 1e-5);
  }
}

/* What is stored when this drum has rung for 0.3 s, with so many hands along the circle of the
 * ring. */
static double stored(const TaborDrumDef *def, uint32_t hands) {
  TaborModel *model = physics_model(def, 48000.0, TABOR_QUALITY_LIVE);
  TaborDrum *drum = physics_drum(model);
  TaborEvent events[TABOR_MAX_ACTIVE] = {physics_strike(def)};
  events[0].radius = 0.1;
  for (uint32_t i = 1; i <= hands; i++) {
    events[i] = (TaborEvent){.type = TABOR_EVENT_DAMP,
                             .id = 1 + i,
                             .radius = PLACE,
                             .angle = 360.0 * i / hands,
                             .value = STRENGTH / hands};
  }
  tabor_drum_process(drum, events, 1 + hands, NULL, 14400);
  TaborLedger ledger;
  tabor_drum_ledger(drum, &ledger);
  assert_true(fabs(ledger.residual) < 1e-9 * ledger.injected);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  return ledger.stored;
}

/* Seven hands brake all pairs of order 1 to 6 alike. What rings by then are orders up to 4. */
static void it_brakes_like_hands_all_along_it(void **state) {
  (void)state;
  enum { HANDS = TABOR_MAX_ACTIVE - 1 };
  TaborDrumDef def = ringed(PLACE, 0.001);
  def.batter.damping_0 = 1.0;
  def.batter.damping_1 = 0.02;
  TaborDrumDef bare = def;
  bare.batter.ring_strength = 0.0;
  const double ring = stored(&def, 0), hands = stored(&bare, HANDS), free = stored(&bare, 0);
  print_message("stored: %g J free, %g with hands, %g with the ring\n", free, hands, ring);
  assert_true(free > 5.0 * hands);
  assert_true(fabs(log(ring / hands)) < 0.05 * log(free / hands));
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(over_the_whole_head_it_is_a_loss_of_the_head),
    cmocka_unit_test(over_the_whole_head_of_a_snare_drum),
    cmocka_unit_test(a_narrow_ring_brakes_by_the_motion_at_its_place),
    cmocka_unit_test(one_function_loses_by_its_mean_square_on_the_ring),
    cmocka_unit_test(it_brakes_like_hands_all_along_it),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
