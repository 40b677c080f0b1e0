/* SPDX-License-Identifier: MIT */
/* The air: matrices against values from independent quadrature, limits known in closed form, and
 * the field against a direct sum of the Rayleigh integral. */
#include <complex.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "air_model/air.h"
#include "math/bessel.h"
#include "math/quadrature.h"
#include "reference.h"

static const double PI = 3.14159265358979323846;

static TbArena scratch_arena(void) {
  const TaborAllocator system = tb_allocator_resolve(NULL);
  TbArena arena;
  tb_arena_prepare(&arena, &system);
  return arena;
}

/* Largest difference in units of the matrix's largest entry. */
static double relative_difference(const double *ours, const json_t *theirs, uint32_t n) {
  double largest = 0.0, worst = 0.0;
  for (uint32_t a = 0; a < n; a++) {
    for (uint32_t b = 0; b < n; b++) {
      const double value = reference_number(json_array_get(theirs, a), b);
      largest = fmax(largest, fabs(value));
      worst = fmax(worst, fabs(ours[a * n + b] - value));
    }
  }
  return worst / largest;
}

static void matrices_agree_with_independent_quadrature(void **state) {
  (void)state;
  json_t *root = reference_load("air_matrices.json");
  const char *order_name;
  json_t *entry;
  uint32_t checked = 0;
  json_object_foreach(json_object_get(root, "orders"), order_name, entry) {
    TbArena arena = scratch_arena();
    double zeros[4], ours[16];
    assert_int_equal(reference_vector(json_object_get(entry, "zeros"), zeros, 4), 4);
    TbAirOrder order;
    assert_true(tb_air_order_prepare(&order, &arena, (uint32_t)atoi(order_name), zeros, 4));

    assert_true(tb_air_mass_baffled(&order, &arena, ours));
    const double baffled = relative_difference(ours, json_object_get(entry, "baffled_one_side"), 4);
    tb_air_mass_open(&order, ours);
    const double open = relative_difference(ours, json_object_get(entry, "open_both_sides"), 4);
    print_message("order %s: baffled %.1e, open %.1e\n", order_name, baffled, open);
    assert_true(baffled < 1e-6);
    assert_true(open < 1e-6);

    const char *x;
    json_t *matrix;
    json_object_foreach(json_object_get(entry, "resistance"), x, matrix) {
      assert_true(tb_air_resistance_baffled(&order, &arena, atof(x), ours));
      const double resistance = relative_difference(ours, matrix, 4);
      if (resistance >= 1e-6) print_message("order %s, x %s: %.1e\n", order_name, x, resistance);
      assert_true(resistance < 1e-6);
      checked++;
    }
    tb_arena_release(&arena);
  }
  assert_int_equal(checked, 20);
  json_decref(root);
}

/* A rigid disc as a sum of modes: 1 = Sum 2/(z J_1(z)) J_0(z r), which converges slowly at the
 * edge, so the comparison takes many modes and the tolerances below are what is left of the edge.
 */
static void rigid_disc(uint32_t count, double x, TaborBoundary boundary, TbAirLoad *load) {
  TbArena arena = scratch_arena();
  double *zeros = tb_arena_doubles(&arena, count), *v = tb_arena_doubles(&arena, count);
  const uint32_t found = tb_bessel_zeros(0, PI * ((double)count + 1.0), zeros, count);
  assert_int_equal(found, count);
  for (uint32_t i = 0; i < count; i++) v[i] = 2.0 / (zeros[i] * tb_bessel_j(1, zeros[i]));
  TbAirOrder order;
  assert_true(tb_air_order_prepare(&order, &arena, 0, zeros, count));
  assert_true(tb_air_load(&order, &arena, boundary, true, v, x, NULL, 0, load, NULL));
  tb_arena_release(&arena);
}

static void open_rigid_disc_has_its_known_limits(void **state) {
  (void)state;
  const double x = 0.1;
  TbAirLoad load;
  rigid_disc(60, x, TABOR_BOUNDARY_OPEN, &load);
  /* M = 8/3 rho0 R^3 and, as for any dipole, omega^4 M^2/(12 pi rho0 c0^3) = (16/27 pi) x^4 rho0 c0
   * R^2; ours are in units of 2 pi rho0 R^3 and 2 pi rho0 c0 R^2. */
  const double mass = 8.0 / 3.0 / (2.0 * PI);
  const double resistance = 16.0 / (27.0 * PI) * pow(x, 4.0) / (2.0 * PI);
  print_message("open disc: mass %.6f of the limit, resistance %.6f\n", load.mass / mass,
                load.resistance / resistance);
  /* Next order in x and 60 modes: 1 %. */
  assert_true(fabs(load.mass / mass - 1.0) < 0.01);
  assert_true(fabs(load.resistance / resistance - 1.0) < 0.015);
}

static void baffled_rigid_piston_has_its_known_limits(void **state) {
  (void)state;
  /* One side: R = rho0 c0 A (1 - J_1(2x)/x) [FletcherRossing]; M -> 8/3 rho0 R^3 per side. */
  for (double x = 0.25; x < 5.0; x *= 2.0) {
    TbAirLoad load;
    rigid_disc(300, x, TABOR_BOUNDARY_BAFFLED, &load);
    const double resistance = PI * (1.0 - tb_bessel_j(1, 2.0 * x) / x) / (2.0 * PI);
    print_message("baffled piston, x %.2f: %.6f of Rayleigh's resistance\n", x,
                  0.5 * load.resistance / resistance);
    assert_true(fabs(0.5 * load.resistance / resistance - 1.0) < 0.004);
  }
}

static void load_at_finite_frequency_meets_the_matrices(void **state) {
  (void)state;
  for (uint32_t m = 0; m < 4; m++) {
    TbArena arena = scratch_arena();
    double zeros[3];
    const double v[3] = {0.3, -0.7, 0.2};
    const uint32_t count = tb_bessel_zeros(m, 20.0, zeros, 3);
    assert_int_equal(count, 3);
    TbAirOrder order;
    assert_true(tb_air_order_prepare(&order, &arena, m, zeros, count));
    double matrix[9];
    for (int boundary = 0; boundary < 2; boundary++) {
      if (boundary == TABOR_BOUNDARY_OPEN) {
        tb_air_mass_open(&order, matrix);
      } else {
        assert_true(tb_air_mass_baffled(&order, &arena, matrix));
      }
      double still = 0.0;
      for (uint32_t a = 0; a < count; a++) {
        for (uint32_t b = 0; b < count; b++) still += v[a] * v[b] * matrix[a * count + b];
      }
      if (boundary == TABOR_BOUNDARY_BAFFLED) still *= 2.0;
      TbAirLoad load;
      assert_true(
        tb_air_load(&order, &arena, (TaborBoundary)boundary, true, v, 0.01, NULL, 0, &load, NULL));
      assert_true(fabs(load.mass / still - 1.0) < 2e-4); /* (x/z)^2 remains */
      assert_true(load.resistance >= 0.0);
    }
    tb_arena_release(&arena);
  }
}

/* The (0,1) mode's mass grows with frequency at first: values of the design's independent
 * computation. */
static void open_mass_at_finite_frequency(void **state) {
  (void)state;
  static const double X[] = {0.5, 1.0, 2.0}, RATIO[] = {1.05, 1.21, 1.24};
  TbArena arena = scratch_arena();
  const double zero = 2.404825557695773, one = 1.0;
  TbAirOrder order;
  double still;
  assert_true(tb_air_order_prepare(&order, &arena, 0, &zero, 1));
  tb_air_mass_open(&order, &still);
  for (int i = 0; i < 3; i++) {
    TbAirLoad load;
    assert_true(
      tb_air_load(&order, &arena, TABOR_BOUNDARY_OPEN, true, &one, X[i], NULL, 0, &load, NULL));
    assert_true(fabs(load.mass / still - RATIO[i]) < 0.006);
  }
  tb_arena_release(&arena);
}

/* ---- fields ---------------------------------------------------------------------------------- */

/* One order with its first zeros, one of which moves. */
static void prepare_order(TbAirOrder *order, TbArena *arena, uint32_t m, double *zeros,
                          uint32_t count) {
  assert_int_equal(tb_bessel_zeros(m, (double)m + 4.0 * (count + 2), zeros, count), count);
  assert_true(tb_air_order_prepare(order, arena, m, zeros, count));
}

/* Pressure of the baffled shape by summing sources over the disc: p = -omega^2 rho0/(2 pi)
 * Int w e^{-i k s}/s dA, so I = (1/2 pi) Int w e^{-i x s}/s dA at angle 0. Rings by Gauss-Legendre,
 * evenly spaced spokes: for a point off the disc the integrand is smooth and periodic, and both
 * converge faster than any power. */
static double complex rayleigh(uint32_t m, double z, double x, TbAirPoint point) {
  enum { PANELS = 16, SPOKES = 512 };
  double rings[PANELS * TB_PANEL], weights[PANELS * TB_PANEL];
  tb_quadrature(0.0, 1.0, PANELS, rings, weights);
  double complex sum = 0.0;
  for (uint32_t i = 0; i < PANELS * TB_PANEL; i++) {
    const double r = rings[i], shape = weights[i] * r * tb_bessel_j(m, z * r);
    for (uint32_t k = 0; k < SPOKES; k++) {
      const double angle = 2.0 * PI * k / SPOKES;
      const double s = sqrt(r * r + point.radius * point.radius -
                            2.0 * r * point.radius * cos(angle) + point.height * point.height);
      sum += shape * cos(m * angle) * cexp(-I * x * s) / s;
    }
  }
  return sum / SPOKES;
}

/* Near points by the integral, far ones by spherical waves, with and without the table of Bessel
 * functions; within 1e-6 of the field itself. */
static void baffled_field_is_the_rayleigh_integral(void **state) {
  (void)state;
  enum { POINTS = 7, ZEROS = 3 };
  static const TbAirPoint points[POINTS] = {{0.3, 0.4}, {0.0, 2.0}, {1.5, -0.8},    {1.2, 0.15},
                                            {2.5, 0.1}, {9.0, 6.0}, {150.0, -120.0}};
  static const uint32_t ORDERS[] = {0, 1, 2, 7};
  static const double X[] = {0.4, 1.7, 9.0, 24.0};
  double worst = 0.0;
  TbArena arena = scratch_arena();
  TbBesselTable table;
  assert_true(tb_bessel_table_prepare(&table, &arena, 16, 200.0));
  for (int o = 0; o < 4; o++) {
    double zeros[ZEROS];
    TbAirOrder order;
    prepare_order(&order, &arena, ORDERS[o], zeros, ZEROS);
    for (int i = 0; i < 8; i++) {
      double v[ZEROS] = {0.0}, fields[2 * POINTS];
      v[i / 4] = 1.0;
      const double x = X[i % 4];
      order.table = i % 2 ? &table : NULL;
      TbAirLoad load;
      assert_true(tb_air_load(&order, &arena, TABOR_BOUNDARY_BAFFLED, true, v, x, points, POINTS,
                              &load, fields));
      for (uint32_t p = 0; p < POINTS; p++) {
        const double sign = points[p].height < 0.0 ? -1.0 : 1.0;
        const double complex theirs = sign * rayleigh(ORDERS[o], zeros[i / 4], x, points[p]);
        const double complex ours = fields[2 * p] + I * fields[2 * p + 1];
        const double scale = fmax(cabs(theirs), 1e-4 / hypot(points[p].radius, points[p].height));
        const double error = cabs(ours - theirs) / scale;
        if (error > 1e-6) print_message("m %u x %g p %u: %.1e\n", ORDERS[o], x, p, error);
        worst = fmax(worst, error);
      }
    }
  }
  print_message("largest difference from the sum over sources %.1e\n", worst);
  assert_true(worst < 1e-6);
  tb_arena_release(&arena);
}

/* The polynomial through the values at `count` places. */
static double complex extrapolate(int count, const double *places, const double complex *values,
                                  double at) {
  double complex sum = 0.0;
  for (int i = 0; i < count; i++) {
    double weight = 1.0;
    for (int k = 0; k < count; k++) {
      if (k != i) weight *= (at - places[k]) / (places[i] - places[k]);
    }
    sum += weight * values[i];
  }
  return sum;
}

/* Up to two radii from the centre fields come from integrals, beyond from spherical waves: what the
 * first foretell by continuation is what the second give, for both boundaries and on both sides. */
static void near_and_far_fields_meet(void **state) {
  (void)state;
  enum { INSIDE = 8, ZEROS = 5 };
  static const uint32_t ORDERS[] = {0, 1, 3, 8};
  static const double X[] = {0.3, 2.0, 8.0, 25.0}, ELEVATIONS[] = {0.2, 1.1, -0.7};
  double worst = 0.0;
  for (int o = 0; o < 4; o++) {
    TbArena arena = scratch_arena();
    double zeros[ZEROS];
    TbAirOrder order;
    prepare_order(&order, &arena, ORDERS[o], zeros, ZEROS);
    for (int i = 0; i < 4 * 3 * 2; i++) {
      const double x = X[i % 4], elevation = ELEVATIONS[i / 4 % 3];
      const TaborBoundary boundary = i / 12 ? TABOR_BOUNDARY_BAFFLED : TABOR_BOUNDARY_OPEN;
      const double v[ZEROS] = {0.3, 1.0, -0.2, 0.1, 0.0};
      double places[INSIDE + 1];
      TbAirPoint points[INSIDE + 1];
      double complex field[INSIDE + 1];
      for (int p = 0; p <= INSIDE; p++) {
        places[p] = p < INSIDE ? 1.9995 - 0.008 * p : 2.002;
        points[p] = (TbAirPoint){places[p] * cos(elevation), places[p] * sin(elevation)};
        double f[2];
        TbAirLoad load;
        assert_true(tb_air_load(&order, &arena, boundary, true, v, x, &points[p], 1, &load, f));
        field[p] = (f[0] + I * f[1]) * cexp(I * x * places[p]);
      }
      const double complex foretold = extrapolate(INSIDE, places, field, places[INSIDE]);
      const double error = cabs(foretold - field[INSIDE]) / (cabs(field[INSIDE]) + 1e-5);
      if (error > 1e-5)
        print_message("m %u x %g boundary %d elevation %g: %.1e of %.1e\n", ORDERS[o], x, boundary,
                      elevation, error, cabs(field[INSIDE]));
      worst = fmax(worst, error);
    }
    tb_arena_release(&arena);
  }
  print_message("largest gap at two radii %.1e\n", worst);
  assert_true(worst < 1e-5); /* continuing eight points by a step multiplies their errors by 255 */
}

/* The memory of a field holds its nodes: a distant point needs no more of them than one at three
 * radii. */
static void a_distant_point_takes_no_more_work(void **state) {
  (void)state;
  static const TbAirPoint NEAR = {2.0, 2.3}, DISTANT = {200.0, -200.0};
  for (int i = 0; i < 2 * 3; i++) {
    const double x = i / 2 == 0 ? 0.2 : (i / 2 == 1 ? 6.0 : 60.0);
    size_t bytes[2];
    for (int p = 0; p < 2; p++) {
      TbArena arena = scratch_arena(), scratch = scratch_arena();
      double zeros[20], v[20] = {1.0}, field[2];
      TbAirOrder order;
      TbAirLoad load;
      prepare_order(&order, &arena, 1, zeros, 20);
      assert_true(tb_air_load(&order, &scratch, (TaborBoundary)(i % 2), true, v, x,
                              p ? &DISTANT : &NEAR, 1, &load, field));
      bytes[p] = scratch.bytes;
      assert_true(isfinite(field[0]) && isfinite(field[1]) && hypot(field[0], field[1]) > 0.0);
      tb_arena_release(&scratch);
      tb_arena_release(&arena);
    }
    assert_true(bytes[1] <= bytes[0]);
  }
}

/* Far away an open head radiates what its resistance takes: the intensity over a large sphere. */
static void open_field_carries_the_radiated_power(void **state) {
  (void)state;
  enum { PANELS = 4 };
  const double distance = 1e4;
  double angles[PANELS * TB_PANEL], weights[PANELS * TB_PANEL];
  tb_quadrature(0.0, 0.5 * PI, PANELS, angles, weights);
  for (uint32_t m = 0; m < 3; m++) {
    TbArena arena = scratch_arena();
    double zeros[4];
    TbAirOrder order;
    prepare_order(&order, &arena, m, zeros, 4);
    const double v[4] = {1.0, 0.2, 0.0, 0.0}, x = 0.7 + 3.0 * m;
    TbAirLoad load;
    double power = 0.0;
    for (uint32_t i = 0; i < PANELS * TB_PANEL; i++) {
      const TbAirPoint point = {distance * sin(angles[i]), distance * cos(angles[i])};
      double f[2];
      assert_true(
        tb_air_load(&order, &arena, TABOR_BOUNDARY_OPEN, true, v, x, &point, 1, &load, f));
      /* Int |p|^2/(2 rho0 c0) over both hemispheres, per unit velocity amplitude squared, in units
       * of a_m rho0 c0 R^2/2: 2 x^2 Int |I|^2 sin d^2 dangle. */
      power += 2.0 * x * x * (f[0] * f[0] + f[1] * f[1]) * distance * distance * sin(angles[i]) *
               weights[i];
    }
    print_message("m %u: power in the field %.7f of the resistance's\n", m,
                  power / load.resistance);
    assert_true(fabs(power / load.resistance - 1.0) <
                1e-4); /* what is left of C(x), see radiation_impedance.c */
    tb_arena_release(&arena);
  }
}

/* ---- a drum ---------------------------------------------------------------------------------- */

/* Six digits are asked of a drum. */
static const double DRUM = 2e-3;

static double distance_of(const double *a, const double *b, double size) {
  return hypot(a[0] - size * b[0], a[1] - size * b[1]) / (hypot(size * b[0], size * b[1]) + 1e-6);
}

/* Two heads at one place: outwards alike they are both sides of a baffled head, against each other
 * an open one. */
static void a_flat_drum_is_a_baffled_or_an_open_head(void **state) {
  (void)state;
  for (uint32_t m = 0; m < 4; m++) {
    for (double x = 0.2; x < 20.0; x *= 3.1) {
      TbArena arena = scratch_arena();
      double zeros[6];
      TbAirOrder order;
      prepare_order(&order, &arena, m, zeros, 6);
      const double v[6] = {0.7, 1.0, 0.1, 0.0, 0.2, 0.0};
      const double opposite[6] = {-0.7, -1.0, -0.1, 0.0, -0.2, 0.0};
      const TbAirPoint points[3] = {{0.3, 0.5}, {0.6, -0.4}, {4.0, 3.0}};
      double resistance, drum[6], fields[6];
      TbAirLoad load;
      assert_true(tb_air_drum_load(&order, &arena, v, v, 0.0, x, points, 3, &resistance, drum));
      assert_true(
        tb_air_load(&order, &arena, TABOR_BOUNDARY_BAFFLED, true, v, x, points, 3, &load, fields));
      assert_true(fabs(resistance - load.resistance) <= DRUM * load.resistance);
      for (int p = 0; p < 3; p++) { /* even in the height, while both sides of one head are odd */
        const double sign = points[p].height < 0.0 ? -1.0 : 1.0;
        assert_true(distance_of(drum + 2 * p, fields + 2 * p, sign) < DRUM);
      }
      assert_true(
        tb_air_drum_load(&order, &arena, v, opposite, 0.0, x, points, 3, &resistance, drum));
      assert_true(
        tb_air_load(&order, &arena, TABOR_BOUNDARY_OPEN, true, v, x, points, 3, &load, fields));
      assert_true(fabs(resistance - load.resistance) <= DRUM * load.resistance);
      for (int p = 0; p < 3; p++) {
        assert_true(distance_of(drum + 2 * p, fields + 2 * p, 1.0) < DRUM);
      }
      tb_arena_release(&arena);
    }
  }
}

/* Far below its first wavelength one head of a drum is a monopole in free space: half of a baffled
 * side. Two that move outwards together are one of twice the strength, whatever the depth; against
 * each other nearly nothing. */
static void a_slow_drum_is_a_monopole(void **state) {
  (void)state;
  TbArena arena = scratch_arena();
  const double zero = 2.404825557695773, one = 1.0, minus = -1.0, x = 0.02;
  TbAirOrder order;
  double baffled, alone, together, against;
  assert_true(tb_air_order_prepare(&order, &arena, 0, &zero, 1));
  assert_true(tb_air_resistance_baffled(&order, &arena, x, &baffled));
  assert_true(tb_air_drum_load(&order, &arena, &one, NULL, 0.8, x, NULL, 0, &alone, NULL));
  assert_true(tb_air_drum_load(&order, &arena, &one, &one, 0.8, x, NULL, 0, &together, NULL));
  assert_true(tb_air_drum_load(&order, &arena, &one, &minus, 0.8, x, NULL, 0, &against, NULL));
  assert_true(fabs(alone / (0.5 * baffled) - 1.0) < 1e-3);
  assert_true(fabs(together / (2.0 * baffled) - 1.0) < 1e-3);
  assert_true(against > 0.0 && against < 1e-3 * together);
  tb_arena_release(&arena);
}

/* The resistance that carries the power of the drum's field, through a sphere so large that
 * p^2/(rho0 c0) is the intensity: x^2 s^2 Int |I|^2 over the cosine, in units of a_m rho0 c0 R^2.
 */
static double resistance_from_afar(const TbAirOrder *order, TbArena *arena, const double *upper,
                                   const double *lower, double depth, double x) {
  enum { PANELS = 8, POINTS = PANELS * TB_PANEL };
  const double distance = 1e6;
  double cosines[POINTS], weights[POINTS], fields[2 * POINTS], resistance, sum = 0.0;
  TbAirPoint points[POINTS];
  tb_quadrature(-1.0, 1.0, PANELS, cosines, weights);
  for (uint32_t i = 0; i < POINTS; i++) {
    points[i] = (TbAirPoint){distance * sqrt(1.0 - cosines[i] * cosines[i]), distance * cosines[i]};
  }
  assert_true(
    tb_air_drum_load(order, arena, upper, lower, depth, x, points, POINTS, &resistance, fields));
  for (uint32_t i = 0; i < POINTS; i++) {
    sum += weights[i] * (pow(fields[2 * i], 2.0) + pow(fields[2 * i + 1], 2.0));
  }
  return x * x * distance * distance * sum;
}

static void a_deep_drum_has_the_resistance_of_its_far_fields(void **state) {
  (void)state;
  for (uint32_t m = 0; m < 3; m++) {
    for (double x = 0.5; x < 9.0; x *= 2.9) {
      TbArena arena = scratch_arena();
      double zeros[5], fields[2], resistance, mirrored;
      TbAirOrder order;
      prepare_order(&order, &arena, m, zeros, 5);
      const double upper[5] = {0.7, 1.0, 0.1, 0.0, 0.0}, lower[5] = {0.5, -0.3, 0.4, 0.0, 0.0};
      const TbAirPoint point = {0.4, 0.5};
      assert_true(
        tb_air_drum_load(&order, &arena, upper, lower, 0.8, x, &point, 1, &resistance, fields));
      const double expected = resistance_from_afar(&order, &arena, upper, lower, 0.8, x);
      assert_true(fabs(resistance / expected - 1.0) < DRUM);
      /* Upside down it is the same drum. */
      const TbAirPoint below = {0.4, -0.5 - 0.8};
      double turned[2];
      assert_true(
        tb_air_drum_load(&order, &arena, lower, upper, 0.8, x, &below, 1, &mirrored, turned));
      assert_true(fabs(mirrored / resistance - 1.0) < 1e-9);
      assert_true(distance_of(turned, fields, 1.0) < 1e-6);
      tb_arena_release(&arena);
    }
  }
}

static void a_drum_never_takes_power_from_the_air(void **state) {
  (void)state;
  uint64_t seed = 7;
  for (int trial = 0; trial < 300; trial++) {
    TbArena arena = scratch_arena();
    double zeros[6], v[2][6], draws[14], resistance;
    for (int i = 0; i < 14; i++) {
      seed = seed * 6364136223846793005u + 1442695040888963407u;
      draws[i] = (double)(seed >> 11) / 9007199254740992.0;
    }
    for (int i = 0; i < 12; i++) v[i / 6][i % 6] = 2.0 * draws[i] - 1.0;
    TbAirOrder order;
    prepare_order(&order, &arena, (uint32_t)trial % 7, zeros, 6);
    const double x = 0.01 * pow(3000.0, draws[12]), depth = 3.0 * draws[13];
    assert_true(tb_air_drum_load(&order, &arena, v[0], v[1], depth, x, NULL, 0, &resistance, NULL));
    assert_true(resistance >= 0.0);
    tb_arena_release(&arena);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(matrices_agree_with_independent_quadrature),
    cmocka_unit_test(open_rigid_disc_has_its_known_limits),
    cmocka_unit_test(baffled_rigid_piston_has_its_known_limits),
    cmocka_unit_test(load_at_finite_frequency_meets_the_matrices),
    cmocka_unit_test(open_mass_at_finite_frequency),
    cmocka_unit_test(baffled_field_is_the_rayleigh_integral),
    cmocka_unit_test(near_and_far_fields_meet),
    cmocka_unit_test(a_distant_point_takes_no_more_work),
    cmocka_unit_test(open_field_carries_the_radiated_power),
    cmocka_unit_test(a_flat_drum_is_a_baffled_or_an_open_head),
    cmocka_unit_test(a_slow_drum_is_a_monopole),
    cmocka_unit_test(a_deep_drum_has_the_resistance_of_its_far_fields),
    cmocka_unit_test(a_drum_never_takes_power_from_the_air),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
