/* SPDX-License-Identifier: MIT */
/* Passes over vectors in the precision of simd_lanes.h. kernels_tmpl.h describes each pass. For
 * kernels_tmpl.c alone. */
#ifndef TB_SIMD_ROWS_H
#define TB_SIMD_ROWS_H

#include "kernels/simd_lanes.h"

static Real dot(uint32_t n, const Real *x, const Real *y) {
  Lanes sum = zero();
  for (uint64_t i = 0; i < n; i += 8) sum = add(sum, multiply_lanes(load(x + i), load(y + i)));
  return join(sum);
}

static void axpy(uint32_t n, Real *out, Real f, const Real *x) {
  for (uint64_t i = 0; i < n; i += 8) store(out + i, add(load(out + i), scale(load(x + i), f)));
}

static void add_product(uint32_t n, Real *out, const Real *x, const Real *y) {
  for (uint64_t i = 0; i < n; i += 8) {
    store(out + i, add(load(out + i), multiply_lanes(load(x + i), load(y + i))));
  }
}

static Real difference(uint32_t n, const Real *x, const Real *y) {
  Lanes most = zero();
  for (uint64_t i = 0; i < n; i += 8)
    most = larger(size_of(subtract(load(x + i), load(y + i))), most);
  return largest_of(most);
}

static void extrapolate(uint32_t n, Real t, const Real *x, const Real *before, const Real *base,
                        Real *out) {
  for (uint64_t i = 0; i < n; i += 8) {
    store(out + i, add(load(base + i), scale(subtract(load(x + i), load(before + i)), t)));
  }
}

static void product(uint32_t n, Real *out, const Real *x, const Real *y) {
  for (uint64_t i = 0; i < n; i += 8) store(out + i, multiply_lanes(load(x + i), load(y + i)));
}

static Real cg_apply(uint32_t n, Real *out, const Real *d, const Real *w, const Real *m) {
  Lanes sum = zero();
  for (uint64_t i = 0; i < n; i += 8) {
    const Lanes direction = load(d + i);
    const Lanes turned = add(direction, multiply_lanes(load(w + i), load(m + i)));
    store(out + i, turned);
    sum = add(sum, multiply_lanes(direction, turned));
  }
  return join(sum);
}

static Real cg_advance(uint32_t n, Real t, Real *p, const Real *d, Real *r, const Real *m) {
  Lanes sum = zero();
  for (uint64_t i = 0; i < n; i += 8) {
    store(p + i, add(load(p + i), scale(load(d + i), t)));
    const Lanes left = subtract(load(r + i), scale(load(m + i), t));
    store(r + i, left);
    sum = add(sum, multiply_lanes(left, left));
  }
  return join(sum);
}

static void xpby(uint32_t n, Real t, Real *d, const Real *r) {
  for (uint64_t i = 0; i < n; i += 8) store(d + i, add(load(r + i), scale(load(d + i), t)));
}

#endif
