/* SPDX-License-Identifier: MIT */
/* Bessel functions against libm's (whole orders), against closed forms (orders 1/2 and 3/2, and the
 * sum of squares), and zeros against published values. */
#define _GNU_SOURCE /* jn */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "math/bessel.h"
#include "math/bessel_table.h"

static const double PI = 3.14159265358979323846;

static void whole_orders_agree_with_libm(void **state) {
  (void)state;
  double worst = 0.0;
  for (uint32_t m = 0; m < 150; m += 3) {
    for (double x = 1e-6; x < 900.0; x = x * 1.07 + 0.01) {
      worst = fmax(worst, fabs(tb_bessel_j(m, x) - jn((int)m, x)));
    }
  }
  print_message("largest difference %.1e\n", worst);
  assert_true(worst < 1e-14);
}

static void lanes_agree_with_single_values(void **state) {
  (void)state;
  for (uint32_t m = 0; m < 100; m += 7) {
    for (double top = 0.0; top < 300.0; top = top * 1.5 + 0.1) {
      double x[8], j[8];
      for (int i = 0; i < 8; i++) x[i] = top * (7 - i) / 7.0;
      const uint32_t orders[8] = {m, 0, m, m + 1, 2 * m, m, 3, m};
      tb_bessel_j8(orders, x, j);
      for (int i = 0; i < 8; i++) assert_true(fabs(j[i] - tb_bessel_j(orders[i], x[i])) < 1e-14);
    }
  }
}

static void half_orders_have_their_closed_forms(void **state) {
  (void)state;
  enum { ORDERS = 260 };
  double j[8 * ORDERS];
  for (double base = 1e-4; base < 200.0; base *= 1.7) {
    double x[8];
    for (int i = 0; i < 8; i++) x[i] = base * (1.0 + 0.9 * i);
    tb_bessel_half8(x, ORDERS, j);
    for (int i = 0; i < 8; i++) {
      const double unit = sqrt(2.0 / (PI * x[i]));
      const double s = sin(x[i]), c = cos(x[i]);
      assert_true(fabs(j[i] - unit * s) < 1e-14);
      if (x[i] > 0.1) assert_true(fabs(j[8 + i] - unit * (s / x[i] - c)) < 1e-14);
      double sum = 0.0; /* Sum (2 l + 1) j_l^2 = 1 [DLMF] 10.60.12 */
      for (int l = 0; l < ORDERS; l++) {
        sum += (2.0 * l + 1.0) * j[8 * l + i] * j[8 * l + i] * PI / (2.0 * x[i]);
      }
      if (x[i] < 180.0) assert_true(fabs(sum - 1.0) < 1e-12);
    }
  }
}

static void zeros_are_the_published_ones(void **state) {
  (void)state;
  double order_0[40], order_1[40], order_2[40];
  const uint32_t n0 = tb_bessel_zeros(0, 60.0, order_0, 40);
  const uint32_t n1 = tb_bessel_zeros(1, 60.0, order_1, 40);
  const uint32_t n2 = tb_bessel_zeros(2, 60.0, order_2, 40);
  assert_int_equal(n0, 19);
  assert_int_equal(n1, 18);
  assert_int_equal(n2, 18);
  /* Abramowitz and Stegun, table 9.5. */
  assert_true(fabs(order_0[0] - 2.404825557695773) < 1e-14);
  assert_true(fabs(order_0[4] - 14.930917708487785) < 2e-14);
  assert_true(fabs(order_1[0] - 3.831705970207512) < 1e-14);
  assert_true(fabs(order_1[9] - 32.189679910974404) < 3e-14);
  assert_true(fabs(order_2[0] - 5.135622301840683) < 1e-14);
}

/* Zeros of neighbouring orders interlace ([DLMF] 10.21(i)): none is missing, none is there twice.
 */
static void zeros_interlace(void **state) {
  (void)state;
  enum { ROOM = 96 };
  double lists[2][ROOM];
  uint32_t last = 0;
  for (uint32_t m = 0; m < 250; m++) {
    double *zeros = lists[m % 2], *below = lists[1 - m % 2];
    const uint32_t count = tb_bessel_zeros(m, 240.0, zeros, ROOM);
    for (uint32_t i = 0; i < count; i++) {
      assert_true(fabs(tb_bessel_j(m, zeros[i])) < 1e-13);
      if (m == 0) continue;
      assert_true(zeros[i] > below[i]);
      if (i + 1 < last) assert_true(zeros[i] < below[i + 1]);
    }
    if (m) assert_true(count == last || count + 1 == last);
    last = count;
  }
  assert_int_equal(last, 0);
}

static void table_gives_what_it_was_made_from(void **state) {
  (void)state;
  const TaborAllocator system = tb_allocator_resolve(NULL);
  TbArena arena;
  tb_arena_prepare(&arena, &system);
  TbBesselTable table;
  assert_true(tb_bessel_table_prepare(&table, &arena, 60, 100.0));
  double worst = 0.0, beyond = 0.0;
  for (uint32_t m = 0; m < 64; m += 3) {
    for (double base = 0.0; base < 120.0; base += 0.83) {
      double x[8], j[8];
      for (int i = 0; i < 8; i++) x[i] = base + 0.017 * i;
      tb_bessel_table_values(&table, m, 8, 1.25, x, j);
      const bool inside = m < 60 && 1.25 * x[7] < 100.0;
      for (int i = 0; i < 8; i++) {
        const double error = fabs(j[i] - tb_bessel_j(m, 1.25 * x[i]));
        if (inside) worst = fmax(worst, error);
        if (!inside) beyond = fmax(beyond, error);
      }
    }
  }
  print_message("table: %.1e, beyond it %.1e\n", worst, beyond);
  assert_true(worst < 3e-11); /* bessel_table.h */
  assert_true(beyond < 1e-14);
  tb_arena_release(&arena);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(whole_orders_agree_with_libm),
    cmocka_unit_test(lanes_agree_with_single_values),
    cmocka_unit_test(half_orders_have_their_closed_forms),
    cmocka_unit_test(zeros_are_the_published_ones),
    cmocka_unit_test(zeros_interlace),
    cmocka_unit_test(table_gives_what_it_was_made_from),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
