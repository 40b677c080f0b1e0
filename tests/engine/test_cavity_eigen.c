/* SPDX-License-Identifier: MIT */
/* Two heads and the air between them, against an independent computation and closed forms. */
#include "physics.h"

#include <jansson.h>

#include "bodies/drum/cavity_eigen.h"
#include "math/bessel.h"

static const double PI = 3.14159265358979323846;

/* Frequencies [Hz] of one order; the basis reaches `basis` zeros, the cavity keeps modes to `top`.
 * Outside each head carries half of the open head's mass, as in the reference. */
static void frequencies(const TbCavityEigen *drum, uint32_t m, uint32_t basis, double top_hz,
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
  const uint32_t size = tb_cavity_eigen_size(&cavity, drum, &air);
  double *values = tb_arena_doubles(&arena, size);
  double *vectors = tb_arena_doubles(&arena, (size_t)size * size);
  double *own = tb_arena_doubles(&arena, (size_t)basis * basis);
  tb_air_mass_open(&air, own);
  for (uint32_t i = 0; i < basis * basis; i++) own[i] *= 0.5;
  TbCavityEigen loaded = *drum;
  loaded.own = own;
  assert_int_equal(tb_cavity_eigen_solve(&loaded, &arena, &air, &cavity, values, vectors),
                   TABOR_OK);
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
    const TbCavityEigen drum = {
      .cavity = {.radius = json_number_value(json_object_get(one, "radius")),
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

/* With rho0 -> 0 at the same rho0 c0^2 the pressure is uniform: the cavity is a spring that the
 * (0,1) mode feels, J_0(ka) = -B J_2(ka)/(ka)^2, B = rho0 c0^2 pi a^4/(T V) [Morse1948]. */
static void a_closed_cavity_of_uniform_pressure_stiffens_the_first_mode(void **state) {
  (void)state;
  static const double B[] = {1.0, 2.0, 5.0, 10.0}, KA[] = {2.5437, 2.6736, 3.0197, 3.4874};
  const double radius = 0.3, tension = 3000.0, density = 0.26;
  const TaborHeadDef head = {.tension = tension, .surface_density = density};
  for (uint32_t i = 0; i < 4; i++) {
    const double bulk = 1.205 * 343.0 * 343.0, thin = 1e-9;
    const double depth = bulk * radius * radius / (tension * B[i]); /* B = bulk a^2/(T L) */
    const TbCavityEigen drum = {.cavity = {.radius = radius,
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

/* What is left out as coordinates acts as mass. With the cavity's modes kept to 3 times the highest
 * of the frequencies compared they are off by 0.3 % at most, to 1.5 times by 1.1 %. */
static void a_few_cavity_coordinates_are_enough(void **state) {
  (void)state;
  const TaborHeadDef batter = {.surface_density = 0.353, .tension = 4200.0};
  const TaborHeadDef resonant = {.surface_density = 0.106, .tension = 2600.0};
  const TbCavityEigen drum = {.cavity = {.radius = 0.1651,
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

/* ---- walls ---------------------------------------------------------------------------------- */

static const double NU = 1.5e-5,
                    HEAT_CONDUCTION = 0.4 / 0.84261; /* (gamma - 1)/sqrt(Pr), Pr 0.71 */

typedef struct Walls {
  TbArena arena;
  double zeros[64];
  TbAirOrder air;
  TbCavityOrder order;
} Walls;

static void walls_prepare(Walls *walls, const TbCavity *cavity, uint32_t m, double top) {
  TaborAllocator allocator = tb_allocator_resolve(&(TaborAllocator){0});
  tb_arena_prepare(&walls->arena, &allocator);
  const double reach = top * cavity->radius / cavity->sound_speed + PI;
  const uint32_t count = tb_bessel_zeros(m, fmax(reach, m + 12.0), walls->zeros, 64);
  assert_true(count > 0);
  assert_true(tb_air_order_prepare(&walls->air, &walls->arena, m, walls->zeros, count));
  assert_true(tb_cavity_order_prepare(&walls->order, &walls->arena, cavity, m, reach + PI, top));
}

/* Amplitude decay rate [1/s] of one rigid mode, P/(2E), which the mode by itself has too. */
static double wall_rate(const Walls *walls, const TbCavity *cavity, uint32_t mode) {
  double heads[128] = {0.0}, u[256] = {0.0};
  assert_true(walls->order.mode_count <= 256 && 2 * walls->air.count <= 128);
  u[mode] = 1.0;
  const TbCavityMode *m = &walls->order.modes[mode];
  const double rate = tb_cavity_wall_power(&walls->order, cavity, &walls->air, heads, u, m->omega) /
                      (m->omega * m->omega);
  const double alone = tb_cavity_mode_decay_rate(&walls->order, cavity, m->radial, m->axial);
  assert_true(fabs(alone / rate - 1.0) < 1e-12);
  return rate;
}

/* Plane waves in a long rigid tube: Kirchhoff's s = sqrt(nu omega/2) (1 + (gamma - 1)/sqrt(Pr))/R.
 */
static void walls_of_a_long_tube_take_what_kirchhoff_says(void **state) {
  (void)state;
  const TbCavity tube = {
    .radius = 0.01, .depth = 10.0, .density = 1.205, .sound_speed = 343.0, .heads = 2};
  Walls walls;
  walls_prepare(&walls, &tube, 0, 2.0 * PI * 500.0);
  assert_true(walls.order.mode_count >= 20);
  for (uint32_t i = 0; i < walls.order.mode_count; i++) {
    const double wanted =
      sqrt(0.5 * NU * walls.order.modes[i].omega) * (1.0 + HEAT_CONDUCTION) / tube.radius;
    assert_true(fabs(wall_rate(&walls, &tube, i) / wanted - 1.0) < 2e-3); /* the ends: 2 R/L */
  }
  tb_arena_release(&walls.arena);
}

/* Over many modes a side of admittance beta takes as much as one of coefficient 8 beta takes from
 * sound from all directions: Sabine's s = c0 S alpha/(8 V), S/V = 2/R. */
static void an_absorbing_side_is_sabines(void **state) {
  (void)state;
  const double beta = 0.01, top = 2.0 * PI * 8000.0, bottom = 2.0 * PI * 4000.0;
  const TbCavity rigid = {
    .radius = 0.1524, .depth = 0.2032, .density = 1.205, .sound_speed = 343.0, .heads = 2};
  TbCavity soft = rigid;
  soft.admittance = beta;
  double sum = 0.0, count = 0.0;
  for (uint32_t m = 0; m < 22; m++) {
    Walls walls;
    walls_prepare(&walls, &rigid, m, top);
    for (uint32_t i = 0; i < walls.order.mode_count; i++) {
      if (walls.order.modes[i].omega < bottom) continue;
      const double copies = m ? 2.0 : 1.0;
      sum += copies * (wall_rate(&walls, &soft, i) - wall_rate(&walls, &rigid, i));
      count += copies;
    }
    tb_arena_release(&walls.arena);
  }
  const double sabine = rigid.sound_speed * (2.0 / rigid.radius) * 8.0 * beta / 8.0;
  print_message("%.0f modes: %.2f/s, Sabine %.2f/s\n", count, sum / count, sabine);
  assert_true(count > 500.0);
  assert_true(fabs(sum / count / sabine - 1.0) < 0.1);
}

/* Far below the cavity's modes pressure is rho0 c0^2 dV/V all over, and each wall takes its part.
 */
static void uniform_pressure_loses_heat_at_every_wall(void **state) {
  (void)state;
  const TbCavity cavity = {.radius = 0.15,
                           .depth = 0.2,
                           .density = 1.205,
                           .sound_speed = 343.0,
                           .heads = 2,
                           .admittance = 0.005};
  Walls walls;
  walls_prepare(&walls, &cavity, 0, 1.0);
  assert_int_equal(walls.order.mode_count, 0);
  const uint32_t n = walls.air.count;
  double heads[128] = {0.0};
  heads[0] = 1e-4; /* J_0(z_1 r/R) of the upper, */
  heads[n] = 5e-5; /* ... and half as much of the lower: 2 pi R^2 J_1(z_1)/z_1 each */
  const double omega = 2.0 * PI * 20.0, area = PI * 0.15 * 0.15, side = 2.0 * PI * 0.15 * 0.2;
  const double swept = 2.0 * area * walls.air.slopes[0] / walls.air.zeros[0] * 1.5e-4;
  const double bulk = 1.205 * 343.0 * 343.0, pressure = bulk * swept / (area * 0.2);
  const double heat = 0.5 * (omega / 343.0) * HEAT_CONDUCTION * sqrt(2.0 * NU / omega);
  const double wanted = 0.5 * pressure * pressure / (1.205 * 343.0) *
                        (heat * (side + 2.0 * area) + cavity.admittance * side);
  const double power = tb_cavity_wall_power(&walls.order, &cavity, &walls.air, heads, NULL, omega);
  assert_true(fabs(power / wanted - 1.0) < 1e-4);
  tb_arena_release(&walls.arena);
}

/* ---- how many cavity modes ------------------------------------------------------------------- */

/* Modes of the same air between rigid walls, sine copies counted. */
static double rigid_modes(const TaborDrumDef *def, double from_hz, double to_hz) {
  const TbCavity cavity = {.radius = def->shell.radius,
                           .depth = def->shell.depth,
                           .density = def->air.density,
                           .sound_speed = def->air.sound_speed,
                           .heads = 2};
  double count = 0.0;
  for (uint32_t m = 0; m < 60; m++) {
    Walls walls;
    walls_prepare(&walls, &cavity, m, 2.0 * PI * to_hz);
    for (uint32_t i = 0; i < walls.order.mode_count; i++) {
      if (walls.order.modes[i].omega >= 2.0 * PI * from_hz) count += m ? 2.0 : 1.0;
    }
    tb_arena_release(&walls.arena);
  }
  return count;
}

/* Heads that give way shift the modes of the air by some spacings and hide some in those that move
 * heads most; but none may be missing up to the last of the two-way modes. */
static void no_cavity_mode_is_missing_below_the_limit(void **state) {
  (void)state;
  static const char *const DRUMS[] = {"snare-14x5.5", "snare-14x6.5-loose", "tom-12",
                                      "floor-tom-16", "bass-drum-22",       "marching-14x12"};
  for (size_t d = 0; d < sizeof DRUMS / sizeof DRUMS[0]; d++) {
    TaborDrumDef def = physics_preset(DRUMS[d]);
    def.quality.two_way_bandwidth = 5000.0;
    TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
    TaborModeInfo mode;
    double limit = 0.0;
    for (uint32_t row = 0; tabor_model_mode(model, row, &mode); row++) {
      if (mode.part != TABOR_PART_RIM) limit = mode.frequency;
    }
    const double last = 0.85 * limit;
    double all = 0.0, upper = 0.0;
    for (uint32_t row = 0; tabor_model_mode(model, row, &mode); row++) {
      if (mode.part != TABOR_PART_CAVITY) continue;
      all += mode.multiplicity;
      if (mode.frequency >= last) upper += mode.multiplicity;
    }
    tabor_model_release(model);
    const double rigid = rigid_modes(&def, 0.0, limit), top = rigid_modes(&def, last, limit);
    print_message("%s: %.0f of %.0f up to %.0f Hz, %.0f of %.0f in the last 15 %%\n", DRUMS[d], all,
                  rigid, limit, upper, top);
    assert_true(fabs(all / rigid - 1.0) < 0.1);
    assert_true(fabs(upper / top - 1.0) < 0.15);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(coupled_drums_agree_with_the_reference),
    cmocka_unit_test(a_closed_cavity_of_uniform_pressure_stiffens_the_first_mode),
    cmocka_unit_test(a_few_cavity_coordinates_are_enough),
    cmocka_unit_test(walls_of_a_long_tube_take_what_kirchhoff_says),
    cmocka_unit_test(an_absorbing_side_is_sabines),
    cmocka_unit_test(uniform_pressure_loses_heat_at_every_wall),
    cmocka_unit_test(no_cavity_mode_is_missing_below_the_limit),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
