/* SPDX-License-Identifier: MIT */
#include "math/ldlt.h"

/* Column `from` of A, below its diagonal. */
static void take_column(uint32_t n, uint32_t from, const double *a, double *column) {
  for (uint32_t i = from + 1; i < n; i++) column[i] = a[(size_t)i * n + from];
}

/* row -= l column, from index `from` to `to`, complex. */
static void reduce_row(uint32_t from, uint32_t to, double l_re, double l_im,
                       const double *restrict column_re, const double *restrict column_im,
                       double *restrict re, double *restrict im) {
  for (uint32_t j = from; j <= to; j++) {
    re[j] -= l_re * column_re[j] - l_im * column_im[j];
    im[j] -= l_re * column_im[j] + l_im * column_re[j];
  }
}

bool tb_factor_symmetric(TbArena *scratch, uint32_t n, double *re, double *im) {
  double *column_re = tb_arena_doubles(scratch, n), *column_im = tb_arena_doubles(scratch, n);
  if (scratch->failed) return false;
  for (uint32_t k = 0; k < n; k++) {
    const size_t pivot = (size_t)k * n + k;
    const double square = re[pivot] * re[pivot] + im[pivot] * im[pivot];
    if (!(square > 0.0)) return false;
    const double inverse_re = re[pivot] / square, inverse_im = -im[pivot] / square;
    take_column(n, k, re, column_re);
    take_column(n, k, im, column_im);
    for (uint32_t i = k + 1; i < n; i++) {
      const double l_re = column_re[i] * inverse_re - column_im[i] * inverse_im;
      const double l_im = column_re[i] * inverse_im + column_im[i] * inverse_re;
      double *row_re = re + (size_t)i * n, *row_im = im + (size_t)i * n;
      reduce_row(k + 1, i, l_re, l_im, column_re, column_im, row_re, row_im);
      row_re[k] = l_re;
      row_im[k] = l_im;
    }
  }
  return true;
}

/* b[i] -= l b[k], complex. */
static void eliminate(double *b, uint32_t i, uint32_t k, double l_re, double l_im) {
  b[2 * i] -= l_re * b[2 * k] - l_im * b[2 * k + 1];
  b[2 * i + 1] -= l_re * b[2 * k + 1] + l_im * b[2 * k];
}

void tb_solve_factored(uint32_t n, const double *re, const double *im, double *b) {
  for (uint32_t i = 0; i < n; i++) {
    for (uint32_t k = 0; k < i; k++) {
      eliminate(b, i, k, re[(size_t)i * n + k], im[(size_t)i * n + k]);
    }
  }
  for (uint32_t i = 0; i < n; i++) {
    const double d_re = re[(size_t)i * n + i], d_im = im[(size_t)i * n + i];
    const double square = d_re * d_re + d_im * d_im, b_re = b[2 * i], b_im = b[2 * i + 1];
    b[2 * i] = (b_re * d_re + b_im * d_im) / square;
    b[2 * i + 1] = (b_im * d_re - b_re * d_im) / square;
  }
  for (uint32_t i = n; i-- > 0;) {
    for (uint32_t k = 0; k < i; k++) {
      eliminate(b, k, i, re[(size_t)i * n + k], im[(size_t)i * n + k]);
    }
  }
}
