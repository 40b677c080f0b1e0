/* SPDX-License-Identifier: MIT */
/* The formulas of contact_law.h on whole registers, for an exponent of 1, 3/2 or 2 (power 2, 3 or
 * 4), in the precision of simd_lanes.h. For kernels_tmpl.c alone. */
#ifndef TB_SIMD_CONTACT_LAW_H
#define TB_SIMD_CONTACT_LAW_H

#include <stddef.h>

#include "kernels/contact_law.h"
#include "kernels/simd_lanes.h"

/* NEGLIGIBLE is smaller than any relevant value. A change of penetration below the fraction
 * SMALL_CHANGE of the penetration counts as small: differences are rounding noise there. */
#ifdef TB_FLOAT
#  define NEGLIGIBLE 1e-30f
#  define SMALL_CHANGE 1e-2f
#else
#  define NEGLIGIBLE 1e-250
#  define SMALL_CHANGE 1e-5
#endif

/* These functions work on one register at a time: a law needs more values at once than there are
 * registers for eight lanes. A lane is one number of a register. */

static INLINE Vector none(void) { return (Vector){0}; }
static INLINE Vector every(Real value) { return none() + value; }
static INLINE Vector vector_size_of(Vector x) { return vector_larger(x, none() - x); }
static INLINE Vector read(const Real *p) { return *(const Vector *)(const void *)p; }
static INLINE void write(Real *p, Vector x) { *(Vector *)(void *)p = x; }

/* x where x > 0, otherwise 1: a safe divisor. */
static INLINE Vector divisor(Vector x) {
  return vector_pick(vector_greater(x, none()), x, every(REAL(1.0)));
}

/* eta^(power/2) for eta >= 0 */
static INLINE Vector raise(uint32_t power, Vector eta) {
  if (power == 2) return eta;
  return eta * (power == 3 ? vector_root(eta) : eta);
}

/* Mean of eta^(power/2) over (x, y), both >= 0. */
static INLINE Vector mean_power(uint32_t power, Vector x, Vector y) {
  if (power == 2) return REAL(0.5) * (x + y);
  const Vector square = x * x + x * y + y * y;
  if (power == 4) return square * (REAL(1.0 / 3.0));
  const Vector p = vector_root(x), q = vector_root(y);
  return REAL(0.4) * (square + p * q * (x + y)) / divisor(p + q);
}

/* A TbContactLaw in this precision. */
typedef struct LawLanes {
  Real stiffness, loss, limit, limit_force, limit_slope;
} LawLanes;

static INLINE LawLanes law_lanes(const TbContactLaw *law) {
  return (LawLanes){(Real)law->stiffness, (Real)law->loss, (Real)law->limit, (Real)law->limit_force,
                    (Real)law->limit_slope};
}

typedef struct Knee {
  Vector at, force, slope;
} Knee;

/* V' */
static INLINE Vector static_force(const LawLanes *law, uint32_t power, Knee knee, Vector eta) {
  const Vector below = vector_smaller(vector_larger(eta, none()), knee.at);
  const Vector inside = law->stiffness * raise(power, below);
  const Vector beyond = knee.force + knee.slope * (eta - knee.at);
  return vector_pick(vector_greater(eta, knee.at), beyond, inside);
}

/* V'' */
static INLINE Vector curvature(const LawLanes *law, uint32_t power, Knee knee, Vector eta) {
  const Vector touching = vector_larger(eta, none());
  Vector inside = every(law->stiffness);
  if (power == 3) inside = REAL(1.5) * law->stiffness * vector_root(touching);
  if (power == 4) inside = REAL(2.0) * law->stiffness * touching;
  inside = vector_pick(vector_greater(eta, none()), inside, none());
  return vector_pick(vector_greater(eta, knee.at), knee.slope, inside);
}

/* Mean of V' between lo and hi. If one piece of V' covers the interval, its mean is used directly,
 * so equal ends need no division. */
static INLINE Vector mean_force(const LawLanes *law, uint32_t power, Knee knee, Vector lo,
                                Vector hi) {
  const Vector from = vector_larger(lo, none()), top = vector_smaller(hi, knee.at);
  const Vector power_top = vector_larger(top, none()), power_from = vector_smaller(from, power_top);
  const Vector power_mean = law->stiffness * mean_power(power, power_from, power_top);
  const Vector start = vector_larger(from, knee.at), end = vector_larger(hi, start);
  const Vector line_mean = knee.force + knee.slope * (REAL(0.5) * (start + end) - knee.at);
  const Vector work = (power_top - power_from) * power_mean + (end - start) * line_mean;
  const Vector mixed = work / divisor(hi - lo);
  const Bits in_line = vector_greater(lo, knee.at), above = vector_greater(none(), lo),
             over = vector_greater(hi, knee.at);
  return vector_pick(in_line, line_mean, vector_pick(above | over, mixed, power_mean));
}

typedef struct Secant {
  Vector mean, rise; /* DV/s, and its derivative in s */
} Secant;

/* The secant of an interval that reaches beyond the knee, where V' continues as a line. */
static INLINE Secant secant_over_knee(const LawLanes *law, uint32_t power, Vector y, Vector s,
                                      Vector x) {
  const Knee knee = {every(law->limit), every(law->limit_force), every(law->limit_slope)};
  const Vector mean = mean_force(law, power, knee, vector_smaller(x, y), vector_larger(x, y));
  const Vector size = vector_size_of(s);
  const Bits small =
    vector_greater(SMALL_CHANGE * vector_larger(vector_size_of(x), vector_size_of(y)), size);
  const Vector way = vector_pick(vector_greater(size, none()), s, every(REAL(1.0)));
  const Vector quotient = (static_force(law, power, knee, x) - mean) / way;
  const Vector bend = REAL(0.5) * curvature(law, power, knee, y + REAL(2.0 / 3.0) * s);
  return (Secant){mean, vector_pick(small, bend, vector_larger(quotient, none()))};
}

/* The secant below the knee with a = 1. e is the fraction of the interval in contact. V' has the
 * mean K (x + y) e/2, with the ends x, y counted from 0. This mean grows by K e (1 - e/2) on
 * entering contact, by K e^2/2 on leaving. */
static INLINE Secant secant_of_line(const LawLanes *law, Vector y, Vector s, Vector x) {
  const Vector end = vector_larger(x, none()), begin = vector_larger(y, none());
  const Vector way = vector_pick(vector_greater(vector_size_of(s), none()), s, every(REAL(1.0)));
  const Vector part = (end - begin) / way;
  const Vector e =
    vector_pick(vector_greater(none(), vector_smaller(x, y)), part, every(REAL(1.0)));
  const Vector half = REAL(0.5) * e;
  const Vector rest = vector_pick(vector_greater(s, none()), REAL(1.0) - half, half);
  return (Secant){law->stiffness * (end + begin) * half, law->stiffness * e * rest};
}

/* The secant below the knee with a = 3/2 or 2 and both ends in contact: the mean of V' and its
 * derivative in s; also V' at x and 1/`gap`. With the roots q, p of the ends x, y, DV/s for a = 3/2
 * is (2K/5) (q^4 + q^3 p + q^2 p^2 + q p^3 + p^4)/(q + p), and its derivative is (K/5) (3 q^3 + 6
 * q^2 p + 4 q p^2 + 2 p^3)/(q + p)^2. Both are sums of non-negative terms for any s. */
static INLINE Secant secant_in_contact(const LawLanes *law, uint32_t power, Vector x, Vector y,
                                       Vector p, Vector gap, Vector *force, Vector *per_gap) {
  const Vector sum = x + y, square = sum * sum - x * y;
  if (power == 4) {
    *force = law->stiffness * (x * x);
    *per_gap = REAL(1.0) / gap;
    return (Secant){law->stiffness / REAL(3.0) * square, law->stiffness / REAL(3.0) * (sum + x)};
  }
  const Vector q = vector_root(x), roots = p + q, both = roots * gap;
  /* One division serves two quotients; a product below NEGLIGIBLE is replaced by 1. */
  const Vector inverse =
    REAL(1.0) / vector_pick(vector_greater(both, every(NEGLIGIBLE)), both, every(REAL(1.0)));
  const Vector per_roots = gap * inverse;
  const Vector cubic = q * (REAL(3.0) * x + REAL(4.0) * y) + p * (REAL(6.0) * x + REAL(2.0) * y);
  *force = law->stiffness * (x * q);
  *per_gap = roots * inverse;
  return (Secant){REAL(0.4) * law->stiffness * (square + p * q * sum) * per_roots,
                  REAL(0.2) * law->stiffness * cubic * (per_roots * per_roots)};
}

/* The secant below the knee with a = 3/2 or 2. For a = 3/2, p = sqrt(y) where y > 0. An interval
 * with one end in the air has the work of its part in contact, divided by its whole length. */
static INLINE Secant secant_of_power(const LawLanes *law, uint32_t power, Vector y, Vector p,
                                     Vector s, Vector x) {
  const Vector end = vector_larger(x, none()), begin = vector_larger(y, none());
  const Bits air = vector_greater(none(), vector_smaller(x, y));
  const Vector gap = vector_pick(air, vector_size_of(s), every(REAL(1.0)));
  Vector force, per_s;
  const Secant inside = secant_in_contact(law, power, end, begin, p, gap, &force, &per_s);
  const Vector part = inside.mean * (end + begin) * per_s;
  const Vector change = vector_pick(vector_greater(s, none()), force - part, part);
  return (Secant){vector_pick(air, part, inside.mean),
                  vector_pick(air, change * per_s, inside.rise)};
}

/* Lanes beyond the knee use their own formulas; the other lanes keep their values. The result of a
 * lane must not depend on the other lanes in its register, and so on the register's width. This
 * case is rare, so it is kept out of line. */
static __attribute__((noinline)) Secant with_knee(const LawLanes *law, uint32_t power, Vector y,
                                                  Vector s, Bits beyond, const Secant *below) {
  const Vector x = y + s;
  const Secant over = power == 2   ? secant_over_knee(law, 2, y, s, x)
                      : power == 3 ? secant_over_knee(law, 3, y, s, x)
                                   : secant_over_knee(law, 4, y, s, x);
  return (Secant){vector_pick(beyond, over.mean, below->mean),
                  vector_pick(beyond, over.rise, below->rise)};
}

/* Results of a law: see TbContactLawResult. */
typedef struct LawVectors {
  Vector force, slope, mean;
} LawVectors;

/* (DV/s) max(0, 1 + lambda s/(2k)) and its slope; 0 in lanes without contact. */
static INLINE LawVectors law_with_loss(const LawLanes *law, Vector s, Vector top, Secant secant) {
  const Vector factor = REAL(1.0) + law->loss * s;
  const Bits touching = vector_greater(top, none()), pushing = vector_greater(factor, none());
  const Vector mean = vector_pick(touching, secant.mean, none());
  const Vector rise = vector_pick(touching, secant.rise, none());
  return (LawVectors){vector_pick(pushing, mean * factor, none()),
                      vector_pick(pushing, rise * factor + law->loss * mean, none()), mean};
}

/* The law at s, with p = sqrt(y) where y > 0 if the power is 3. */
static INLINE LawVectors law_vectors(const LawLanes *law, uint32_t power, Vector y, Vector p,
                                     Vector s) {
  const Vector x = y + s, top = vector_larger(x, y);
  if (!vector_any(vector_greater(top, none()))) return (LawVectors){none(), none(), none()};
  Secant secant =
    power == 2 ? secant_of_line(law, y, s, x) : secant_of_power(law, power, y, p, s, x);
  const Bits beyond = vector_greater(top, every(law->limit));
  if (vector_any(beyond)) secant = with_knee(law, power, y, s, beyond, &secant);
  return law_with_loss(law, s, top, secant);
}

typedef struct LawArrays {
  const Real *y, *root, *s; /* root: sqrt(y), 0 where y < 0, if available; otherwise NULL */
  Real *force, *slope, *mean;
} LawArrays;

static INLINE void law_at(const LawLanes *law, uint32_t power, uint32_t n, LawArrays at) {
  for (uint32_t i = 0; i < n; i += WIDTH) {
    const Vector y = read(at.y + i);
    Vector p = y;
    if (power == 3) p = at.root ? read(at.root + i) : vector_root(vector_larger(y, none()));
    const LawVectors values = law_vectors(law, power, y, p, read(at.s + i));
    write(at.force + i, values.force);
    write(at.slope + i, values.slope);
    write(at.mean + i, values.mean);
  }
}

/* An exponent without a vector formula is computed point by point. */
static void law_of_points(const TbContactLaw *law, uint32_t n, LawArrays at) {
  for (uint32_t i = 0; i < n; i++) {
    const TbContactLawResult result = tb_contact_law_force(law, (double)at.y[i], (double)at.s[i]);
    at.force[i] = (Real)result.force;
    at.slope[i] = (Real)result.slope;
    at.mean[i] = (Real)result.mean;
  }
}

static INLINE void law_of(const TbContactLaw *law, uint32_t n, LawArrays arrays) {
  const LawLanes lanes = law_lanes(law);
  switch (tb_contact_law_power(law)) { /* one copy of the code for each */
  case 2: law_at(&lanes, 2, n, arrays); break;
  case 3: law_at(&lanes, 3, n, arrays); break;
  case 4: law_at(&lanes, 4, n, arrays); break;
  default: law_of_points(law, n, arrays); break;
  }
}

static void laws(uint32_t wires, uint32_t lanes, const TbContactLaw *laws_of, const Real *y,
                 const Real *root_y, const Real *s, Real *force, Real *slope, Real *mean) {
  for (uint32_t w = 0, at = 0; w < wires; w++, at += lanes) {
    law_of(
      &laws_of[w], lanes,
      (LawArrays){y + at, root_y ? root_y + at : NULL, s + at, force + at, slope + at, mean + at});
  }
}

#endif
