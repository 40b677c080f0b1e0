/* SPDX-License-Identifier: MIT */
/* The passes of the contact solve's usual course (contact_solvef.c), with the laws in them: forces,
 * slopes and means of the laws stay in registers. In single precision alone; for kernels_tmpl.c
 * alone. */
#ifndef TB_SIMD_CONTACT_TRIAL_H
#define TB_SIMD_CONTACT_TRIAL_H

#include "kernels/simd_contact_law.h"
#include "kernels/simd_contact_rows.h"

/* A wire's law, whose power is 0 if it has no vector formula. */
typedef struct WireLaw {
  LawLanes lanes;
  const TbContactLaw *exact;
} WireLaw;

static WireLaw wire_law(const TbContactLaw *law) { return (WireLaw){law_lanes(law), law}; }

typedef struct LawBlock {
  Lanes force, slope, mean;
} LawBlock;

static LawBlock law_of_eight_points(const TbContactLaw *law, Lanes y_at, Lanes s_at) {
  _Alignas(64) float y[8], s[8], force[8], slope[8], mean[8];
  store(y, y_at);
  store(s, s_at);
  law_of_points(law, 8, (LawArrays){y, NULL, s, force, slope, mean});
  return (LawBlock){load(force), load(slope), load(mean)};
}

/* The law at s, for y and its root. `power` is a constant at every call. */
static INLINE LawBlock law_block(const WireLaw *law, uint32_t power, Lanes y, Lanes root_y,
                                 Lanes s) {
  if (power == 0) return law_of_eight_points(law->exact, y, s);
  LawBlock block;
  UNROLL(2)
  for (int i = 0; i < PARTS; i++) {
    const LawVectors at = law_vectors(&law->lanes, power, y.part[i], root_y.part[i], s.part[i]);
    block.force.part[i] = at.force;
    block.slope.part[i] = at.slope;
    block.mean.part[i] = at.mean;
  }
  return block;
}

/* Calls pass(power, ...) with a constant power. */
#define FOR_POWER(law, pass, ...)                                                                  \
  switch (tb_contact_law_power(law)) {                                                             \
  case 2: pass(2, __VA_ARGS__); break;                                                             \
  case 3: pass(3, __VA_ARGS__); break;                                                             \
  case 4: pass(4, __VA_ARGS__); break;                                                             \
  default: pass(0, __VA_ARGS__); break;                                                            \
  }

/* ---- from the last forces to the first try --------------------------------------------------- */

typedef struct Beginning {
  StartSizes sizes;
  Lanes move; /* the largest */
} Beginning;

static INLINE void begin_wire(uint32_t power, const TbContactLaw *contact_law, uint64_t from,
                              uint64_t end, const Start *at, float *f, Beginning *beginning) {
  const WireLaw law = wire_law(contact_law);
  Beginning whole = *beginning;
  for (uint64_t i = from; i < end; i += 8) {
    const StartBlock rows = start_block(at, i, &whole.sizes);
    const LawBlock there = law_block(&law, power, rows.y, rows.root, rows.s);
    const Lanes move = divide(subtract(there.force, rows.f), firmness(there.slope, rows.yield));
    store(f + i, add(rows.f, move));
    whole.move = larger(size_of(move), whole.move);
  }
  *beginning = whole;
}

static float start_newton_diagonal(uint32_t wires, uint32_t lanes, const TbContactLaw *laws_of,
                                   Start *start_of, float *f) {
  const Start copy = *start_of;
  Beginning beginning = {{zero(), zero(), zero()}, zero()};
  for (uint64_t w = 0; w < wires; w++) {
    FOR_POWER(&laws_of[w], begin_wire, &laws_of[w], w * lanes, (w + 1) * lanes, &copy, f,
              &beginning)
  }
  give_sizes(&beginning.sizes, start_of);
  return largest_of(beginning.move);
}

/* ---- a try ----------------------------------------------------------------------------------- */

typedef struct TrialSums {
  Lanes value, derivative, size, miss, way, lost, touching;
} TrialSums;

/* Neither a contact nor a force, now and before: such rows add nothing to a balance. */
static INLINE bool is_idle(Lanes y, Lanes s, Lanes f, Lanes f_last) {
  const Lanes force = larger(size_of(f), size_of(f_last));
  return !any(greater(larger(larger(y, add(y, s)), force), zero()));
}

/* A block's terms of the balance, as in balance_of(). `first` is a constant at every call. */
static INLINE void add_terms(bool first, const TbTrial *at, uint64_t i, Lanes s, Lanes m, Lanes f,
                             Lanes f_last, const LawBlock *law, TrialSums *sums) {
  const Lanes g = subtract(f, f_last), moved = first ? f : add(f, scale(g, at->t));
  const Lanes left = subtract(law->force, moved);
  const Lanes bend = multiply_lanes(s, add(multiply_lanes(law->slope, m), g));
  sums->value = add(sums->value, multiply_lanes(s, left));
  sums->derivative = subtract(sums->derivative, add(multiply_lanes(m, left), bend));
  sums->size = add(sums->size, size_of(multiply_lanes(s, moved)));
  sums->lost = add(sums->lost, multiply_lanes(s, subtract(law->force, law->mean)));
  sums->touching = add(sums->touching, pick(greater(law->slope, zero()), all(REAL(1.0)), zero()));
  if (!first) return;
  sums->miss = larger(divide(size_of(left), firmness(law->slope, load(at->yield + i))), sums->miss);
}

static INLINE void try_wire(uint32_t power, bool first, const TbContactLaw *contact_law,
                            uint64_t from, uint64_t end, const TbTrial *at, TrialSums *sums) {
  const WireLaw law = wire_law(contact_law);
  TrialSums whole = *sums;
  for (uint64_t i = from; i < end; i += 8) {
    const Lanes p = load(at->p + i), m = subtract(p, load(at->p_last + i));
    const Lanes change = subtract(load(at->b + i), p);
    const Lanes s = first ? change : add(change, scale(m, -at->t));
    const Lanes y = load(at->y + i), f = load(at->f + i), f_last = load(at->f_last + i);
    if (first) whole.way = larger(size_of(s), whole.way);
    if (is_idle(y, s, f, f_last)) continue;
    const LawBlock there = law_block(&law, power, y, load(at->root + i), s);
    add_terms(first, at, i, s, m, f, f_last, &there, &whole);
  }
  *sums = whole;
}

static INLINE void try_wires(bool first, TbTrial *trial) {
  const TbTrial copy = *trial;
  TrialSums sums = {zero(), zero(), zero(), zero(), zero(), zero(), zero()};
  for (uint64_t w = 0; w < copy.wires; w++) {
    FOR_POWER(&copy.laws[w], try_wire, first, &copy.laws[w], w * copy.lanes, (w + 1) * copy.lanes,
              &copy, &sums)
  }
  trial->balance =
    (Balance){join(sums.value), join(sums.derivative), join(sums.size), largest_of(sums.miss)};
  trial->way = largest_of(sums.way);
  trial->lost = join(sums.lost);
  trial->touching = (uint32_t)join(sums.touching);
}

static void trial_at_forces(TbTrial *trial) { try_wires(true, trial); }

static void trial_moved(TbTrial *trial) { try_wires(false, trial); }

/* ---- the end --------------------------------------------------------------------------------- */

static void finish_forces(uint32_t n, const End *whole) {
  const End copy = *whole, *at = &copy; /* no store changes the copy */
  for (uint64_t i = 0; i < n; i += 8) {
    const Lanes f = load(at->f + i), p = load(at->p + i);
    const Lanes moved = add(p, scale(subtract(p, load(at->p_last + i)), at->t));
    store_double(at->to_f + i, add(f, scale(subtract(f, load(at->f_last + i)), at->t)));
    store_double(at->to_p + i, moved);
    store_double(at->to_s + i, subtract(load(at->b + i), moved));
  }
}

#endif
