/* SPDX-License-Identifier: MIT */
/* The tension of a head between uneven lugs: in equilibrium, and as the lugs pull at the rim. */
#include "physics.h"

#include "bodies/drum/lug_tension.h"

static const double PI = 3.14159265358979323846;

static TaborHeadDef head_with(const double *lugs, uint32_t count) {
  TaborDrumDef def;
  tabor_drum_def_default(&def);
  def.batter.lug_count = count;
  for (uint32_t j = 0; j < count; j++) def.batter.lug[j] = lugs[j];
  return def.batter;
}

static const double LUGS[10] = {0.05, -0.02, 0.04, 0.0, -0.05, 0.03, 0.01, -0.04, 0.02, 0.02};

static void the_lugs_pull_at_the_rim_as_they_should(void **state) {
  (void)state;
  for (uint32_t count = 3; count <= 10; count++) {
    const TaborHeadDef head = head_with(LUGS, count);
    TbLugTension field;
    assert_true(tb_lug_tension_prepare(&field, &head, 0.0));
    double first = 0.0; /* the pull to one side, which the edge holds by friction */
    for (uint32_t j = 0; j < count; j++) {
      const double angle = 2.0 * PI * (j + 0.5) / count;
      const TbTension n = tb_lug_tension_at(&field, 1.0, angle);
      assert_true(fabs(n.rr - LUGS[j]) < 1e-14);
      first = count == 3 ? INFINITY : fabs(field.c[1]) + fabs(field.s[1]);
      assert_true(fabs(n.rt) <= first + 1e-14);
    }
  }
}

/* div N = 0: (r N_rr)_r + (N_rt)_t = N_tt and (r N_rt)_r + (N_tt)_t + N_rt = 0. */
static void the_sheet_is_in_equilibrium(void **state) {
  (void)state;
  const TaborHeadDef head = head_with(LUGS, 10);
  TbLugTension field;
  assert_true(tb_lug_tension_prepare(&field, &head, 0.3));
  const double h = 1e-5;
  for (double r = 0.1; r < 0.95; r += 0.1) {
    for (double t = 0.0; t < 6.2; t += 0.4) {
      const TbTension n = tb_lug_tension_at(&field, r, t);
      const TbTension out = tb_lug_tension_at(&field, r + h, t),
                      in = tb_lug_tension_at(&field, r - h, t);
      const TbTension on = tb_lug_tension_at(&field, r, t + h),
                      back = tb_lug_tension_at(&field, r, t - h);
      const double along =
        ((r + h) * out.rr - (r - h) * in.rr + on.rt - back.rt) / (2.0 * h) - n.tt;
      const double across =
        ((r + h) * out.rt - (r - h) * in.rt + on.tt - back.tt) / (2.0 * h) + n.rt;
      assert_true(fabs(along) < 1e-8 && fabs(across) < 1e-8);
    }
  }
}

static void a_draw_has_no_mean_and_reaches_its_spread(void **state) {
  (void)state;
  for (uint32_t seed = 0; seed < 50; seed++) {
    TaborHeadDef head = head_with(NULL, 0);
    head.lug_count = 3 + seed % 14;
    head.lug_spread = 0.04;
    head.lug_seed = seed;
    double deviation[TABOR_MAX_LUGS], mean = 0.0, largest = 0.0;
    tb_lug_deviations(&head, deviation);
    for (uint32_t j = 0; j < head.lug_count; j++) {
      mean += deviation[j];
      largest = fmax(largest, fabs(deviation[j]));
    }
    assert_true(fabs(mean) < 1e-15 && fabs(largest - 0.04) < 1e-16);
    head.lug[1] = 0.2; /* the others stay */
    double tuned[TABOR_MAX_LUGS];
    tb_lug_deviations(&head, tuned);
    assert_true(tuned[1] == 0.2 && tuned[0] == deviation[0] && tuned[2] == deviation[2]);
  }
}

static void lugs_that_all_pull_alike_are_even_or_one_tension(void **state) {
  (void)state;
  static const double NONE[5] = {0.0}, MORE[5] = {0.1, 0.1, 0.1, 0.1, 0.1};
  TaborHeadDef head = head_with(NONE, 5);
  TbLugTension field;
  assert_false(tb_lug_tension_prepare(&field, &head, 0.0));
  head = head_with(MORE, 5);
  assert_true(tb_lug_tension_prepare(&field, &head, 0.0));
  const TbTension n = tb_lug_tension_at(&field, 0.4, 1.0);
  assert_true(fabs(n.rr - 0.1) < 1e-15 && fabs(n.tt - 0.1) < 1e-15 && fabs(n.rt) < 1e-15);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(the_lugs_pull_at_the_rim_as_they_should),
    cmocka_unit_test(the_sheet_is_in_equilibrium),
    cmocka_unit_test(a_draw_has_no_mean_and_reaches_its_spread),
    cmocka_unit_test(lugs_that_all_pull_alike_are_even_or_one_tension),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
