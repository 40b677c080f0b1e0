/* SPDX-License-Identifier: MIT */
/* The engine's own functions beside libm's, in long double where that has more digits. */
#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "math/portable_math.h"

/* The distance of two doubles that lie side by side near `value`. */
static long double ulp(long double value) {
  const double near = fabs((double)value);
  return near < DBL_MIN ? (long double)DBL_MIN * DBL_EPSILON
                        : (long double)nextafter(near, INFINITY) - near;
}

typedef long double Reference(long double x);

/* The largest error in ulps over arguments from `from` to `to`, each `factor` times the one before.
 */
static double worst_of(double (*mine)(double x), Reference *reference, double from, double to,
                       double factor) {
  long double worst = 0.0L;
  for (double x = from; x < to; x *= factor) {
    for (int sign = -1; sign <= 1; sign += 2) {
      const long double expected = reference(sign * x);
      if (isnan(expected)) continue;
      worst = fmaxl(worst, fabsl(mine(sign * x) - expected) / ulp(expected));
    }
  }
  return (double)worst;
}

static void check(const char *name, double worst, double bound) {
  print_message("%s: %.2f ulp\n", name, worst);
  assert_true(worst <= bound);
}

/* Half an ulp more where long double is no longer than double, and libm's own error counts. */
static const double LIBM = LDBL_MANT_DIG > DBL_MANT_DIG ? 0.0 : 0.5;

static void functions_agree_with_libm(void **state) {
  (void)state;
  check("exp", worst_of(tb_exp, expl, 1e-20, 708.0, 1.0003), 1.0 + LIBM);
  check("log", worst_of(tb_log, logl, 2.3e-308, 1e308, 1.0031), 2.0 + LIBM);
  check("log near 1", worst_of(tb_log, logl, 0.5, 2.0, 1.00001), 2.0 + LIBM);
  check("sinh", worst_of(tb_sinh, sinhl, 1e-20, 709.0, 1.0003), 4.0 + LIBM);
  check("cosh", worst_of(tb_cosh, coshl, 1e-20, 709.0, 1.0003), 4.0 + LIBM);
  check("tanh", worst_of(tb_tanh, tanhl, 1e-20, 100.0, 1.0003), 4.0 + LIBM);
}

static long double positive_cbrt(long double x) { return x < 0.0L ? NAN : cbrtl(x); }

static void roots_agree_with_libm(void **state) {
  (void)state;
  check("cbrt", worst_of(tb_cbrt, positive_cbrt, 1e-100, 1e100, 1.0017), 2.0 + LIBM);
  long double worst = 0.0L;
  for (double x = 1e-300; x < 1e300; x *= 1.7) {
    for (double y = 1e-3 * x; y < 1e3 * x; y *= 1.3) {
      const long double expected = hypotl(x, y);
      worst = fmaxl(worst, fabsl(tb_hypot(-x, y) - expected) / ulp(expected));
    }
  }
  check("hypot", (double)worst, 2.0 + LIBM);
  assert_true(tb_hypot(0.0, 0.0) == 0.0 && tb_hypot(0.0, -3.0) == 3.0 && tb_cbrt(0.0) == 0.0);
}

/* Where a sine passes zero it has fewer digits than one near 1, but as small an error. */
static long double pair_error(double x, double s, double c) {
  const long double sine = sinl(x), cosine = cosl(x);
  return fmaxl(fabsl(s - sine) / fmaxl(ulp(sine), 1.2e-16L),
               fabsl(c - cosine) / fmaxl(ulp(cosine), 1.2e-16L));
}

static long double sine_error(double x) {
  double s, c, sine[3], cosine[3];
  const double array[3] = {x, -x, x}; /* one is left over from the vectors */
  tb_sin_cos(x, &s, &c);
  assert_true(tb_sin(x) == s && tb_cos(x) == c);
  tb_sin_cos_array(3, array, sine, cosine);
  assert_true(sine[1] == -sine[0] && cosine[1] == cosine[0]);
  assert_true(sine[2] == sine[0] && cosine[2] == cosine[0]);
  return fmaxl(pair_error(x, s, c), pair_error(x, sine[0], cosine[0]));
}

static void sines_agree_with_libm(void **state) {
  (void)state;
#ifdef _WIN32
  print_message("SKIPPED: sinl() of mingw-w64 is wrong by thousands of ulp near multiples of pi\n");
  skip();
#endif
  long double worst = 0.0L;
  for (double x = 1e-20; x < 4e8; x *= 1.00007) worst = fmaxl(worst, sine_error(x));
  for (double x = -400.0; x < 400.0; x += 0.00173) worst = fmaxl(worst, sine_error(x));
  for (int n = 1; n < 10000; n++) worst = fmaxl(worst, sine_error(n * 1.57079632679489661923));
  check("sin and cos", (double)worst, 1.5 + LIBM);
  double near_zero = worst_of(tb_sin, sinl, 1e-20, 0.78, 1.0003);
  check("sin of small angles", near_zero, 1.0 + LIBM);
}

static void ends_of_the_ranges(void **state) {
  (void)state;
  assert_true(tb_sin(0.0) == 0.0 && tb_cos(0.0) == 1.0 && tb_exp(0.0) == 1.0 && tb_log(1.0) == 0.0);
  assert_true(tb_sinh(0.0) == 0.0 && tb_cosh(0.0) == 1.0 && tb_tanh(0.0) == 0.0);
  assert_true(tb_exp(-INFINITY) == 0.0 && tb_exp(-800.0) == 0.0);
  assert_true(isinf(tb_exp(INFINITY)) && isinf(tb_exp(710.0)) && isfinite(tb_exp(709.7)));
  assert_true(tb_log(0.0) == -INFINITY && tb_log(INFINITY) == INFINITY && isnan(tb_log(-1.0)));
  assert_true(isinf(tb_cosh(800.0)) && tb_sinh(-800.0) == -INFINITY && tb_tanh(-800.0) == -1.0);
  assert_true(isnan(tb_sin(NAN)) && isnan(tb_cos(INFINITY)) && isnan(tb_sin(5e8)));
  assert_true(isnan(tb_exp(NAN)) && isnan(tb_log(NAN)) && isnan(tb_tanh(NAN)));
}

static void whole_powers(void **state) {
  (void)state;
  assert_true(tb_whole_power(0.0, 0) == 1.0 && tb_whole_power(0.0, 3) == 0.0);
  assert_true(tb_whole_power(-2.0, 5) == -32.0 && tb_whole_power(1.0, 4000000000u) == 1.0);
  for (uint32_t n = 1; n < 300; n++) {
    const long double expected = powl(0.93, n);
    assert_true(fabsl(tb_whole_power(0.93, n) - expected) <= n * ulp(expected));
  }
}

static void powers_agree_with_libm(void **state) {
  (void)state;
  double worst = 0.0;
  for (double a = 0.0; a <= 4.0; a += 0.173) {
    for (double x = 1e-40; x < 1e40; x *= 1.37) {
      worst = fmax(worst, fabs(tb_power(x, a) / pow(x, a) - 1.0));
    }
  }
  print_message("largest relative error %.1e\n", worst);
  assert_true(worst < 4e-14); /* portable_math.h's promise: a log x of up to 370, rounded */
  assert_true(tb_power(0.0, 1.5) == 0.0);
  assert_true(tb_power(0.0, 0.0) == 1.0);
  assert_true(fabs(tb_power(1.0, 2.7) - 1.0) < 1e-15);
}

static void sines_of_degrees_agree_with_libm(void **state) {
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
    static const double sines[] = {0.0, 1.0, 0.0, -1.0};
    double s, c;
    tb_sin_cos_degrees(90.0 * quarter, &s, &c);
    assert_true(s == sines[(quarter + 8) % 4] && c == sines[(quarter + 9) % 4]);
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
    cmocka_unit_test(functions_agree_with_libm),
    cmocka_unit_test(roots_agree_with_libm),
    cmocka_unit_test(sines_agree_with_libm),
    cmocka_unit_test(ends_of_the_ranges),
    cmocka_unit_test(whole_powers),
    cmocka_unit_test(powers_agree_with_libm),
    cmocka_unit_test(sines_of_degrees_agree_with_libm),
    cmocka_unit_test(right_angles_are_exact),
    cmocka_unit_test(directions_agree_with_libm),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
