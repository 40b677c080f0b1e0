/* SPDX-License-Identifier: MIT */
/* Hoop and shell that move with the heads: limits with exact solutions, positive masses, rims at
 * rest. */
#include "bodies/drum/rim.h"

#include "math/bessel.h"
#include "model/model.h"
#include "physics.h"

static const double PI = 3.14159265358979323846;

/* The mode of order m whose frequency is nearest: of the heads alone, of the rim alone, or of any
 * part. */
typedef enum Which { HEADS, RIM, ANY } Which;

static TaborModeInfo nearest_mode(const TaborModel *model, uint32_t m, double frequency,
                                  Which which) {
  TaborModeInfo nearest = {.frequency = 0.0}, mode;
  for (uint32_t row = 0; tabor_model_mode(model, row, &mode); row++) {
    if (which != ANY && (mode.part == TABOR_PART_RIM) != (which == RIM)) continue;
    if (mode.m == m && fabs(mode.frequency - frequency) < fabs(nearest.frequency - frequency)) {
      nearest = mode;
    }
  }
  return nearest;
}

static double square(double x) { return x * x; }

/* ---- a membrane on an edge that moves
 * ------------------------------------------------------------ */

/* The rim that a membrane meets: force per displacement (K - omega^2 M). */
typedef struct Edge {
  double mass, stiffness;
} Edge;

/* w = u J_m(k r)/J_m(k R) pulls the edge with -T dw/dr: (K - omega^2 M) + T a_m k R J_m'/J_m = 0,
 * times J_m, which has no poles. */
static double balance(const TaborDrumDef *def, uint32_t m, Edge edge, double frequency) {
  const double omega = 2.0 * PI * frequency, radius = def->shell.radius;
  const double x = omega * sqrt(def->batter.surface_density / def->batter.tension) * radius;
  const double j = tb_bessel_j(m, x), slope = m / x * j - tb_bessel_j(m + 1, x);
  const double azimuth = m ? PI : 2.0 * PI;
  return (edge.stiffness - omega * omega * edge.mass) * j +
         def->batter.tension * azimuth * x * slope;
}

/* Compares every root below 2 kHz with the model; returns the largest relative error. */
static double worst_root(const TaborDrumDef *def, uint32_t m, Edge edge, uint32_t *roots) {
  TaborModel *model = physics_model(def, 48000.0, TABOR_QUALITY_STUDIO);
  double worst = 0.0, before = balance(def, m, edge, 4.0);
  for (double f = 5.0; f < 2000.0; f += 1.0) {
    const double after = balance(def, m, edge, f);
    if ((before < 0.0) != (after < 0.0)) {
      double lo = f - 1.0, hi = f;
      for (int i = 0; i < 60; i++) {
        const double middle = 0.5 * (lo + hi);
        if ((balance(def, m, edge, middle) < 0.0) == (before < 0.0)) {
          lo = middle;
        } else {
          hi = middle;
        }
      }
      worst = fmax(worst, fabs(nearest_mode(model, m, lo, ANY).frequency / lo - 1.0));
      ++*roots;
    }
    before = after;
  }
  tabor_model_release(model);
  return worst;
}

/* Love's frequency of a bare shell, squared and times (2 pi)^2 [Rayleigh's form for the
 * inextensional modes that are odd along the axis]; `area`: its mass per area. */
static double love_square(const TaborShellDef *shell, double area, uint32_t n) {
  const double n2 = (double)n * n, l2 = square(0.5 * shell->depth / shell->radius);
  return shell->bending_stiffness / (area * square(square(shell->radius))) * n2 * square(n2 - 1.0) /
         (n2 + 1.0) * (1.0 + 6.0 * 0.7 / (n2 * l2)) / (1.0 + 3.0 / (n2 * (n2 + 1.0) * l2));
}

static TaborDrumDef frame(double mass) {
  TaborDrumDef def = physics_membrane();
  def.shell.depth = 0.1;
  def.shell.mass = mass;
  def.shell.bending_stiffness = 270.0;
  def.hoop.mass = 0.3;
  return def;
}

/* Shell with hoop: a shift and a tilt on the stand's spring, and Love's mode with three diameters.
 * The truncated series of the lift leaves an error that falls with the basis. */
static void a_membrane_on_a_moving_edge_has_its_exact_frequencies(void **state) {
  (void)state;
  static const double TOLERANCE[] = {1e-6, 1e-6, 1e-9, 1e-5};
  for (double mass = 0.05; mass < 10.0; mass *= 4.0) {
    const TaborDrumDef def = frame(mass);
    const double l2 = square(0.5 * def.shell.depth / def.shell.radius);
    for (uint32_t m = 0; m < 4; m += m == 1 ? 2 : 1) {
      const double n2 = (double)m * m, share = m ? 0.5 : 1.0;
      Edge edge = {.mass = share * (mass * (1.0 + (n2 * n2 + n2) * l2 / 3.0) + 0.3)};
      edge.stiffness = edge.mass * square(2.0 * PI * def.shell.stand_frequency);
      if (m > 1) {
        const double area = mass / (2.0 * PI * def.shell.radius * def.shell.depth); /* [kg/m2] */
        edge.stiffness = love_square(&def.shell, area, m) * (edge.mass - 0.3 * share);
      }
      uint32_t roots = 0;
      const double worst = worst_root(&def, m, edge, &roots);
      print_message("%.2f kg, m = %u: %u frequencies within %.1e\n", mass, m, roots, worst);
      assert_true(roots >= 5 && worst < TOLERANCE[m]);
    }
  }
}

/* ---- rims by themselves
 * -------------------------------------------------------------------------- */

/* Rayleigh's ring n (n^2-1)/sqrt(n^2+1) sqrt(EI/mu)/R^2, beside the spring that ties it to a shell
 * at rest. */
static void a_hoop_has_the_modes_of_a_free_ring(void **state) {
  (void)state;
  TaborDrumDef def = physics_membrane();
  def.hoop.mass = 0.9;
  def.hoop.bending_stiffness = 280.0;
  def.hoop.tie_frequency = 50.0;
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
  const double line = 0.9 / (2.0 * PI * def.shell.radius);
  for (uint32_t n = 2; n < TB_RIM_ORDERS; n++) {
    const double free = n * (n * n - 1.0) / sqrt(n * n + 1.0) * sqrt(280.0 / line) /
                        square(def.shell.radius) / (2.0 * PI);
    const double wanted = sqrt(free * free + 2500.0);
    if (wanted > 8000.0) break;
    const TaborModeInfo mode = nearest_mode(model, n, wanted, RIM);
    assert_int_equal(mode.part, TABOR_PART_RIM);
    assert_true(fabs(mode.frequency / wanted - 1.0) < 1e-9);
    assert_true(fabs(mode.decay_rate / (PI * (0.01 * free * free + 0.06 * 2500.0) / wanted) - 1.0) <
                1e-9);
  }
  tabor_model_release(model);
}

/* 7 mm of plywood, 14 by 5.5 inch. The thinnest heads and the lightest hoop load it by 2 %. */
static void a_shell_has_loves_frequencies(void **state) {
  (void)state;
  TaborDrumDef def = physics_membrane();
  def.two_headed = 1;
  def.shell.radius = 0.1778;
  def.shell.depth = 0.1397;
  def.batter.tension = def.resonant.tension = 100.0;
  def.batter.surface_density = def.resonant.surface_density = 0.02;
  def.shell.bending_stiffness = 8.5e9 * 343e-9 / (12.0 * 0.91);
  def.shell.mass = 2.0 * PI * 0.1778 * 0.1397 * 700.0 * 0.007;
  def.hoop.mass = 0.05;
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
  for (uint32_t n = 2; n < 5; n++) {
    const double love = sqrt(love_square(&def.shell, 4.9, n)) / (2.0 * PI);
    const double found = nearest_mode(model, n, love, RIM).frequency;
    print_message("n = %u: %.1f Hz, Love %.1f\n", n, found, love);
    assert_true(fabs(found / love - 1.0) < 0.02);
  }
  tabor_model_release(model);
}

/* What heads do to the circumference, per W^2 and stretch stiffness: by Ritz's method with
 * polynomials of degree 7 in r, in plane stress with nu = 0.3. */
static void sheets_hold_the_shell_in_shape(void **state) {
  (void)state;
  static const double RITZ[] = {0.0, 2.8710666196305293, 4.850722484061284, 6.643159465403423};
  TaborDrumDef def = frame(1.0);
  for (uint32_t n = 1; n < 5; n++) {
    TbRim bare, held;
    def.batter.stretch_stiffness = 0.0;
    tb_rim_prepare(&bare, &def, n);
    def.batter.stretch_stiffness = 1e6;
    tb_rim_prepare(&held, &def, n);
    const double out = n * n * 0.5 * def.shell.depth / def.shell.radius;
    const double found = (held.edge_stiffness - bare.edge_stiffness) / (1e6 * out * out);
    assert_true(fabs(found - RITZ[n - 1]) < 1e-9);
  }
}

/* A hoop tied ever more firmly moves with the shell, as one without stiffness of its own does. */
static void a_hoop_tied_firmly_moves_with_the_shell(void **state) {
  (void)state;
  TaborDrumDef def = frame(1.0);
  TaborModel *one = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
  def.hoop.bending_stiffness = 0.1;
  def.hoop.tie_frequency = 20000.0;
  TaborModel *two = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
  TaborModeInfo mode;
  for (uint32_t row = 0; tabor_model_mode(one, row, &mode) && mode.frequency < 1000.0; row++) {
    const double found = nearest_mode(two, mode.m, mode.frequency, ANY).frequency;
    assert_true(fabs(found / mode.frequency - 1.0) < 1e-3);
  }
  tabor_model_release(one);
  tabor_model_release(two);
}

/* Every mode moves as if the rim were at rest, to the mass ratio. */
static void a_heavy_rim_is_at_rest(void **state) {
  (void)state;
  for (uint32_t two = 0; two < 2; two++) {
    TaborDrumDef def = physics_preset(two ? "tom-12" : "frame-drum");
    def.shell.mass = 0.0;
    def.hoop.bending_stiffness = 0.0;
    TaborModel *fixed = physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT);
    def.shell.mass = 100.0;
    def.shell.bending_stiffness = 1e7;
    def.hoop.mass = 20.0;
    def.hoop.bending_stiffness = 1e6;
    def.hoop.tie_frequency = 20000.0; /* no mode of the hoop beside one of the head */
    TaborModel *heavy = physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT);
    double worst = 0.0;
    TaborModeInfo mode;
    for (uint32_t row = 0; tabor_model_mode(fixed, row, &mode); row++) {
      const TaborModeInfo other = nearest_mode(heavy, mode.m, mode.frequency, HEADS);
      worst = fmax(worst, fabs(other.frequency / mode.frequency - 1.0));
      assert_true(fabs(other.decay_rate / mode.decay_rate - 1.0) < 0.01);
    }
    print_message("%s: frequencies move by %.1e\n", def.name, worst);
    assert_true(worst < 2e-3);
    tabor_model_release(fixed);
    tabor_model_release(heavy);
  }
}

/* ---- matrices
 * ------------------------------------------------------------------------------------ */

/* The heads' mass with the lift is that of the whole shapes, so no motion has a negative one:
 * without rim or basis to speak of, too. */
static void masses_are_positive(void **state) {
  (void)state;
  TaborDrumDef def = frame(0.05);
  def.hoop.mass = 0.05;
  const TaborAllocator system = tb_allocator_resolve(NULL);
  for (uint32_t m = 0; m < TB_RIM_ORDERS; m++) {
    for (uint32_t count = 1; count < 40; count *= 3) {
      TbArena arena;
      tb_arena_prepare(&arena, &system);
      double zeros[64];
      assert_true(tb_bessel_zeros(m, PI * (count + 0.5 * m + 3.0), zeros, 64) >= count);
      TbAirOrder air;
      assert_true(tb_air_order_prepare(&air, &arena, m, zeros, count));
      TbRim rim;
      tb_rim_prepare(&rim, &def, m);
      const double missing = tb_rim_missing_mass(&rim, &air, (TbRimMotion){.edge = 1.0});
      assert_true(missing > 0.0 && missing < rim.head_mass[0] / (2.0 * m + 2.0));
      tb_arena_release(&arena);
    }
  }
}

/* Wires ride on the shell: a drum that bounces on its stand moves the whole head, and hardly the
 * head under the wires against their ends. The hoop goes along. */
static void wires_ride_on_the_shell(void **state) {
  (void)state;
  const TaborDrumDef def = physics_preset("snare-14x5.5");
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT);
  const uint32_t count = model->modes.padded;
  double *radial = calloc(model->body.row_count + 3 * count, sizeof *radial);
  double *whole = radial + model->body.row_count, *under = whole + count, *hoop = under + count;
  tb_model_shape(model, TABOR_HEAD_RESONANT, 0.0, 0.0, NULL, radial, whole);
  tb_modes_shape(&model->modes, &model->body, TABOR_HEAD_RESONANT, 0.0, 0.0, 1.0, NULL, radial,
                 under);
  tb_model_hoop_shape(model, 0.0, radial, hoop);
  uint32_t stand = 0;
  while (model->modes.row[stand] != 0) stand++;
  assert_int_equal(model->body.modes[0].part, TABOR_PART_RIM);
  assert_true(fabs(hoop[stand]) > 0.1);
  assert_true(fabs(whole[stand] / hoop[stand] - 1.0) < 0.03);
  assert_true(fabs(under[stand]) < 0.03 * fabs(hoop[stand]));
  free(radial);
  tabor_model_release(model);
}

/* Decay rate of the drum that bounces on its stand [1/s]. */
static double decay_of_bounce(uint32_t heads, double damping_k, double damping_1) {
  TaborDrumDef def = physics_membrane();
  def.shell.mass = 3.0;
  def.shell.stand_frequency = 20.0;
  def.batter.damping_k = damping_k;
  def.batter.damping_1 = damping_1;
  def.two_headed = heads == 2;
  if (heads == 2) def.resonant = def.batter;
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
  const TaborModeInfo mode = nearest_mode(model, 0, 20.0, RIM);
  assert_true(fabs(mode.frequency / 20.0 - 1.0) < 0.05);
  tabor_model_release(model);
  return mode.decay_rate;
}

/* A film that its edge carries along loses next to nothing: a head's lowest mode, of K = 12 /m,
 * would lose 6 sigma_k and 72 sigma1. A film bends by (20 Hz/206 Hz)^2, 1 %, of its motion, and has
 * 1 % of the mass, which leaves a millionth of that. */
static void a_film_that_is_carried_along_loses_nothing(void **state) {
  (void)state;
  for (uint32_t heads = 1; heads <= 2; heads++) {
    const double bare = decay_of_bounce(heads, 0.0, 0.0);
    const double linear = decay_of_bounce(heads, 1.0, 0.0) - bare;
    const double square = decay_of_bounce(heads, 0.0, 0.1) - bare;
    print_message("%u heads: %.2e and %.2e 1/s\n", heads, linear, square);
    assert_true(linear > 0.0 && linear < heads * 6e-6);
    assert_true(square > 0.0 && square < heads * 7.2e-6);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(a_membrane_on_a_moving_edge_has_its_exact_frequencies),
    cmocka_unit_test(a_hoop_has_the_modes_of_a_free_ring),
    cmocka_unit_test(a_shell_has_loves_frequencies),
    cmocka_unit_test(sheets_hold_the_shell_in_shape),
    cmocka_unit_test(a_hoop_tied_firmly_moves_with_the_shell),
    cmocka_unit_test(a_heavy_rim_is_at_rest),
    cmocka_unit_test(masses_are_positive),
    cmocka_unit_test(wires_ride_on_the_shell),
    cmocka_unit_test(a_film_that_is_carried_along_loses_nothing),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
