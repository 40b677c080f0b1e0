/* SPDX-License-Identifier: MIT */
/* Modified Bessel functions beside their series and their Wronskian-like identities. */
#include "math/modified_bessel.h"

#include "physics.h"

/* exp(-x) (x/2)^m/m! Sum_q (x^2/4)^q/(q! (m + 1)_q). */
static double by_series(uint32_t m, double x) {
  double first = exp(-x), sum = 0.0;
  for (uint32_t l = 1; l <= m; l++) first *= 0.5 * x / l;
  for (uint32_t q = 0; q < 400; q++) {
    sum += first;
    first *= 0.25 * x * x / ((q + 1.0) * (q + 1.0 + m));
  }
  return sum;
}

static void values_are_those_of_the_series(void **state) {
  (void)state;
  double worst = 0.0;
  for (uint32_t m = 0; m < 120; m += 7) {
    for (double x = 0.01; x < 300.0; x *= 1.7) {
      double i[2];
      tb_modified_bessel_pair(m, x, i);
      for (uint32_t more = 0; more < 2; more++) {
        const double exact = by_series(m + more, x);
        if (exact > 1e-250) worst = fmax(worst, fabs(i[more] / exact - 1.0));
      }
    }
  }
  print_message("relative error %.2g\n", worst);
  assert_true(worst < 1e-13);
}

/* I_0(1) = 1.2660658777520084, I_1(1) = 0.5651591039924850, I_10(10) = 21.891706163723374
 * [AbramowitzStegun], tables 9.8 and 9.11. */
static void values_are_those_of_tables(void **state) {
  (void)state;
  double i[2];
  tb_modified_bessel_pair(0, 1.0, i);
  assert_true(fabs(i[0] * exp(1.0) - 1.2660658777520084) < 1e-14);
  assert_true(fabs(i[1] * exp(1.0) - 0.5651591039924850) < 1e-14);
  tb_modified_bessel_pair(10, 10.0, i);
  print_message("%.12f\n", i[0] * exp(10.0));
  assert_true(fabs(i[0] * exp(10.0) - 21.891706163723374) < 1e-10);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(values_are_those_of_the_series),
    cmocka_unit_test(values_are_those_of_tables),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
