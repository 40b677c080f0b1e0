/* SPDX-License-Identifier: MIT */
/* The coating's roughness: as high as it says, smooth below its grains, another for every seed. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "strikers/head_coating.h"

enum { POINTS = 400000 };

static void its_root_mean_square_is_one(void **state) {
  (void)state;
  double sum = 0.0, square = 0.0;
  for (int i = 0; i < POINTS; i++) {
    const double h = tb_head_coating_height(7, i * 0.37 * TB_HEAD_COATING_GRAIN);
    sum += h / POINTS;
    square += h * h / POINTS;
  }
  print_message("mean %.3f, mean square %.3f\n", sum, square);
  assert_true(fabs(sum) < 0.03);
  assert_true(fabs(square - 1.0) < 0.05);
}

/* Twice differentiable: halving the step quarters what is left of second differences. */
static void it_is_smooth_below_a_grain(void **state) {
  (void)state;
  double worst[2] = {0.0, 0.0};
  for (int fine = 0; fine < 2; fine++) {
    const double step = TB_HEAD_COATING_GRAIN / (fine ? 128.0 : 64.0);
    for (int i = 0; i < 20000; i++) {
      const double s = (i + 1) * 0.013 * TB_HEAD_COATING_GRAIN;
      const double second = tb_head_coating_height(3, s + step) -
                            2.0 * tb_head_coating_height(3, s) +
                            tb_head_coating_height(3, s - step);
      worst[fine] = fmax(worst[fine], fabs(second));
    }
  }
  assert_true(worst[1] < 0.27 * worst[0]);
}

static void tracks_of_two_seeds_have_nothing_in_common(void **state) {
  (void)state;
  double product = 0.0;
  for (int i = 0; i < POINTS; i++) {
    const double s = i * 1.7 * TB_HEAD_COATING_GRAIN;
    product += tb_head_coating_height(1, s) * tb_head_coating_height(2, s) / POINTS;
  }
  assert_true(fabs(product) < 0.02);
  assert_true(tb_head_coating_height(1, 0.123) == tb_head_coating_height(1, 0.123));
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(its_root_mean_square_is_one),
    cmocka_unit_test(it_is_smooth_below_a_grain),
    cmocka_unit_test(tracks_of_two_seeds_have_nothing_in_common),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
