/* SPDX-License-Identifier: MIT */
/* Cholesky's factor and what is solved with it, beside LAPACK's dposv. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>
#include <lapacke.h>

#include "math/cholesky.h"

enum { MOST = 97, COLUMNS = 3 };

/* The matrices' condition is below 1e4, so answers agree to that many rounding errors. */
static const double ERROR = 1e-11;

static double draw(uint64_t *seed) {
  *seed = *seed * 6364136223846793005u + 1442695040888963407u;
  return (double)(*seed >> 11) / 9007199254740992.0 - 0.5;
}

/* A sum of squares on a diagonal. */
static void random_matrix(uint64_t *seed, uint32_t n, double *matrix) {
  memset(matrix, 0, (size_t)n * n * sizeof *matrix);
  for (uint32_t r = 0; r < n; r++) {
    double row[MOST];
    for (uint32_t i = 0; i < n; i++) row[i] = draw(seed);
    for (uint32_t i = 0; i < n; i++) {
      for (uint32_t k = 0; k < n; k++) matrix[i * n + k] += row[i] * row[k];
    }
    matrix[r * n + r] += 0.05;
  }
}

/* A stiff string's: what the wires at rest solve. */
static void banded_matrix(uint32_t n, double *matrix) {
  memset(matrix, 0, (size_t)n * n * sizeof *matrix);
  for (uint32_t i = 0; i < n; i++) {
    matrix[i * n + i] = 6.1;
    if (i + 1 < n) matrix[i * n + i + 1] = matrix[(i + 1) * n + i] = -4.0;
    if (i + 2 < n) matrix[i * n + i + 2] = matrix[(i + 2) * n + i] = 1.0;
  }
}

static double largest(const double *x, size_t count) {
  double most = 0.0;
  for (size_t i = 0; i < count; i++) most = fmax(most, fabs(x[i]));
  return most;
}

static void compare(uint64_t *seed, uint32_t n, const double *matrix) {
  static double mine[MOST * MOST], other[MOST * MOST];
  double x[COLUMNS * MOST], reference[COLUMNS * MOST], again[MOST];
  const size_t size = (size_t)n * n * sizeof *matrix, count = (size_t)COLUMNS * n;
  memcpy(mine, matrix, size);
  memcpy(other, matrix, size);
  for (size_t i = 0; i < count; i++) x[i] = reference[i] = draw(seed);
  memcpy(again, x, n * sizeof *x);
  assert_true(tb_solve_positive(n, mine, COLUMNS, x));
  assert_int_equal(LAPACKE_dposv(LAPACK_COL_MAJOR, 'L', (lapack_int)n, COLUMNS, other,
                                 (lapack_int)n, reference, (lapack_int)n),
                   0);
  const double most = largest(reference, count), factor = largest(other, (size_t)n * n);
  for (size_t i = 0; i < count; i++) assert_true(fabs(x[i] - reference[i]) <= ERROR * most);
  for (uint32_t i = 0; i < n; i++) { /* by columns below the diagonal: by rows above it */
    for (uint32_t k = i; k < n; k++) {
      assert_true(fabs(mine[i * n + k] - other[i * n + k]) <= ERROR * factor);
      assert_true(mine[i * n + k] == mine[k * n + i]);
    }
  }
  tb_solve_with_factor(n, mine, again);
  assert_memory_equal(again, x, n * sizeof *x);
}

static void like_lapack(void **state) {
  (void)state;
  static const uint32_t sizes[] = {1, 2, 3, 7, 16, 17, 33, MOST};
  static double matrix[MOST * MOST];
  uint64_t seed = 1;
  for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
    random_matrix(&seed, sizes[i], matrix);
    compare(&seed, sizes[i], matrix);
    banded_matrix(sizes[i], matrix);
    compare(&seed, sizes[i], matrix);
  }
  assert_true(tb_solve_positive(0, NULL, 1, NULL));
}

static void refused(void **state) {
  (void)state;
  enum { N = 4 };
  static const double bad[] = {0.0, -1.0, NAN, INFINITY};
  for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
    double matrix[N * N] = {0.0}, b[N] = {0.0};
    for (uint32_t k = 0; k < N; k++) matrix[k * N + k] = k == 2 ? bad[i] : 1.0;
    assert_false(tb_solve_positive(N, matrix, 1, b));
  }
  double indefinite[] = {1.0, 2.0, 2.0, 1.0};
  assert_false(tb_factor_positive(2, indefinite));
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(like_lapack), cmocka_unit_test(refused)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
