/* SPDX-License-Identifier: MIT */
#include "math/least_squares.h"

#include "math/cholesky.h"
#include "math/combine.h"

bool tb_least_squares(TbArena *scratch, uint32_t rows, uint32_t n, const double *a,
                      uint32_t columns, const double *b, double *x) {
  double *normal = tb_arena_doubles(scratch, (size_t)n * n);
  double *turned = tb_arena_doubles(scratch, (size_t)n * rows);
  if (scratch->failed) return false;
  for (uint32_t r = 0; r < rows; r++) {
    for (uint32_t i = 0; i < n; i++) turned[(size_t)i * rows + r] = a[(size_t)r * n + i];
  }
  for (uint32_t i = 0; i < n; i++) {
    tb_combine_rows(n - i, rows, turned + (size_t)i * rows, a + i, n, 1.0,
                    normal + (size_t)i * n + i);
    for (uint32_t k = i + 1; k < n; k++) normal[(size_t)k * n + i] = normal[(size_t)i * n + k];
  }
  for (uint32_t c = 0; c < columns; c++) {
    double *out = x + (size_t)c * n;
    for (uint32_t i = 0; i < n; i++) out[i] = 0.0;
    tb_combine_rows(n, rows, b + (size_t)c * rows, a, n, 1.0, out);
  }
  return tb_solve_positive(n, normal, columns, x);
}
