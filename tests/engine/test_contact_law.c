/* SPDX-License-Identifier: MIT */
/* The contact law: a discrete gradient, its limits, its passivity, its slope limit. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "kernels/contact_law.h"
#include "kernels/kernels.h"

static const double K = 1.0 / 48000.0;
static const double exponents[] = {1.0, 1.2, 1.5, 1.7, 2.0, 2.5, 3.0};
enum { EXPONENTS = sizeof exponents / sizeof *exponents };

static void small_steps_give_the_static_force(void **state) {
  (void)state;
  for (int i = 0; i < EXPONENTS; i++) {
    TbContactLaw law;
    tb_contact_law_prepare(&law, 1e6, exponents[i], 0.0, K, INFINITY);
    for (double y = 1e-9; y < 1e-2; y *= 3.0) {
      const double force = tb_contact_law_static_force(&law, y);
      assert_true(fabs(force / (1e6 * pow(y, exponents[i])) - 1.0) < 1e-13);
      assert_true(fabs(tb_contact_law_force(&law, y, 0.0).force / force - 1.0) < 1e-13);
      /* and half the curvature as slope */
      const double half = 0.5e6 * exponents[i] * pow(y, exponents[i] - 1.0);
      assert_true(fabs(tb_contact_law_force(&law, y, 0.0).slope / half - 1.0) < 1e-12);
      assert_true(fabs(tb_contact_law_force(&law, y, 1e-7 * y).force / force - 1.0) < 1e-6);
    }
  }
}

static void work_is_the_difference_of_potentials(void **state) {
  (void)state;
  for (int i = 0; i < EXPONENTS; i++) {
    for (int limited = 0; limited < 2; limited++) {
      TbContactLaw law;
      tb_contact_law_prepare(&law, 1e7, exponents[i], 0.0, K, limited ? 2e4 : INFINITY);
      for (double y = -2e-3; y < 4e-3; y += 1.37e-4) {
        for (double s = -3e-3; s < 3e-3; s += 0.91e-4) {
          const double difference =
            tb_contact_law_potential(&law, y + s) - tb_contact_law_potential(&law, y);
          const double scale =
            tb_contact_law_potential(&law, y + s) + tb_contact_law_potential(&law, y) + 1e-300;
          assert_true(fabs(tb_contact_law_work(&law, y, s) - difference) < 1e-12 * scale);
          assert_true(fabs(tb_contact_law_force(&law, y, s).force * s - difference) <
                      1e-12 * scale);
        }
      }
    }
  }
}

static void forces_never_pull_grow_with_s_and_lose_energy(void **state) {
  (void)state;
  for (int i = 0; i < EXPONENTS; i++) {
    TbContactLaw law;
    tb_contact_law_prepare(&law, 1e7, exponents[i], 2.0, K, 3e4);
    for (double y = -1e-3; y < 2e-3; y += 1.1e-4) {
      double last = 0.0;
      for (double s = -3e-3; s < 3e-3; s += 1e-5) {
        const TbContactLawResult result = tb_contact_law_force(&law, y, s);
        assert_true(result.force >= last * (1.0 - 1e-12));
        assert_true(result.slope >= 0.0);
        const double loss = tb_contact_law_loss(&law, y, s);
        assert_true(loss >= -1e-18);
        const double work = tb_contact_law_work(&law, y, s);
        const double scale = fabs(result.force * s) + fabs(work);
        /* y + s is rounded, which is all that is left of a tiny s. */
        const double rounding = 1e-15 * result.force * fabs(y);
        assert_true(fabs(loss - 0.5 * (result.force * s - work)) <= 1e-12 * scale + rounding);
        /* The same from the mean force, as the solver books it. */
        assert_true(fabs(0.5 * s * (result.force - result.mean) - loss) <=
                    1e-13 * scale + rounding);
        last = result.force;
      }
    }
  }
}

/* The kernels' eight lanes against the scalar law, over the knee, at the surface and in the air. */
static void lanes_agree_with_the_law(void **state) {
  (void)state;
  static const double exponents_of_kernels[] = {1.0, 1.5, 2.0, 1.7};
  srand(20261121);
  for (int i = 0; i < 4; i++) {
    TbContactLaw law;
    tb_contact_law_prepare(&law, 1e7, exponents_of_kernels[i], 2.0, K, 3e4);
    for (int trial = 0; trial < 20000; trial++) {
      _Alignas(64) double y[8], s[8], force[8], slope[8], mean[8];
      for (int l = 0; l < 8; l++) {
        y[l] = (rand() / (double)RAND_MAX - 0.5) * pow(10.0, -2 - rand() % 5);
        s[l] = (rand() / (double)RAND_MAX - 0.5) * pow(10.0, -2 - rand() % 7);
        if (trial % 100 == 0) s[l] = 0.0;
      }
      tb_kernels_baseline.laws(1, 8, &law, y, NULL, s, force, slope, mean);
      for (int l = 0; l < 8; l++) {
        const TbContactLawResult one = tb_contact_law_force(&law, y[l], s[l]);
        assert_true(fabs(force[l] - one.force) <= 1e-11 * one.force);
        assert_true(fabs(mean[l] - one.mean) <= 1e-11 * one.mean);
        assert_true(fabs(slope[l] - one.slope) <= 1e-8 * one.slope + 1e-9);
      }
    }
  }
}

static void slope_is_the_derivative(void **state) {
  (void)state;
  for (int i = 0; i < EXPONENTS; i++) {
    TbContactLaw law;
    tb_contact_law_prepare(&law, 1e7, exponents[i], 1.0, K, 5e4);
    for (double y = 1e-5; y < 1e-3; y *= 1.7) {
      for (double s = -0.8 * y; s < 1e-3; s += 3.3e-5) {
        const double d = 1e-4 * y;
        const double numeric = (tb_contact_law_force(&law, y, s + d).force -
                                tb_contact_law_force(&law, y, s - d).force) /
                               (2.0 * d);
        const double slope = tb_contact_law_force(&law, y, s).slope;
        assert_true(fabs(slope - numeric) < 2e-3 * fabs(numeric) + 1e-6);
      }
    }
  }
}

static void curvature_stops_at_its_limit(void **state) {
  (void)state;
  for (int i = 0; i < EXPONENTS; i++) {
    const double limit = 1e4;
    TbContactLaw law;
    tb_contact_law_prepare(&law, 1e9, exponents[i], 0.0, K, limit);
    double force = 0.0;
    for (double eta = 0.0; eta < 1e-2; eta += 1e-6) {
      assert_true(tb_contact_law_curvature(&law, eta) <= limit * (1.0 + 1e-9));
      const double next = tb_contact_law_static_force(&law, eta);
      assert_true(next - force <= limit * 1e-6 * (1.0 + 1e-6) + 1e-12); /* no jump */
      force = next;
    }
  }
}

static void damper_is_linear(void **state) {
  (void)state;
  TbContactLaw law;
  tb_contact_law_damper(&law, 3.0, K);
  assert_true(fabs(tb_contact_law_force(&law, 1.0, -2e-5).force / (-3.0 * 2e-5 / (2.0 * K)) - 1.0) <
              1e-14);
  assert_true(tb_contact_law_work(&law, 1.0, 1.0) == 0.0);
  assert_true(fabs(tb_contact_law_loss(&law, 0.0, 2e-5) / (0.5 * 3.0 * 4e-10 / (2.0 * K)) - 1.0) <
              1e-14);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(small_steps_give_the_static_force),
    cmocka_unit_test(work_is_the_difference_of_potentials),
    cmocka_unit_test(forces_never_pull_grow_with_s_and_lose_energy),
    cmocka_unit_test(lanes_agree_with_the_law),
    cmocka_unit_test(slope_is_the_derivative),
    cmocka_unit_test(curvature_stops_at_its_limit),
    cmocka_unit_test(damper_is_linear),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
