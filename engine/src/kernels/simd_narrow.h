/* SPDX-License-Identifier: MIT */
/* The kernels that exist in single precision alone; they work on a state in double. For
 * kernels_tmpl.c alone. */
#ifndef TB_SIMD_NARROW_H
#define TB_SIMD_NARROW_H

#include "kernels/kernels.h"
#include "kernels/simd_lanes.h"

static void narrow(uint32_t n, const double *x, float *out) {
  for (uint32_t i = 0; i < n; i += 8) store(out + i, load_double(x + i));
}

static void narrow_change(uint32_t n, const double *x, const double *y, float *out) {
  for (uint32_t i = 0; i < n; i += 8) store(out + i, load_change(x + i, y + i));
}

static void widen(uint32_t n, const float *x, double *out) {
  for (uint32_t i = 0; i < n; i += 8) store_double(out + i, load(x + i));
}

static void add_widened(uint32_t n, const float *x, double *out) {
  for (uint32_t i = 0; i < n; i += 8) add_double(out + i, load(x + i));
}

static bool penetrate(uint32_t n, float side, const float *w, const double *v, const double *v_last,
                      const double *rest_load, const double *y, double *b) {
  Lanes deepest = all(-1.0f);
  for (uint32_t i = 0; i < n; i += 8) {
    const Lanes moved = subtract(scale(load(w + i), side), load_change(v + i, v_last + i));
    const Lanes change = add(moved, load_double(rest_load + i)), before = load_double(y + i);
    store_double(b + i, change);
    deepest = larger(larger(before, add(before, change)), deepest);
  }
  return any(greater(deepest, all(-TB_NEAR)));
}

/* `blocks` blocks of eight side by side; `blocks` is a constant at every call. */
static INLINE void combine_blocks(uint32_t blocks, uint32_t count, const float *f,
                                  const float *const *x, uint32_t at, float *out) {
  Lanes sum[4];
  for (uint32_t b = 0; b < blocks; b++) sum[b] = zero();
  for (uint32_t row = 0; row < count; row++) {
    UNROLL(4)
    for (uint32_t b = 0; b < blocks; b++) {
      sum[b] = add(sum[b], scale(load(x[row] + at + 8 * b), f[row]));
    }
  }
  for (uint32_t b = 0; b < blocks; b++) store(out + at + 8 * b, sum[b]);
}

static void sum_scaled(uint32_t n, uint32_t count, const float *f, const float *const *x,
                       float *out) {
  uint32_t at = 0;
  for (; at + 32 <= n; at += 32) combine_blocks(4, count, f, x, at, out);
  for (; at < n; at += 8) combine_blocks(1, count, f, x, at, out);
}

#endif
