/* SPDX-License-Identifier: MIT */
/* Compiled once per instruction set, with TB_KERNELS naming the table it fills. */
#include "kernels.h"

#define LANES 8u

static double join(const double s[LANES]) {
  return ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]));
}

static void two_step(uint32_t n, double *restrict out, const double *restrict a,
                     const double *restrict x, const double *restrict b,
                     const double *restrict y) {
  for (uint32_t i = 0; i < n; i++) out[i] = a[i] * x[i] - b[i] * y[i];
}

static void project(uint32_t rows, uint32_t columns, uint32_t stride, double *restrict out,
                    const double *restrict matrix, const double *restrict x) {
  for (uint32_t j = 0; j < columns; j++) out[j] = 0.0;
  for (uint32_t i = 0; i + 4 <= rows; i += 4) { /* rows is a multiple of 8 */
    const double *restrict m0 = matrix + (uint64_t)i * stride, *restrict m1 = m0 + stride;
    const double *restrict m2 = m1 + stride, *restrict m3 = m2 + stride;
    const double x0 = x[i], x1 = x[i + 1], x2 = x[i + 2], x3 = x[i + 3];
    for (uint32_t j = 0; j < columns; j++) {
      out[j] = (((out[j] + m0[j] * x0) + m1[j] * x1) + m2[j] * x2) + m3[j] * x3;
    }
  }
}

static void spread(uint32_t rows, uint32_t columns, uint32_t stride, double *restrict out,
                   const double *restrict scale, const double *restrict matrix,
                   const double *restrict x) {
  for (uint32_t i = 0; i < rows; i++) {
    const double *restrict m = matrix + (uint64_t)i * stride;
    double sum[LANES] = {0.0};
    for (uint32_t j = 0; j < columns; j += LANES) {
      for (uint32_t l = 0; l < LANES; l++) sum[l] += m[j + l] * x[j + l];
    }
    out[i] += scale[i] * join(sum);
  }
}

static double dot(uint32_t n, const double *restrict x, const double *restrict y) {
  double sum[LANES] = {0.0};
  for (uint32_t i = 0; i < n; i += LANES) {
    for (uint32_t l = 0; l < LANES; l++) sum[l] += x[i + l] * y[i + l];
  }
  return join(sum);
}

static void add_scaled(uint32_t n, double *restrict out, double f, const double *restrict x) {
  for (uint32_t i = 0; i < n; i++) out[i] += f * x[i];
}

static double readout(uint32_t n, const double *restrict u, const double *restrict v,
                      const double *restrict next, const double *restrict now,
                      const double *restrict last) {
  double sum[LANES] = {0.0};
  for (uint32_t i = 0; i < n; i += LANES) {
    for (uint32_t l = 0; l < LANES; l++) {
      const double bend = (next[i + l] - now[i + l]) - (now[i + l] - last[i + l]);
      sum[l] += u[i + l] * bend + v[i + l] * (next[i + l] - last[i + l]);
    }
  }
  return join(sum);
}

static TbPair losses(uint32_t n, const double *restrict u, const double *restrict v,
                     const double *restrict next, const double *restrict last) {
  double first[LANES] = {0.0}, second[LANES] = {0.0};
  for (uint32_t i = 0; i < n; i += LANES) {
    for (uint32_t l = 0; l < LANES; l++) {
      const double step = next[i + l] - last[i + l];
      first[l] += u[i + l] * (step * step);
      second[l] += v[i + l] * (step * step);
    }
  }
  return (TbPair){join(first), join(second)};
}

const TbKernels TB_KERNELS = {two_step, project, spread, dot, add_scaled, readout, losses};
