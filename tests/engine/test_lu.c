/* SPDX-License-Identifier: MIT */
/* Complex systems and least squares: solutions that are known, and systems that have none. */
#include "math/least_squares.h"
#include "math/lu.h"
#include "physics.h"

enum { N = 7, ROWS = 11 };

static void a_complex_system_gives_back_its_solution(void **state) {
  (void)state;
  uint64_t seed = 7;
  double a[2 * N * N], x[2 * N], b[2 * N] = {0.0};
  for (int i = 0; i < 2 * N * N; i++) a[i] = physics_uniform(&seed, -1.0, 1.0);
  a[0] = a[1] = 0.0; /* needs an exchange */
  for (int i = 0; i < 2 * N; i++) x[i] = physics_uniform(&seed, -1.0, 1.0);
  for (int i = 0; i < N; i++) {
    for (int k = 0; k < N; k++) {
      const double *e = a + 2 * (i * N + k);
      b[2 * i] += e[0] * x[2 * k] - e[1] * x[2 * k + 1];
      b[2 * i + 1] += e[0] * x[2 * k + 1] + e[1] * x[2 * k];
    }
  }
  assert_true(tb_solve_complex(N, a, b));
  for (int i = 0; i < 2 * N; i++) assert_true(fabs(b[i] - x[i]) < 1e-12);
}

static void a_singular_system_is_refused(void **state) {
  (void)state;
  double a[8] = {0.0}, b[4] = {1.0, 0.0, 0.0, 0.0};
  a[0] = 1.0;
  assert_false(tb_solve_complex(2, a, b));
}

/* The residual of the solution is at right angles to every column. */
static void least_squares_leave_a_normal_residual(void **state) {
  (void)state;
  uint64_t seed = 11;
  double a[ROWS * N], b[2 * ROWS], x[2 * N];
  for (int i = 0; i < ROWS * N; i++) a[i] = physics_uniform(&seed, -1.0, 1.0);
  for (int i = 0; i < 2 * ROWS; i++) b[i] = physics_uniform(&seed, -1.0, 1.0);
  TaborAllocator allocator = tb_allocator_resolve(NULL);
  TbArena arena;
  tb_arena_prepare(&arena, &allocator);
  assert_true(tb_least_squares(&arena, ROWS, N, a, 2, b, x));
  for (int column = 0; column < 2; column++) {
    for (int k = 0; k < N; k++) {
      double sum = 0.0;
      for (int r = 0; r < ROWS; r++) {
        double residual = -b[column * ROWS + r];
        for (int i = 0; i < N; i++) residual += a[r * N + i] * x[column * N + i];
        sum += a[r * N + k] * residual;
      }
      assert_true(fabs(sum) < 1e-12);
    }
  }
  tb_arena_release(&arena);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(a_complex_system_gives_back_its_solution),
    cmocka_unit_test(a_singular_system_is_refused),
    cmocka_unit_test(least_squares_leave_a_normal_residual),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
