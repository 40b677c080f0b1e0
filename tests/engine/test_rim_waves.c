/* SPDX-License-Identifier: MIT */
/* The waves around a hi-hat's edges: orthonormal, and each mode has one. */
#include "model/rim_waves.h"

#include "physics.h"

static const double PI = 3.14159265358979323846;

static void they_are_orthonormal(void **state) {
  (void)state;
  for (uint32_t n = 4; n <= 33; n++) {
    for (uint32_t a = 0; a < n; a++) {
      for (uint32_t b = 0; b <= a; b++) {
        double sum = 0.0;
        for (uint32_t j = 0; j < n; j++) sum += tb_rim_wave_at(n, a, j) * tb_rim_wave_at(n, b, j);
        assert_true(fabs(sum - (a == b)) < 1e-14);
      }
    }
  }
}

/* cos(m theta_j) and sin(m theta_j) are a multiple of their wave, or nothing. */
static void each_mode_has_one(void **state) {
  (void)state;
  for (uint32_t n = 4; n <= 33; n++) {
    for (uint32_t m = 0; m < 3 * n; m++) {
      for (int sine = 0; sine < 2; sine++) {
        const uint32_t wave = tb_rim_wave(n, m, sine);
        double along = 0.0, left = 0.0;
        assert_true(wave <= n);
        for (uint32_t j = 0; j < n; j++) {
          const double angle = 2.0 * PI * (m * j % n) / n, x = sine ? sin(angle) : cos(angle);
          left += x * x;
          if (wave < n) along += x * tb_rim_wave_at(n, wave, j);
        }
        assert_true(fabs(left - along * along) < 1e-12 * n);
        assert_true(wave == n ? left < 1e-12 : left > 0.4 * n);
      }
    }
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(they_are_orthonormal),
    cmocka_unit_test(each_mode_has_one),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
