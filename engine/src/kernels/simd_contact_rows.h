/* SPDX-License-Identifier: MIT */
/* The contact solve's passes over rows (a row is one contact) in the precision of simd_lanes.h.
 * kernels_tmpl.h describes each pass. For kernels_tmpl.c alone. */
#ifndef TB_SIMD_CONTACT_ROWS_H
#define TB_SIMD_CONTACT_ROWS_H

#include "kernels/kernels.h"
#include "kernels/simd_lanes.h"

typedef TYPE_OF(TbStart) Start;
typedef TYPE_OF(TbEnd) End;
typedef TYPE_OF(TbResidual) Residual;
typedef TYPE_OF(TbBalance) Balance;

static void start(uint32_t n, Start *whole) {
  const Start copy = *whole, *at = &copy; /* no store changes the copy */
  Lanes change = zero(), deepest = zero();
  for (uint64_t i = 0; i < n; i += 8) {
    const Lanes b = load_double(at->from_b + i), y = load_double(at->from_y + i);
    const Lanes f = load_double(at->from_f + i);
    store(at->s + i, load_change(at->from_b + i, at->from_p + i));
#ifdef TB_FLOAT
    store(at->b + i, b);
    store(at->y + i, y);
    store(at->root + i, root(larger(y, zero())));
    store(at->own + i, load_double(at->from_own + i));
#endif
    store(at->f + i, f);
    store(at->p + i, load_double(at->from_p + i));
    change = larger(size_of(b), change);
    deepest = larger(y, deepest);
  }
  whole->change = largest_of(change);
  whole->depth = largest_of(deepest);
}

static void end(uint32_t n, End *whole) {
  const End copy = *whole, *at = &copy;
  Lanes sum = zero(), touching = zero();
  for (uint64_t i = 0; i < n; i += 8) {
    const Lanes f = load(at->f + i), p = load(at->p + i);
    const Lanes moved = add(p, scale(subtract(p, load(at->p_last + i)), at->t));
    const Lanes s = subtract(load(at->b + i), moved);
    store_double(at->to_f + i, add(f, scale(subtract(f, load(at->f_last + i)), at->t)));
    store_double(at->to_p + i, moved);
    store_double(at->to_s + i, s);
    sum = add(sum, multiply_lanes(s, subtract(load(at->law + i), load(at->mean + i))));
    touching = add(touching, pick(greater(load(at->slope + i), zero()), all(REAL(1.0)), zero()));
  }
  whole->lost = join(sum);
  whole->touching = (uint32_t)join(touching);
}

static Real change(uint32_t n, const Real *b, const Real *p, Real *s) {
  Lanes most = zero();
  for (uint64_t i = 0; i < n; i += 8) {
    const Lanes left = subtract(load(b + i), load(p + i));
    store(s + i, left);
    most = larger(size_of(left), most);
  }
  return largest_of(most);
}

static Real follow(uint32_t n, const Real *law, const Real *weight, const Real *x, const Real *b,
                   const Real *p, Real *f, Real *s) {
  Lanes most = zero();
  for (uint64_t i = 0; i < n; i += 8) {
    const Lanes change = subtract(load(b + i), load(p + i));
    store(f + i, add(load(law + i), multiply_lanes(load(weight + i), load(x + i))));
    store(s + i, change);
    most = larger(size_of(change), most);
  }
  return largest_of(most);
}

static Residual weigh(uint32_t n, const Real *slope, const Real *s, const Real *b, const Real *p,
                      const Real *p_last, Real *weight, Real *d) {
  Lanes most = zero(), square = zero();
  for (uint64_t i = 0; i < n; i += 8) {
    const Lanes w = root(load(slope + i)), moved = load(p + i);
    const Lanes r =
      SINGLE ? subtract(moved, load(p_last + i)) : add(moved, subtract(load(s + i), load(b + i)));
    const Lanes down = subtract(zero(), multiply_lanes(w, r));
    store(weight + i, w);
    store(d + i, down);
    most = larger(size_of(r), most);
    square = add(square, multiply_lanes(down, down));
  }
  return (Residual){largest_of(most), join(square)};
}

static Balance balance(uint32_t n, Real t, const Real *s_at, const Real *law, const Real *slope,
                       const Real *f_at, const Real *f_last, const Real *p, const Real *p_last) {
  Lanes value = zero(), derivative = zero(), size = zero();
  Lanes miss = zero(), most = zero();
  for (uint64_t i = 0; i < n; i += 8) {
    const Lanes s = load(s_at + i), f = load(f_at + i), g = subtract(f, load(f_last + i));
    const Lanes m = subtract(load(p + i), load(p_last + i)), moved = add(f, scale(g, t));
    const Lanes left = subtract(load(law + i), moved);
    const Lanes bend = multiply_lanes(s, add(multiply_lanes(load(slope + i), m), g));
    value = add(value, multiply_lanes(s, left));
    derivative = subtract(derivative, add(multiply_lanes(m, left), bend));
    size = add(size, size_of(multiply_lanes(s, moved)));
    miss = larger(size_of(left), miss);
    most = larger(size_of(moved), most);
  }
  return (Balance){join(value), join(derivative), join(size), largest_of(miss), largest_of(most)};
}

#endif
