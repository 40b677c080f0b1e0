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

/* The largest |b|, y and |f| so far. */
typedef struct StartSizes {
  Lanes change, depth, force;
} StartSizes;

/* The start of a block of rows. */
typedef struct StartBlock {
  Lanes s, y, f;
#ifdef TB_FLOAT
  Lanes root, yield;
#endif
} StartBlock;

static INLINE StartBlock start_block(const Start *at, uint64_t i, StartSizes *sizes) {
  const Lanes b = load_double(at->from_b + i);
  StartBlock rows = {.s = load_change(at->from_b + i, at->from_p + i),
                     .y = load_double(at->from_y + i),
                     .f = load_double(at->from_f + i)};
#ifdef TB_FLOAT
  const Lanes compliance = load_double(at->from_contact_compliance + i);
  rows.root = root(larger(rows.y, zero()));
  rows.yield = add(compliance, load(at->head + i));
  store(at->b + i, b);
  store(at->y + i, rows.y);
  store(at->root + i, rows.root);
  store(at->contact_compliance + i, compliance);
  store(at->yield + i, rows.yield);
  sizes->force = larger(size_of(rows.f), sizes->force);
#endif
  store(at->f + i, rows.f);
  store(at->p + i, load_double(at->from_p + i));
  sizes->change = larger(size_of(b), sizes->change);
  sizes->depth = larger(rows.y, sizes->depth);
  return rows;
}

static INLINE void give_sizes(const StartSizes *sizes, Start *start) {
  start->change = largest_of(sizes->change);
  start->depth = largest_of(sizes->depth);
#ifdef TB_FLOAT
  start->force = largest_of(sizes->force);
#endif
}

static void start(uint32_t n, Start *whole) {
  const Start copy = *whole, *at = &copy; /* no store changes the copy */
  StartSizes sizes = {zero(), zero(), zero()};
  for (uint64_t i = 0; i < n; i += 8) store(at->s + i, start_block(at, i, &sizes).s);
  give_sizes(&sizes, whole);
}

static void finish(uint32_t n, End *whole) {
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

static Real newton_finish(uint32_t n, const Real *law, const Real *weight, const Real *x,
                          const Real *b, const Real *p, Real *f, Real *s) {
  Lanes most = zero();
  for (uint64_t i = 0; i < n; i += 8) {
    const Lanes change = subtract(load(b + i), load(p + i));
    store(f + i, add(load(law + i), multiply_lanes(load(weight + i), load(x + i))));
    store(s + i, change);
    most = larger(size_of(change), most);
  }
  return largest_of(most);
}

/* Compliance of a contact and of the surface below it: 1 + slope yield. */
static INLINE Lanes firmness(Lanes slope, Lanes yield) {
  return add(all(REAL(1.0)), multiply_lanes(slope, yield));
}

#ifdef TB_FLOAT
static float newton_diagonal(uint32_t n, const float *law, const float *slope, const float *yield,
                             float *f, float *weight, float *x) {
  Lanes most = zero();
  for (uint32_t i = 0; i < n; i += 8) {
    const Lanes steep = load(slope + i), soft = load(yield + i), w = root(steep);
    const Lanes before = load(f + i);
    const Lanes move = divide(subtract(load(law + i), before), firmness(steep, soft));
    store(weight + i, w);
    store(x + i, subtract(zero(), multiply_lanes(multiply_lanes(w, soft), move)));
    store(f + i, add(before, move));
    most = larger(size_of(move), most);
  }
  return largest_of(most);
}

static Residual newton_residual(uint32_t n, const float *slope, const float *yield,
                                const float *weight, const float *x, const float *p,
                                const float *before, float *r, float *d) {
  Lanes most = zero(), square = zero();
  for (uint32_t i = 0; i < n; i += 8) {
    const Lanes w = load(weight + i), firm = firmness(load(slope + i), load(yield + i));
    const Lanes moved = subtract(load(p + i), load(before + i));
    const Lanes left = subtract(zero(), add(load(x + i), multiply_lanes(w, moved)));
    store(r + i, left);
    store(d + i, left);
    most = larger(size_of(divide(multiply_lanes(w, left), firm)), most);
    square = add(square, multiply_lanes(left, left));
  }
  return (Residual){largest_of(most), join(square)};
}
#else
static Residual newton_rhs(uint32_t n, const Real *slope, const Real *s, const Real *b,
                           const Real *p, Real *weight, Real *d) {
  Lanes most = zero(), square = zero();
  for (uint64_t i = 0; i < n; i += 8) {
    const Lanes w = root(load(slope + i));
    const Lanes r = add(load(p + i), subtract(load(s + i), load(b + i)));
    const Lanes down = subtract(zero(), multiply_lanes(w, r));
    store(weight + i, w);
    store(d + i, down);
    most = larger(size_of(r), most);
    square = add(square, multiply_lanes(down, down));
  }
  return (Residual){largest_of(most), join(square)};
}
#endif

/* `with_miss` is a constant at every call. */
static INLINE Balance balance_of(bool with_miss, uint32_t n, Real t, const Real *yield,
                                 const Real *s_at, const Real *law, const Real *slope,
                                 const Real *f_at, const Real *f_last, const Real *p,
                                 const Real *p_last) {
  Lanes value = zero(), derivative = zero(), size = zero();
  Lanes miss = zero();
  for (uint64_t i = 0; i < n; i += 8) {
    const Lanes s = load(s_at + i), f = load(f_at + i), g = subtract(f, load(f_last + i));
    const Lanes m = subtract(load(p + i), load(p_last + i)), moved = add(f, scale(g, t));
    const Lanes left = subtract(load(law + i), moved);
    const Lanes bend = multiply_lanes(s, add(multiply_lanes(load(slope + i), m), g));
    value = add(value, multiply_lanes(s, left));
    derivative = subtract(derivative, add(multiply_lanes(m, left), bend));
    size = add(size, size_of(multiply_lanes(s, moved)));
    if (!with_miss) continue;
    miss = larger(SINGLE ? divide(size_of(left), firmness(load(slope + i), load(yield + i)))
                         : size_of(left),
                  miss);
  }
  return (Balance){join(value), join(derivative), join(size), largest_of(miss)};
}

static Balance balance(uint32_t n, Real t, const Real *yield, const Real *s, const Real *law,
                       const Real *slope, const Real *f, const Real *f_last, const Real *p,
                       const Real *p_last) {
  if (SINGLE && !yield) return balance_of(false, n, t, yield, s, law, slope, f, f_last, p, p_last);
  return balance_of(true, n, t, yield, s, law, slope, f, f_last, p, p_last);
}

#endif
