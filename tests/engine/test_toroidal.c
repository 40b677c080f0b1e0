/* SPDX-License-Identifier: MIT */
/* Toroidal functions against their integral, computed with mpmath, and their recurrence. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "math/toroidal.h"

enum { COUNT = 6 };

static void values_are_the_integrals(void **state) {
  (void)state;
  static const struct {
    double gap, first, second, last; /* Q_{-1/2}, Q_{1/2}, Q_{9/2} */
  } known[] = {{0.5, 2.01890581997842, 0.393175148372005, 0.00417456539164651},
               {1e-4, 6.33797141372929, 4.33826331071002, 2.76811874440306}};
  for (int i = 0; i < 2; i++) {
    double q[COUNT];
    tb_toroidal(known[i].gap, COUNT, q);
    assert_true(fabs(q[0] / known[i].first - 1.0) < 1e-12);
    assert_true(fabs(q[1] / known[i].second - 1.0) < 1e-11);
    assert_true(fabs(q[5] / known[i].last - 1.0) < 1e-10);
  }
}

/* (m + 1/2) Q_{m+1/2} = 2 m chi Q_{m-1/2} - (m - 1/2) Q_{m-3/2}, whichever way it was run, and the
 * first values do not depend on how many were asked for. */
static void the_recurrence_holds_everywhere(void **state) {
  (void)state;
  double worst = 0.0;
  for (double gap = 1e-12; gap < 1e6; gap *= 7.0) {
    double q[40], few[3];
    tb_toroidal(gap, 40, q);
    tb_toroidal(gap, 3, few);
    for (int m = 1; m < 39; m++) {
      const double up = (m + 0.5) * q[m + 1], here = 2.0 * m * (1.0 + gap) * q[m];
      worst = fmax(worst, fabs(up + (m - 0.5) * q[m - 1] - here) / here);
      assert_true(q[m] > 0.0 && q[m] < q[m - 1]);
    }
    for (int m = 0; m < 3; m++) assert_true(fabs(few[m] / q[m] - 1.0) < 1e-9);
  }
  print_message("recurrence within %.1e\n", worst);
  assert_true(worst < 1e-13);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(values_are_the_integrals),
    cmocka_unit_test(the_recurrence_holds_everywhere),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
