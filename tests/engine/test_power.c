/* SPDX-License-Identifier: MIT */
/* The step's own power and sine against libm's. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "power.h"

static void powers_agree_with_libm(void **state) {
  (void)state;
  double worst = 0.0;
  for (double a = 0.0; a <= 4.0; a += 0.173) {
    for (double x = 1e-40; x < 1e40; x *= 1.37) {
      worst = fmax(worst, fabs(tb_power(x, a) / pow(x, a) - 1.0));
    }
  }
  print_message("largest relative error %.1e\n", worst);
  assert_true(worst < 4e-14); /* power.h's promise: a log x of up to 370, rounded */
  assert_true(tb_power(0.0, 1.5) == 0.0);
  assert_true(tb_power(0.0, 0.0) == 1.0);
  assert_true(fabs(tb_power(1.0, 2.7) - 1.0) < 1e-15);
}

static void sines_agree_with_libm(void **state) {
  (void)state;
  double worst = 0.0;
  for (double angle = -1000.0; angle < 1000.0; angle += 0.37) {
    double s, c;
    tb_sin_cos_degrees(angle, &s, &c);
    const double radians = angle * 3.14159265358979323846 / 180.0;
    worst = fmax(worst, fmax(fabs(s - sin(radians)), fabs(c - cos(radians))));
  }
  print_message("largest error %.1e\n", worst);
  assert_true(worst < 4e-15); /* 1000 degrees in radians is rounded by 2e-15 already */
}

static void right_angles_are_exact(void **state) {
  (void)state;
  for (int quarter = -8; quarter <= 8; quarter++) {
    double s, c;
    tb_sin_cos_degrees(90.0 * quarter, &s, &c);
    assert_true(s == 0.0 || c == 0.0);
    assert_true(fabs(s) + fabs(c) == 1.0);
  }
}

static void directions_agree_with_libm(void **state) {
  (void)state;
  double worst = 0.0;
  for (double angle = -179.9; angle < 180.0; angle += 0.173) {
    const double radians = angle * 3.14159265358979323846 / 180.0;
    worst = fmax(worst, fabs(tb_arc_degrees(0.3 * sin(radians), 0.3 * cos(radians)) - angle));
  }
  print_message("largest error %.1e degrees\n", worst);
  assert_true(worst < 1e-12);
  assert_true(tb_arc_degrees(0.0, 0.0) == 0.0);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(powers_agree_with_libm),
    cmocka_unit_test(sines_agree_with_libm),
    cmocka_unit_test(right_angles_are_exact),
    cmocka_unit_test(directions_agree_with_libm),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
