/* SPDX-License-Identifier: MIT */
/* Modes of the enclosed air in the high band: limits of the coupling of one mode with one Bessel
 * function. */
#include "high_band/high_cavity.h"

#include "math/bessel.h"
#include "physics.h"

enum { ORDER = 3, RADIAL = 12 };

/* One function of one head over a closed shell. */
typedef struct Pair {
  TaborDrumDef def;
  TbArena arena;
  TbCavityOrder order;
  TbCavityMics inside;
  TbHighCavity cavity;
  double zero, slope, outward;
  TbAirMode mode;
} Pair;

/* `damping_0` of the film [1/s]. */
static void prepare(Pair *pair, uint32_t function, double damping_0) {
  *pair = (Pair){.inside = {.count = 0}};
  const TaborAllocator system = tb_allocator_resolve(NULL);
  tb_arena_prepare(&pair->arena, &system);
  TaborDrumDef *const def = &pair->def;
  tabor_drum_def_default(def);
  def->shell.boundary = TABOR_BOUNDARY_CLOSED;
  def->shell.radius = 0.15;
  def->shell.depth = 0.2;
  def->shell.absorption = 0.0;
  def->batter.damping_0 = damping_0;
  def->batter.damping_k = def->batter.damping_1 = 0.0;
  const TbCavity air = {.radius = 0.15,
                        .depth = 0.2,
                        .density = def->air.density,
                        .sound_speed = def->air.sound_speed,
                        .heads = 1};
  double zeros[64];
  assert_true(tb_bessel_zeros(ORDER, 60.0, zeros, 64) > function);
  pair->zero = zeros[function];
  pair->slope = tb_bessel_j(ORDER + 1, pair->zero);
  assert_true(tb_cavity_order_prepare(&pair->order, &pair->arena, &air, ORDER, 60.0, 0.0));
  const TbAirOrder functions = {
    .m = ORDER, .count = 1, .zeros = &pair->zero, .slopes = &pair->slope};
  pair->mode.outward[0] = &pair->outward;
  assert_true(tb_high_cavity_prepare(&pair->cavity, &pair->arena, def, &functions, &pair->order,
                                     &pair->inside));
}

/* The mode; returns omega_i^2 - omega_c^2. */
static double couple(Pair *pair, uint32_t radial, uint32_t axial, double *omega) {
  pair->mode.radial = radial;
  pair->mode.axial = axial;
  tb_high_cavity_mode(&pair->cavity, &pair->mode);
  *omega = tb_high_cavity_omega(&pair->cavity, radial, axial);
  const double own = pair->cavity.waves[0].omega[0];
  return own * own - *omega * *omega;
}

/* t^2 */
static double share(const TbAirMode *mode) {
  return mode->in_head[0] / (mode->in_air * mode->in_air);
}

/* Without losses the pair's frequency solves (w^2 - w_c^2)(w^2 - w_i^2) = K^2, with w^2 - w_c^2 = K
 * t. */
static void a_pair_without_losses_is_exact(void **state) {
  (void)state;
  uint32_t checked = 0;
  for (uint32_t function = 4; function < 16; function++) {
    Pair pair;
    prepare(&pair, function, 0.0);
    for (uint32_t radial = 0; radial < RADIAL; radial++) {
      for (uint32_t axial = 0; axial < 4; axial++) {
        double omega;
        const double gap = couple(&pair, radial, axial, &omega), t = share(&pair.mode);
        const double width = 2.0 * omega * pair.mode.air_rate; /* friction at the walls remains */
        if (fabs(gap) < 1e3 * width || t < 1e-8) continue;
        const double moved = pair.mode.omega * pair.mode.omega - omega * omega;
        if (fabs(moved) < 1e-7 * omega * omega) continue; /* rounding */
        assert_true(fabs(moved * (1.0 - 1.0 / t) / gap - 1.0) < 1e-5);
        checked++;
      }
    }
    tb_arena_release(&pair.arena);
  }
  print_message("%u pairs\n", checked);
  assert_true(checked > 100);
}

/* Where losses are larger than distance and coupling, t = K/(2 omega (s_i + s_c)). */
static void losses_keep_a_pair_apart(void **state) {
  (void)state;
  static const double DAMPING[] = {2e5, 4e5};
  double t[2], losses[2];
  for (uint32_t i = 0; i < 2; i++) {
    Pair pair;
    double omega, nearest = INFINITY;
    prepare(&pair, 10, DAMPING[i]);
    uint32_t radial = 0;
    for (uint32_t p = 0; p < RADIAL; p++) {
      const double gap = fabs(couple(&pair, p, 1, &omega));
      if (gap < nearest) nearest = gap, radial = p;
    }
    couple(&pair, radial, 1, &omega);
    losses[i] = pair.cavity.waves[0].decay_rate[0] + pair.mode.air_rate;
    assert_true(2.0 * omega * losses[i] > 10.0 * nearest);
    t[i] = sqrt(share(&pair.mode));
    tb_arena_release(&pair.arena);
  }
  assert_true(fabs(t[0] / t[1] / (losses[1] / losses[0]) - 1.0) < 0.01);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(a_pair_without_losses_is_exact),
    cmocka_unit_test(losses_keep_a_pair_apart),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
