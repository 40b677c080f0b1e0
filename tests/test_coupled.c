/* SPDX-License-Identifier: MIT */
/* Two heads and the air between them, against an independent computation and closed forms. */
#include "physics.h"

#include <jansson.h>

#include "bessel.h"
#include "coupled.h"

static const double PI = 3.14159265358979323846;

/* Frequencies [Hz] of one order; the basis reaches `basis` zeros, the cavity keeps modes to `top`. */
static void frequencies(const TbCoupled *drum, uint32_t m, uint32_t basis, double top_hz,
                        uint32_t count, double *hz) {
  TaborAllocator allocator = tb_allocator_resolve(&(TaborAllocator){0});
  TbArena arena;
  tb_arena_prepare(&arena, &allocator);
  double zeros[64];
  const double top = PI * (basis + 0.5 * m + 1.0);
  assert_true(tb_bessel_zeros(m, top, zeros, 64) >= basis);
  TbAirOrder air;
  TbCavityOrder cavity;
  assert_true(tb_air_order_prepare(&air, &arena, m, zeros, basis));
  assert_true(
    tb_cavity_order_prepare(&cavity, &arena, &drum->cavity, m, 3.0 * top, 2.0 * PI * top_hz));
  const uint32_t size = tb_coupled_size(&cavity, drum, &air);
  double *values = tb_arena_doubles(&arena, size);
  double *vectors = tb_arena_doubles(&arena, (size_t)size * size);
  assert_int_equal(tb_coupled_solve(drum, &arena, &air, &cavity, values, vectors), TABOR_OK);
  for (uint32_t i = 0; i < count; i++) hz[i] = sqrt(values[i]) / (2.0 * PI);
  tb_arena_release(&arena);
}

static TaborHeadDef head_of(const json_t *rho_t_d) {
  return (TaborHeadDef){.surface_density = json_number_value(json_array_get(rho_t_d, 0)),
                        .tension = json_number_value(json_array_get(rho_t_d, 1)),
                        .bending_stiffness = json_number_value(json_array_get(rho_t_d, 2))};
}

/* Design of the reference: 24 functions per head, cavity modes below 12 kHz, by quadrature. */
static void coupled_drums_agree_with_the_reference(void **state) {
  (void)state;
  json_t *root = json_load_file(TABOR_TEST_DATA "/reference/coupled_drums.json", 0, NULL);
  assert_non_null(root);
  const char *name;
  json_t *one;
  json_object_foreach(json_object_get(root, "cases"), name, one) {
    const TaborHeadDef batter = head_of(json_object_get(one, "batter_rho_T_D"));
    const TaborHeadDef resonant = head_of(json_object_get(one, "resonant_rho_T_D"));
    const TbCoupled drum = {.cavity = {.radius = json_number_value(json_object_get(one, "radius")),
                                       .depth = json_number_value(json_object_get(one, "depth")),
                                       .density = 1.205,
                                       .sound_speed = 343.0,
                                       .heads = 2},
                            .heads = {&batter, &resonant},
                            .outside = 1.205};
    double worst = 0.0;
    for (uint32_t m = 0; m < 4; m++) {
      char key[4];
      snprintf(key, sizeof key, "%u", m);
      const json_t *wanted = json_object_get(json_object_get(one, "hz"), key);
      double hz[6];
      frequencies(&drum, m, 24, 12000.0, 6, hz);
      for (uint32_t i = 0; i < 6; i++) {
        worst = fmax(worst, fabs(hz[i] / json_number_value(json_array_get(wanted, i)) - 1.0));
      }
    }
    print_message("%s: within %.2g\n", name, worst);
    assert_true(worst < 2e-4);
  }
  json_decref(root);
}

/* With rho0 -> 0 at the same rho0 c0^2 the pressure is uniform: the cavity is a spring that the (0,1)
 * mode feels, J_0(ka) = -B J_2(ka)/(ka)^2, B = rho0 c0^2 pi a^4/(T V) [Morse1948]. */
static void a_closed_cavity_of_uniform_pressure_stiffens_the_first_mode(void **state) {
  (void)state;
  static const double B[] = {1.0, 2.0, 5.0, 10.0}, KA[] = {2.5437, 2.6736, 3.0197, 3.4874};
  const double radius = 0.3, tension = 3000.0, density = 0.26;
  const TaborHeadDef head = {.tension = tension, .surface_density = density};
  for (uint32_t i = 0; i < 4; i++) {
    const double bulk = 1.205 * 343.0 * 343.0, thin = 1e-9;
    const double depth = bulk * radius * radius / (tension * B[i]); /* B = bulk a^2/(T L) */
    const TbCoupled drum = {.cavity = {.radius = radius,
                                       .depth = depth,
                                       .density = thin,
                                       .sound_speed = sqrt(bulk / thin),
                                       .heads = 1},
                            .heads = {&head, NULL}};
    double hz;
    frequencies(&drum, 0, 30, 12000.0, 1, &hz);
    const double ka = 2.0 * PI * hz * radius * sqrt(density / tension);
    print_message("B = %g: ka = %.4f\n", B[i], ka);
    assert_true(fabs(ka / KA[i] - 1.0) < 1e-3);
  }
}

/* What is left out as coordinates acts as mass. With the cavity's modes kept to 3 times the highest of the
 * frequencies compared they are off by 0.3 % at most, to 1.5 times by 1.1 %. */
static void a_few_cavity_coordinates_are_enough(void **state) {
  (void)state;
  const TaborHeadDef batter = {.surface_density = 0.353, .tension = 4200.0};
  const TaborHeadDef resonant = {.surface_density = 0.106, .tension = 2600.0};
  const TbCoupled drum = {.cavity = {.radius = 0.1651,
                                     .depth = 0.1016,
                                     .density = 1.205,
                                     .sound_speed = 343.0,
                                     .heads = 2},
                          .heads = {&batter, &resonant},
                          .outside = 1.205};
  for (uint32_t m = 0; m < 4; m++) {
    double all[4], some[4], few[4];
    frequencies(&drum, m, 24, 16000.0, 4, all);
    frequencies(&drum, m, 24, 3.0 * all[3], 4, some);
    frequencies(&drum, m, 24, 1.5 * all[3], 4, few);
    for (uint32_t i = 0; i < 4; i++) {
      assert_true(fabs(some[i] / all[i] - 1.0) < 4e-3);
      assert_true(fabs(few[i] / all[i] - 1.0) < 1.5e-2);
    }
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(coupled_drums_agree_with_the_reference),
    cmocka_unit_test(a_closed_cavity_of_uniform_pressure_stiffens_the_first_mode),
    cmocka_unit_test(a_few_cavity_coordinates_are_enough),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
