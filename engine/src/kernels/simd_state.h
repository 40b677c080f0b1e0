/* SPDX-License-Identifier: MIT */
/* The kernels that exist in double alone: the state of modes and wires. For kernels_tmpl.c
 * alone. */
#ifndef TB_SIMD_STATE_H
#define TB_SIMD_STATE_H

#include "kernels/kernels.h"
#include "kernels/simd_lanes.h"

static void two_step(uint32_t n, double *out, const double *a, const double *x, const double *b,
                     const double *y) {
  for (uint64_t i = 0; i < n; i += 8) {
    store(out + i, subtract(multiply_lanes(load(a + i), load(x + i)),
                            multiply_lanes(load(b + i), load(y + i))));
  }
}

/* ---- heads that stretch ---------------------------------------------------------------------- */

/* In the functions of this part, `steps` and `mixed` are constants at every call. `steps`: whether
 * next is computed or read. They read a copy of the struct, or the compiler would have to assume
 * that a store changes it. */
static INLINE Lanes next_of(bool steps, const TbStretching *s, uint64_t i, Lanes q, Lanes last) {
  if (!steps) return load(s->next + i);
  const Lanes next =
    subtract(multiply_lanes(load(s->a + i), q), multiply_lanes(load(s->b + i), last));
  store(s->next + i, next);
  return next;
}

/* G q, `mixed`: of modes that mix with others. */
static INLINE Lanes stretch_of(bool mixed, const TbStretching *s, uint32_t head, uint64_t i,
                               Lanes q) {
  const Lanes own = multiply_lanes(load(s->gain[head] + i), q);
  return mixed ? add(own, load(s->mixed[head] + i)) : own;
}

/* Modes that stretch both heads. */
static INLINE void stretch_both(bool steps, bool mixed, uint64_t from, uint64_t end,
                                const TbStretching *out, Lanes along[TB_COUPLINGS], Lanes own[3]) {
  const TbStretching s = *out;
  Lanes a0 = along[0], a1 = along[1], o0 = own[0], o1 = own[1], cross = own[2];
  for (uint64_t i = from; i < end; i += 8) {
    const Lanes q = load(s.q + i), g = load(s.g + i), last = load(s.last + i);
    const Lanes moved = add(next_of(steps, &s, i, q, last), last);
    const Lanes y0 = stretch_of(mixed, &s, 0, i, q), pull0 = multiply_lanes(g, y0);
    const Lanes y1 = stretch_of(mixed, &s, 1, i, q), pull1 = multiply_lanes(g, y1);
    store(s.pull[0] + i, pull0);
    store(s.pull[1] + i, pull1);
    a0 = add(a0, multiply_lanes(y0, moved));
    a1 = add(a1, multiply_lanes(y1, moved));
    o0 = add(o0, multiply_lanes(y0, pull0));
    o1 = add(o1, multiply_lanes(y1, pull1));
    cross = add(cross, multiply_lanes(y1, pull0));
  }
  along[0] = a0, along[1] = a1, own[0] = o0, own[1] = o1, own[2] = cross;
}

/* Modes that stretch one head. */
static INLINE void stretch_one(bool steps, bool mixed, uint64_t from, uint64_t end,
                               const TbStretching *out, uint32_t head, Lanes *along, Lanes *own) {
  const TbStretching s = *out;
  double *const to = s.pull[head];
  Lanes a = *along, o = *own;
  for (uint64_t i = from; i < end; i += 8) {
    const Lanes q = load(s.q + i), last = load(s.last + i);
    const Lanes moved = add(next_of(steps, &s, i, q, last), last);
    const Lanes y = stretch_of(mixed, &s, head, i, q);
    const Lanes pull = multiply_lanes(load(s.g + i), y);
    store(to + i, pull);
    a = add(a, multiply_lanes(y, moved));
    o = add(o, multiply_lanes(y, pull));
  }
  *along = a, *own = o;
}

/* Modes that stretch no head. */
static INLINE void stretch_none(bool steps, uint64_t from, uint64_t end, const TbStretching *s) {
  if (steps)
    two_step((uint32_t)(end - from), s->next + from, s->a + from, s->q + from, s->b + from,
             s->last + from);
}

static INLINE void stretch_parts(bool steps, const TbParts *parts, TbStretching *s) {
  Lanes along[TB_COUPLINGS] = {zero(), zero()}, own[3] = {zero(), zero(), zero()};
  for (uint32_t part = 0; part < parts->count; part++) {
    const uint64_t from = parts->from[part], end = from + parts->size[part];
    const uint64_t middle = from + parts->mixed[part];
    if (parts->heads[part] == 3) {
      stretch_both(steps, true, from, middle, s, along, own);
      stretch_both(steps, false, middle, end, s, along, own);
    } else if (parts->heads[part]) {
      const uint32_t head = parts->heads[part] - 1u;
      stretch_one(steps, true, from, middle, s, head, &along[head], &own[head]);
      stretch_one(steps, false, middle, end, s, head, &along[head], &own[head]);
    }
    stretch_none(steps, end, parts->end[part], s);
  }
  for (uint32_t h = 0; h < 2; h++) {
    s->along[h] = join(along[h]);
    s->own[h][h] = join(own[h]);
  }
  s->own[0][1] = s->own[1][0] = join(own[2]);
}

static void stretch(const TbParts *parts, TbStretching *s) { stretch_parts(false, parts, s); }

static void step_and_stretch(const TbParts *parts, TbStretching *s) {
  stretch_parts(true, parts, s);
}

static INLINE Lanes dot_of_part(uint64_t from, uint64_t end, const double *pull, const double *x,
                                Lanes sum) {
  for (uint64_t i = from; i < end; i += 8) {
    sum = add(sum, multiply_lanes(load(pull + i), load(x + i)));
  }
  return sum;
}

static TbPair stretch_dots(const TbParts *parts, const double *const pull[TB_COUPLINGS],
                           const double *x) {
  const double *const u = pull[0], *const v = pull[1];
  Lanes first = zero(), second = zero();
  for (uint32_t part = 0; part < parts->count; part++) {
    const uint64_t from = parts->from[part], end = from + parts->size[part];
    if (parts->heads[part] == 3) {
      for (uint64_t i = from; i < end; i += 8) {
        const Lanes value = load(x + i);
        first = add(first, multiply_lanes(load(u + i), value));
        second = add(second, multiply_lanes(load(v + i), value));
      }
    } else if (parts->heads[part] == 1) {
      first = dot_of_part(from, end, u, x, first);
    } else if (parts->heads[part] == 2) {
      second = dot_of_part(from, end, v, x, second);
    }
  }
  return (TbPair){join(first), join(second)};
}

/* ---- the end of a step ----------------------------------------------------------------------- */

typedef struct EndSums {
  Lanes lost[3], ahead, behind;
} EndSums;

/* `heads`, whose stretching moves these modes, and `origins` are constants at every call. */
static INLINE void end_part(uint32_t heads, uint32_t origins, uint64_t from, uint64_t end,
                            const TbModesEnd *at, EndSums *out) {
  EndSums sums = *out;
  for (uint64_t i = from; i < end; i += 8) {
    Lanes next = load(at->next + i);
    if (heads & 1u) next = add(next, scale(load(at->pull[0] + i), at->stretch[0]));
    if (heads & 2u) next = add(next, scale(load(at->pull[1] + i), at->stretch[1]));
    if (heads) store(at->next + i, next);
    const Lanes step = subtract(next, load(at->last + i)), square = multiply_lanes(step, step);
    UNROLL(3)
    for (uint32_t j = 0; j < origins; j++) {
      sums.lost[j] = add(sums.lost[j], multiply_lanes(load(at->loss[j] + i), square));
    }
    sums.ahead = add(sums.ahead, multiply_lanes(load(at->ahead + i), next));
    sums.behind = add(sums.behind, multiply_lanes(load(at->behind + i), next));
  }
  *out = sums;
}

static INLINE void end_parts(uint32_t origins, const TbParts *parts, const TbModesEnd *at,
                             EndSums *sums) {
  for (uint32_t part = 0; part < parts->count; part++) {
    const uint32_t heads = at->stretched ? parts->heads[part] : 0u;
    const uint64_t from = parts->from[part], all = parts->end[part];
    const uint64_t end = heads ? from + parts->size[part] : from;
    if (heads == 1) end_part(1, origins, from, end, at, sums);
    if (heads == 2) end_part(2, origins, from, end, at, sums);
    if (heads == 3) end_part(3, origins, from, end, at, sums);
    if (end < all) end_part(0, origins, end, all, at, sums);
  }
}

static void end_modes(const TbParts *parts, TbModesEnd *whole) {
  const TbModesEnd copy = *whole;
  EndSums sums = {{zero(), zero(), zero()}, zero(), zero()};
  if (copy.origins == 3) {
    end_parts(3, parts, &copy, &sums);
  } else {
    end_parts(2, parts, &copy, &sums);
  }
  for (uint32_t j = 0; j < 3; j++) whole->lost[j] = join(sums.lost[j]);
  whole->heard = (TbPair){join(sums.ahead), join(sums.behind)};
}

static void push_by_sound(const TbParts *parts, TbPair sound, const double *now,
                          const double *before, const double *g, double *next) {
  for (uint32_t part = 0; part < parts->count; part++) {
    for (uint64_t i = parts->from[part]; i < parts->end[part]; i += 8) {
      const Lanes force =
        add(scale(load(now + i), sound.first), scale(load(before + i), sound.second));
      store(next + i, add(load(next + i), multiply_lanes(load(g + i), force)));
    }
  }
}

/* In the order of end_modes(), whose sums these are. */
static TbPair two_dots_of_parts(const TbParts *parts, const double *ahead, const double *behind,
                                const double *q) {
  Lanes first = zero(), second = zero();
  for (uint32_t part = 0; part < parts->count; part++) {
    for (uint64_t i = parts->from[part]; i < parts->end[part]; i += 8) {
      const Lanes value = load(q + i);
      first = add(first, multiply_lanes(load(ahead + i), value));
      second = add(second, multiply_lanes(load(behind + i), value));
    }
  }
  return (TbPair){join(first), join(second)};
}

static double weighted_size(uint32_t n, const double *c, const double *x) {
  Lanes sum = zero();
  for (uint64_t i = 0; i < n; i += 8) {
    sum = add(sum, multiply_lanes(load(c + i), size_of(load(x + i))));
  }
  return join(sum);
}

static INLINE void losses_of(uint32_t count, uint32_t n, const double *const w[3],
                             const double *next, const double *last, double sums[3]) {
  Lanes sum[3] = {zero(), zero(), zero()};
  for (uint64_t i = 0; i < n; i += 8) {
    const Lanes step = subtract(load(next + i), load(last + i));
    const Lanes square = multiply_lanes(step, step);
    for (uint32_t j = 0; j < count; j++) {
      sum[j] = add(sum[j], multiply_lanes(load(w[j] + i), square));
    }
  }
  for (uint32_t j = 0; j < count; j++) sums[j] = join(sum[j]);
}

static void losses(uint32_t n, uint32_t count, const double *const w[3], const double *next,
                   const double *last, double sums[3]) {
  if (count == 3) {
    losses_of(3, n, w, next, last, sums);
  } else {
    losses_of(2, n, w, next, last, sums);
  }
}

static void subtract_arrays(uint32_t n, const double *x, const double *y, double *out) {
  for (uint64_t i = 0; i < n; i += 8) store(out + i, subtract(load(x + i), load(y + i)));
}

static INLINE Lanes second_difference(const double *v) {
  const Lanes middle = load(v);
  return add(subtract(load_unaligned(v - 1), middle), subtract(load_unaligned(v + 1), middle));
}

static double radiated_power(uint32_t count, const uint32_t *mode, const double *ahead,
                             const double *behind, const double *next, const double *now,
                             const double *last) {
  Lanes sum = zero();
  for (uint64_t j = 0; j < count; j++) {
    const double at = now[mode[j]];
    sum = add(sum, add(scale(load(ahead + 8u * j), next[mode[j]] - at),
                       scale(load(behind + 8u * j), last[mode[j]] - at)));
  }
  return join(multiply_lanes(sum, sum));
}

static void bend_wires(uint32_t n, const double *inner, const double *v, double *bend) {
  for (uint64_t i = 0; i < n; i += 8) {
    store(bend + i, multiply_lanes(load(inner + i), second_difference(v + i)));
  }
}

static void wire_step(uint32_t wires, uint32_t lanes, const TbWireCoefficients *coefficients,
                      const double *inner, const double *now, const double *last, double *bend,
                      double *next) {
  bend_wires(wires * lanes, inner, now, bend);
  for (uint32_t w = 0; w < wires; w++) {
    const TbWireCoefficients c = coefficients[w];
    for (uint64_t i = w * lanes; i < (w + 1u) * lanes; i += 8) {
      const Lanes curve = load(bend + i);
      Lanes push = scale(curve, c.stretch);
      push = subtract(push, scale(second_difference(bend + i), c.bend));
      push = add(push, scale(subtract(curve, second_difference(last + i)), c.diffuse));
      /* Adds a change to the present value, so that rounding of the position of a wire far from
       * rest adds or takes no energy. */
      const Lanes at = load(now + i), coast = scale(subtract(at, load(last + i)), c.keep);
      store(next + i, multiply_lanes(load(inner + i), add(at, scale(add(coast, push), c.gain))));
    }
  }
}

static double wire_losses(uint32_t wires, uint32_t lanes, const TbWireCoefficients *c,
                          const double *next, const double *last) {
  Lanes sum = zero();
  for (uint32_t w = 0; w < wires; w++) {
    for (uint64_t i = w * lanes; i < (w + 1u) * lanes; i += 8) {
      const Lanes step = subtract(load(next + i), load(last + i));
      const Lanes slope =
        subtract(step, subtract(load_unaligned(next + i - 1), load_unaligned(last + i - 1)));
      sum = add(sum, add(scale(multiply_lanes(step, step), c[w].loss_0),
                         scale(multiply_lanes(slope, slope), c[w].loss_1)));
    }
  }
  return join(sum);
}

static TbWireContacts gather_wires(uint32_t wires, uint32_t lanes, const double *f, const double *s,
                                   double *out) {
  Lanes total = zero(), square = zero(), motion = zero();
  for (uint32_t i = 0; i < lanes; i += 8) {
    Lanes sum = zero();
    for (uint32_t w = 0; w < wires; w++) {
      const Lanes force = load(f + w * lanes + i), change = load(s + w * lanes + i);
      sum = add(sum, force);
      square = add(square, multiply_lanes(force, force));
      motion = add(motion, multiply_lanes(force, multiply_lanes(change, change)));
    }
    total = add(total, sum);
    store(out + i, sum);
  }
  return (TbWireContacts){join(total), join(square), join(motion)};
}

static bool touches(uint32_t n, const double *y, const double *s, const double *f) {
  for (uint64_t i = 0; i < n; i += 8) {
    const Lanes before = load(y + i), after = add(before, load(s + i));
    const Lanes most = larger(larger(before, after), size_of(load(f + i)));
    if (any(greater(most, zero()))) return true;
  }
  return false;
}

static void penetrate(uint32_t wires, uint32_t lanes, double side, const double *shift,
                      const double *w, const double *v, const double *rest, const double *last,
                      const double *load_at, double *b) {
  for (uint32_t wire = 0; wire < wires; wire++) {
    const Lanes shifted = all(shift[wire]);
    for (uint64_t i = wire * lanes; i < (wire + 1u) * lanes; i += 8) {
      const Lanes deviation = subtract(scale(load(w + i), side), load(v + i));
      const Lanes eta = add(add(deviation, load(rest + i)), shifted);
      store(b + i, add(subtract(eta, load(last + i)), load(load_at + i)));
    }
  }
}

static void move_wires(uint32_t n, const double *contact_compliance, const double *f,
                       const double *rest, const double *last, const double *s, double *v,
                       double *eta) {
  for (uint64_t i = 0; i < n; i += 8) {
    const Lanes change = subtract(load(f + i), load(rest + i));
    store(v + i, add(load(v + i), multiply_lanes(load(contact_compliance + i), change)));
    store(eta + i, add(load(last + i), load(s + i)));
  }
}

#endif
