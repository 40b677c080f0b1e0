/* SPDX-License-Identifier: MIT */
/* Dense linear algebra: factors of complex symmetric matrices. */
#include <complex.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "math/ldlt.h"

enum { N = 40 };

static double draw(uint64_t *seed) {
  *seed = *seed * 6364136223846793005u + 1442695040888963407u;
  return (double)(*seed >> 11) / 9007199254740992.0 - 0.5;
}

/* Both parts are sums of squares, the imaginary one of few: semidefinite, as the open head's. */
static void add_square(uint64_t *seed, double *matrix) {
  double row[N];
  for (int i = 0; i < N; i++) row[i] = draw(seed);
  for (int i = 0; i < N; i++) {
    for (int k = 0; k < N; k++) matrix[i * N + k] += row[i] * row[k];
  }
}

static void factors_solve(void **state) {
  (void)state;
  const TaborAllocator system = tb_allocator_resolve(NULL);
  TbArena arena;
  tb_arena_prepare(&arena, &system);
  uint64_t seed = 1;
  double re[N * N] = {0.0}, im[N * N] = {0.0}, re_kept[N * N], im_kept[N * N];
  double b[2 * N] = {0.0}, x[2 * N] = {0.0};
  for (int i = 0; i < 2 * N; i++) add_square(&seed, re);
  for (int i = 0; i < N / 4; i++) add_square(&seed, im);
  for (int i = 0; i < N * N; i++) {
    re_kept[i] = re[i];
    im_kept[i] = im[i];
  }
  for (int i = 0; i < 2 * N; i++) b[i] = x[i] = draw(&seed);
  assert_true(tb_factor_symmetric(&arena, N, re, im));
  tb_solve_factored(N, re, im, x);
  for (int i = 0; i < N; i++) {
    double complex sum = -(b[2 * i] + I * b[2 * i + 1]);
    for (int k = 0; k < N; k++) {
      sum += (re_kept[i * N + k] + I * im_kept[i * N + k]) * (x[2 * k] + I * x[2 * k + 1]);
    }
    assert_true(cabs(sum) < 1e-12);
  }
  double zero[4] = {0.0}, nothing[4] = {0.0};
  assert_false(tb_factor_symmetric(&arena, 2, zero, nothing));
  tb_arena_release(&arena);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(factors_solve)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
