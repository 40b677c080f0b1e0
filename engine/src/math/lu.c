/* SPDX-License-Identifier: MIT */
#include "math/lu.h"

#include <stddef.h>

static double square_of(const double *z) { return z[0] * z[0] + z[1] * z[1]; }

/* to -= factor from, `count` complex numbers. */
static void subtract(uint32_t count, double re, double im, const double *restrict from,
                     double *restrict to) {
  for (uint32_t i = 0; i < 2 * count; i += 2) {
    to[i] -= re * from[i] - im * from[i + 1];
    to[i + 1] -= re * from[i + 1] + im * from[i];
  }
}

static void divide(double *z, const double *by) {
  const double square = square_of(by);
  const double re = (z[0] * by[0] + z[1] * by[1]) / square;
  z[1] = (z[1] * by[0] - z[0] * by[1]) / square;
  z[0] = re;
}

static void exchange(uint32_t count, double *a, double *b) {
  for (uint32_t i = 0; i < 2 * count; i++) {
    const double kept = a[i];
    a[i] = b[i];
    b[i] = kept;
  }
}

static uint32_t pivot_row(uint32_t n, uint32_t column, const double *a) {
  uint32_t best = column;
  for (uint32_t i = column + 1; i < n; i++) {
    if (square_of(a + 2 * ((size_t)i * n + column)) >
        square_of(a + 2 * ((size_t)best * n + column))) {
      best = i;
    }
  }
  return best;
}

bool tb_solve_complex(uint32_t n, double *a, double *b) {
  for (uint32_t k = 0; k < n; k++) {
    double *row = a + 2 * (size_t)k * n;
    const uint32_t pivot = pivot_row(n, k, a);
    if (pivot != k) {
      exchange(n, row, a + 2 * (size_t)pivot * n);
      exchange(1, b + 2 * k, b + 2 * pivot);
    }
    if (!(square_of(row + 2 * k) > 0.0)) return false;
    for (uint32_t i = k + 1; i < n; i++) {
      double *other = a + 2 * (size_t)i * n, factor[2] = {other[2 * k], other[2 * k + 1]};
      divide(factor, row + 2 * k);
      subtract(n - k - 1, factor[0], factor[1], row + 2 * (k + 1), other + 2 * (k + 1));
      subtract(1, factor[0], factor[1], b + 2 * k, b + 2 * i);
    }
  }
  for (uint32_t k = n; k-- > 0;) {
    divide(b + 2 * k, a + 2 * ((size_t)k * n + k));
    for (uint32_t i = 0; i < k; i++) {
      const double *factor = a + 2 * ((size_t)i * n + k);
      subtract(1, factor[0], factor[1], b + 2 * k, b + 2 * i);
    }
  }
  return true;
}
