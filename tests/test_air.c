/* SPDX-License-Identifier: MIT */
/* The air: matrices against values from independent quadrature, limits known in closed form, and the
 * field against a direct sum of the Rayleigh integral. */
#include <complex.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "air.h"
#include "bessel.h"
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

/* A rigid disc as a sum of modes: 1 = Sum 2/(z J_1(z)) J_0(z r), which converges slowly at the edge,
 * so the comparison takes many modes
 * and the tolerances below are what is left of the edge. */
static void rigid_disc(uint32_t count, double x, TaborBoundary boundary, TbAirLoad *load) {
  TbArena arena = scratch_arena();
  double *zeros = tb_arena_doubles(&arena, count), *v = tb_arena_doubles(&arena, count);
  const uint32_t found = tb_bessel_zeros(0, PI * ((double)count + 1.0), NULL, 0, zeros, count);
  assert_int_equal(found, count);
  for (uint32_t i = 0; i < count; i++) v[i] = 2.0 / (zeros[i] * tb_bessel_j(1, zeros[i]));
  TbAirOrder order;
  assert_true(tb_air_order_prepare(&order, &arena, 0, zeros, count));
  assert_true(tb_air_load(&order, &arena, boundary, v, x, NULL, 0, load, NULL));
  tb_arena_release(&arena);
}

static void open_rigid_disc_has_its_known_limits(void **state) {
  (void)state;
  const double x = 0.1;
  TbAirLoad load;
  rigid_disc(60, x, TABOR_BOUNDARY_OPEN, &load);
  /* M = 8/3 rho0 R^3 and, as for any dipole, omega^4 M^2/(12 pi rho0 c0^3) = (16/27 pi) x^4 rho0 c0 R^2;
   * ours are in units of 2 pi rho0 R^3 and 2 pi rho0 c0 R^2. */
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
    double below[8], zeros[8];
    uint32_t count = tb_bessel_zeros(0, 20.0, NULL, 0, below, 8);
    for (uint32_t o = 1; o <= m; o++) {
      memcpy(zeros, below, sizeof zeros);
      count = tb_bessel_zeros(o, 20.0, zeros, count, below, 8);
    }
    const double v[8] = {0.3, -0.7, 0.2};
    count = 3;
    TbAirOrder order;
    assert_true(tb_air_order_prepare(&order, &arena, m, below, count));
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
        tb_air_load(&order, &arena, (TaborBoundary)boundary, v, 0.01, NULL, 0, &load, NULL));
      assert_true(fabs(load.mass / still - 1.0) < 2e-4); /* (x/z)^2 remains */
      assert_true(load.resistance >= 0.0);
    }
    tb_arena_release(&arena);
  }
}

/* Pressure of the baffled shape by summing sources over the disc: p = -omega^2 rho0/(2 pi)
 * Int w e^{-i k s}/s dA, so I = (1/2 pi) Int w e^{-i x s}/s dA at angle 0. */
static double complex rayleigh(uint32_t m, double z, double x, TbAirPoint point) {
  const uint32_t rings = 400, spokes = 400;
  double complex sum = 0.0;
  for (uint32_t i = 0; i < rings; i++) {
    const double r = (i + 0.5) / rings;
    const double shape = tb_bessel_j(m, z * r);
    for (uint32_t k = 0; k < spokes; k++) {
      const double angle = 2.0 * PI * k / spokes;
      const double s = sqrt(r * r + point.radius * point.radius -
                            2.0 * r * point.radius * cos(angle) + point.height * point.height);
      sum += shape * cos(m * angle) * cexp(-I * x * s) / s * r;
    }
  }
  return sum * (2.0 * PI / spokes) / rings / (2.0 * PI);
}

static void baffled_field_is_the_rayleigh_integral(void **state) {
  (void)state;
  const TbAirPoint points[3] = {{0.3, 0.4}, {0.0, 2.0}, {1.5, -0.8}};
  for (uint32_t m = 0; m < 3; m++) {
    TbArena arena = scratch_arena();
    double below[8], zeros[8];
    uint32_t count = tb_bessel_zeros(0, 12.0, NULL, 0, zeros, 8);
    for (uint32_t o = 1; o <= m; o++) {
      memcpy(below, zeros, sizeof zeros);
      count = tb_bessel_zeros(o, 12.0, below, count, zeros, 8);
    }
    TbAirOrder order;
    assert_true(tb_air_order_prepare(&order, &arena, m, zeros, count));
    for (uint32_t i = 0; i < count; i++) {
      double v[8] = {0.0}, fields[6];
      v[i] = 1.0;
      TbAirLoad load;
      assert_true(
        tb_air_load(&order, &arena, TABOR_BOUNDARY_BAFFLED, v, 1.7, points, 3, &load, fields));
      for (uint32_t p = 0; p < 3; p++) {
        const double sign = points[p].height < 0.0 ? -1.0 : 1.0;
        const double complex theirs = sign * rayleigh(m, zeros[i], 1.7, points[p]);
        const double complex ours = fields[2 * p] + I * fields[2 * p + 1];
        /* The sum over 400 rings is good to about 1e-6 of the largest mode's field. */
        if (cabs(ours - theirs) > 3e-6) {
          print_message("m %u i %u p %u: %g%+gi, sum %g%+gi\n", m, i, p, creal(ours), cimag(ours),
                        creal(theirs), cimag(theirs));
        }
        assert_true(cabs(ours - theirs) < 3e-6);
      }
    }
    tb_arena_release(&arena);
  }
}

/* Far away an open head radiates what its resistance takes: the intensity over a large sphere. */
static void open_field_carries_the_radiated_power(void **state) {
  (void)state;
  const double x = 1.2, distance = 60.0;
  for (uint32_t m = 0; m < 2; m++) {
    TbArena arena = scratch_arena();
    double below[4], zeros[4];
    uint32_t count = tb_bessel_zeros(0, 8.0, NULL, 0, below, 4);
    if (m) count = tb_bessel_zeros(1, 8.0, below, count, zeros, 4);
    TbAirOrder order;
    assert_true(tb_air_order_prepare(&order, &arena, m, m ? zeros : below, count));
    const double v[4] = {1.0, 0.2};
    TbAirLoad load;
    double power = 0.0;
    const uint32_t steps = 90;
    for (uint32_t i = 0; i < steps; i++) {
      const double angle = (i + 0.5) * 0.5 * PI / steps;
      const TbAirPoint point = {distance * sin(angle), distance * cos(angle)};
      double f[2];
      assert_true(tb_air_load(&order, &arena, TABOR_BOUNDARY_OPEN, v, x, &point, 1, &load, f));
      /* Int |p|^2/(2 rho0 c0) over both hemispheres, per unit velocity amplitude squared, in units
       * of a_m rho0 c0 R^2/2: 2 x^2 Int |I|^2 sin d^2 dangle. */
      power += 2.0 * x * x * (f[0] * f[0] + f[1] * f[1]) * distance * distance * sin(angle) *
               (0.5 * PI / steps);
    }
    print_message("m %u: power in the field %.5f of the resistance's\n", m,
                  power / load.resistance);
    assert_true(fabs(power / load.resistance - 1.0) < 5e-3);
    tb_arena_release(&arena);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(matrices_agree_with_independent_quadrature),
    cmocka_unit_test(open_rigid_disc_has_its_known_limits),
    cmocka_unit_test(baffled_rigid_piston_has_its_known_limits),
    cmocka_unit_test(load_at_finite_frequency_meets_the_matrices),
    cmocka_unit_test(baffled_field_is_the_rayleigh_integral),
    cmocka_unit_test(open_field_carries_the_radiated_power),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
