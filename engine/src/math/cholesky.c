/* SPDX-License-Identifier: MIT */
#include "math/cholesky.h"

#include <math.h>

#include "math/combine.h"

bool tb_factor_row(uint32_t n, uint32_t i, double *matrix) {
  double *row = matrix + (size_t)i * n;
  /* The lower triangle of this row is U's column i already. */
  tb_combine_rows(n - i, i, row, matrix + i, n, -1.0, row + i);
  if (!(row[i] > 0.0) || isinf(row[i])) return false;
  row[i] = sqrt(row[i]);
  for (uint32_t j = i + 1; j < n; j++) {
    row[j] /= row[i];
    matrix[(size_t)j * n + i] = row[j];
  }
  return true;
}

bool tb_factor_positive(uint32_t n, double *matrix) {
  for (uint32_t i = 0; i < n; i++) {
    if (!tb_factor_row(n, i, matrix)) return false;
  }
  return true;
}

void tb_solve_upper(uint32_t n, const double *factor, double *b) {
  for (uint32_t k = n; k-- > 0;) {
    const double *column = factor + (size_t)k * n;
    b[k] /= column[k];
    for (uint32_t j = 0; j < k; j++) b[j] -= b[k] * column[j];
  }
}

void tb_solve_with_factor(uint32_t n, const double *factor, double *b) {
  for (uint32_t k = 0; k < n; k++) {
    const double *row = factor + (size_t)k * n;
    b[k] /= row[k];
    for (uint32_t j = k + 1; j < n; j++) b[j] -= b[k] * row[j];
  }
  tb_solve_upper(n, factor, b);
}

bool tb_solve_positive(uint32_t n, double *matrix, uint32_t columns, double *right_hand_sides) {
  if (!tb_factor_positive(n, matrix)) return false;
  for (uint32_t c = 0; c < columns; c++) {
    tb_solve_with_factor(n, matrix, right_hand_sides + (size_t)c * n);
  }
  return true;
}
