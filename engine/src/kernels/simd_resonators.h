/* SPDX-License-Identifier: MIT */
/* The high band's loops in the precision of simd_lanes.h. For kernels_tmpl.c alone. */
#ifndef TB_SIMD_RESONATORS_H
#define TB_SIMD_RESONATORS_H

#include "kernels/kernels.h"
#include "kernels/simd_lanes.h"
#include "kernels/simd_rows.h"

typedef TYPE_OF(TbRing) Ring;

/* Takes `r` by value: the compiler would have to assume that a store to `next` changes *r. */
static INLINE void ring_part(bool pushed, bool held, Ring r, uint32_t from, uint32_t end,
                             Lanes sum[2]) {
  for (uint64_t i = from; i < end; i += 8) {
    const Lanes last = load(r.last + i);
    Lanes next =
      subtract(multiply_lanes(load(r.a + i), load(r.now + i)), multiply_lanes(load(r.b + i), last));
    if (pushed) next = add(next, scale(load_float(r.push + i), r.share));
    if (held) {
      next = add(next, multiply_lanes(load(r.held + i), subtract(last, next)));
    }
    store(r.next + i, next);
    sum[0] = add(sum[0], multiply_lanes(load(r.ahead + i), next));
    sum[1] = add(sum[1], multiply_lanes(load(r.behind + i), next));
  }
}

static TbPair resonate(const Ring *r) {
  Lanes sum[2] = {zero(), zero()};
  uint32_t from = 0;
  for (uint32_t i = 0; i < r->parts.count; i++) {
    const TbRingPart part = r->parts.part[i];
    switch (part.pushed + 2 * part.held) { /* one copy of the code for each */
    case 0: ring_part(false, false, *r, from, part.end, sum); break;
    case 1: ring_part(true, false, *r, from, part.end, sum); break;
    case 2: ring_part(false, true, *r, from, part.end, sum); break;
    default: ring_part(true, true, *r, from, part.end, sum); break;
    }
    from = part.end;
  }
  return (TbPair){(double)join(sum[0]), (double)join(sum[1])};
}

/* cos and sin of a turn, 2 r cos = a; one that is none has a sine of 0. */
typedef struct Turn {
  Lanes c, s;
} Turn;

static INLINE Turn turn_of(Lanes a, Lanes r) {
  const Lanes c = divide(scale(a, REAL(0.5)), r);
  return (Turn){c, root(larger(subtract(all(REAL(1.0)), multiply_lanes(c, c)), zero()))};
}

/* Turned further by a small angle: the sine that is used is angle^4/120 of it too small. */
static INLINE Turn turned(Turn turn, Lanes angle) {
  const Lanes square = multiply_lanes(angle, angle), one = all(REAL(1.0));
  const Lanes s = multiply_lanes(angle, subtract(one, scale(square, REAL(1.0 / 6.0))));
  const Lanes c = root(subtract(one, multiply_lanes(s, s)));
  return (Turn){subtract(multiply_lanes(turn.c, c), multiply_lanes(turn.s, s)),
                add(multiply_lanes(turn.s, c), multiply_lanes(turn.c, s))};
}

/* A mode that turns by less hardly swings, or does not at all. */
static const Real LEAST_SINE = REAL(1e-3);

/* The instants n and n - 1 are A cos p and A cos(p - turn)/r. */
static void turn_phases(const TYPE_OF(TbScattering) * scattering) {
  const Lanes r = root(load(scattering->b)), walk = load(scattering->walk);
  const Lanes now = load(scattering->now), last = load(scattering->last),
              turn = load(scattering->turn);
  const Lanes most = root(add(walk, scale(load(scattering->held), scattering->wires)));
  const Turn before = turn_of(turn, r);
  const Turn after =
    turned(turn_of(load(scattering->a), r), multiply_lanes(most, load(scattering->draw)));
  const Lanes sine =
    divide(subtract(multiply_lanes(r, last), multiply_lanes(now, before.c)), before.s);
  const Lanes moved = divide(add(multiply_lanes(now, after.c), multiply_lanes(sine, after.s)), r);
  const Mask swings = greater(smaller(before.s, after.s), all(LEAST_SINE)),
             walks = greater(walk, zero());
  store(scattering->last, pick(walks, pick(swings, moved, last), last));
  store(scattering->turn,
        pick(walks, pick(swings, scale(multiply_lanes(r, after.c), REAL(2.0)), turn), turn));
}

/* Compilers of WebAssembly read all of a loop's body before they compute. Twelve registers of
 * doubles and eight of sums are more than a processor has, and the sums would live in memory. */
#if defined(__wasm_simd128__) && !defined(TB_FLOAT)
static TbPair two_dots(uint32_t n, const Real *u, const Real *v, const Real *x) {
  return (TbPair){dot(n, u, x), dot(n, v, x)};
}
#else
static TbPair two_dots(uint32_t n, const Real *u, const Real *v, const Real *x) {
  Lanes first = zero(), second = zero();
  for (uint64_t i = 0; i < n; i += 8) {
    const Lanes value = load(x + i);
    first = add(first, multiply_lanes(load(u + i), value));
    second = add(second, multiply_lanes(load(v + i), value));
  }
  return (TbPair){(double)join(first), (double)join(second)};
}
#endif

#endif
