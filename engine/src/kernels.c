/* SPDX-License-Identifier: MIT */
/* Compiled once per instruction set, with TB_KERNELS naming the table it fills. */
#include "kernels.h"

#include "bed.h"
#include "lanes.h"
#include "law.h"

static void two_step(uint32_t n, double *out, const double *a, const double *x, const double *b,
                     const double *y) {
  for (uint32_t i = 0; i < n; i += 8) {
    store(out + i, subtract(multiply_lanes(load(a + i), load(x + i)),
                            multiply_lanes(load(b + i), load(y + i))));
  }
}

/* Four blocks side by side: enough independent sums to hide the latency of an addition. */
static void multiply_four(uint32_t n, double *out, const double *matrix, const double *x) {
  const uint64_t block = 8u * (uint64_t)n;
  Lanes s0 = zero(), s1 = zero(), s2 = zero(), s3 = zero();
  for (uint32_t i = 0; i < n; i++) {
    const double *m = matrix + 8u * (uint64_t)i;
    s0 = add(s0, scale(load(m), x[i]));
    s1 = add(s1, scale(load(m + block), x[i]));
    s2 = add(s2, scale(load(m + 2 * block), x[i]));
    s3 = add(s3, scale(load(m + 3 * block), x[i]));
  }
  store(out, s0);
  store(out + 8, s1);
  store(out + 16, s2);
  store(out + 24, s3);
}

static void multiply_two(uint32_t n, double *out, const double *matrix, const double *x) {
  const uint64_t block = 8u * (uint64_t)n;
  Lanes s0 = zero(), s1 = zero();
  for (uint32_t i = 0; i < n; i++) {
    const double *m = matrix + 8u * (uint64_t)i;
    s0 = add(s0, scale(load(m), x[i]));
    s1 = add(s1, scale(load(m + block), x[i]));
  }
  store_unaligned(out, s0);
  store_unaligned(out + 8, s1);
}

static void multiply(uint32_t blocks, uint32_t n, double *out, const double *matrix,
                     const double *x) {
  const uint64_t block = 8u * (uint64_t)n;
  uint32_t b = 0;
  for (; b + 4 <= blocks; b += 4) multiply_four(n, out + 8 * b, matrix + b * block, x);
  for (; b + 2 <= blocks; b += 2) multiply_two(n, out + 8 * b, matrix + b * block, x);
  for (; b < blocks; b++) {
    Lanes sum = zero();
    for (uint32_t i = 0; i < n; i++) {
      sum = add(sum, scale(load(matrix + b * block + 8u * (uint64_t)i), x[i]));
    }
    store(out + 8 * b, sum);
  }
}

/* `count` blocks side by side, a constant where it is called. */
static INLINE void single_blocks(uint32_t count, uint32_t n, double *out, const float *matrix,
                                 const double *x) {
  const uint64_t block = 8u * (uint64_t)n;
  Lanes sum[6];
  for (uint32_t b = 0; b < count; b++) sum[b] = zero();
  for (uint32_t i = 0; i < n; i++) {
    const float *m = matrix + 8u * (uint64_t)i;
#pragma GCC unroll 6 /* or the sums would live in memory */
    for (uint32_t b = 0; b < count; b++) {
      sum[b] = add(sum[b], scale(load_single(m + b * block), x[i]));
    }
  }
  for (uint32_t b = 0; b < count; b++) store(out + 8 * b, sum[b]);
}

static void multiply_single(uint32_t blocks, uint32_t n, double *out, const float *matrix,
                            const double *x) {
  const uint64_t block = 8u * (uint64_t)n;
  uint32_t b = 0;
  for (; b + 6 <= blocks; b += 6) single_blocks(6, n, out + 8 * b, matrix + b * block, x);
  for (; b + 3 <= blocks; b += 3) single_blocks(3, n, out + 8 * b, matrix + b * block, x);
  for (; b < blocks; b++) single_blocks(1, n, out + 8 * b, matrix + b * block, x);
}

static double reach(uint32_t n, const double *c, const double *x) {
  Lanes sum = zero();
  for (uint32_t i = 0; i < n; i += 8) {
    sum = add(sum, multiply_lanes(load(c + i), size_of(load(x + i))));
  }
  return join(sum);
}

static double dot(uint32_t n, const double *x, const double *y) {
  Lanes sum = zero();
  for (uint32_t i = 0; i < n; i += 8) sum = add(sum, multiply_lanes(load(x + i), load(y + i)));
  return join(sum);
}

static void add_scaled(uint32_t n, double *out, double f, const double *x) {
  for (uint32_t i = 0; i < n; i += 8) store(out + i, add(load(out + i), scale(load(x + i), f)));
}

static void add_scaled_single(uint32_t n, double *out, double f, const float *x) {
  for (uint32_t i = 0; i < n; i += 8) {
    store(out + i, add(load(out + i), scale(load_single(x + i), f)));
  }
}

static void hold(uint32_t n, double f, double most, const double *h, const double *last,
                 double *next) {
  const Lanes limit = all(most);
  for (uint32_t i = 0; i < n; i += 8) {
    const Lanes part = smaller(scale(load(h + i), f), limit), now = load(next + i);
    store(next + i, add(now, multiply_lanes(part, subtract(load(last + i), now))));
  }
}

static void add_product(uint32_t n, double *out, const double *x, const double *y) {
  for (uint32_t i = 0; i < n; i += 8) {
    store(out + i, add(load(out + i), multiply_lanes(load(x + i), load(y + i))));
  }
}

static double readout(uint32_t n, const double *u, const double *v, const double *next,
                      const double *now, const double *last) {
  Lanes sum = zero();
  for (uint32_t i = 0; i < n; i += 8) {
    const Lanes q2 = load(next + i), q1 = load(now + i), q0 = load(last + i);
    const Lanes bend = subtract(subtract(q2, q1), subtract(q1, q0));
    sum = add(
      sum, add(multiply_lanes(load(u + i), bend), multiply_lanes(load(v + i), subtract(q2, q0))));
  }
  return join(sum);
}

static TbPair losses(uint32_t n, const double *u, const double *v, const double *next,
                     const double *last) {
  Lanes first = zero(), second = zero();
  for (uint32_t i = 0; i < n; i += 8) {
    const Lanes step = subtract(load(next + i), load(last + i));
    const Lanes square = multiply_lanes(step, step);
    first = add(first, multiply_lanes(load(u + i), square));
    second = add(second, multiply_lanes(load(v + i), square));
  }
  return (TbPair){join(first), join(second)};
}

/* ---- the bed -------------------------------------------------------------------------------- */

/* Where the mirror image of a wire stands. */
static INLINE uint32_t image_of(const TbBed *bed, uint32_t wire) {
  return bed->quarters == 2 ? bed->wires - 1u - wire : wire;
}

/* One of each pair. */
static INLINE uint32_t pairs_of(const TbBed *bed) {
  return bed->quarters == 2 ? (bed->wires + 1u) / 2u : bed->wires;
}

/* Up to four lines at once, `n` of them known when compiled. */
static INLINE void gather_some(uint32_t n, bool odd, const TbBed *bed, uint32_t line,
                               const double *x, double *to) {
  Lanes sum[4] = {zero(), zero(), zero(), zero()};
  for (uint32_t w = 0; w < pairs_of(bed); w++) {
    const uint32_t image = image_of(bed, w);
    const double *c = bed->across + (uint64_t)w * bed->lines + line;
    Lanes v = load(x + (uint64_t)w * bed->lanes);
    if (image != w) {
      const Lanes other = load(x + (uint64_t)image * bed->lanes);
      v = odd ? subtract(v, other) : add(v, other);
    }
    for (uint32_t l = 0; l < n; l++) sum[l] = add(sum[l], scale(v, c[l]));
  }
  for (uint32_t l = 0; l < n; l++) store(to + (uint64_t)(line + l) * bed->lanes, sum[l]);
}

static INLINE void gather_parity(bool odd, const TbBed *bed, const double *x, double *to) {
  const uint32_t end = odd ? bed->lines : bed->first_line[1];
  for (uint32_t l = odd ? bed->first_line[1] : 0; l < end; l += 4) {
    switch (end - l) {
    case 1: gather_some(1, odd, bed, l, x, to); break;
    case 2: gather_some(2, odd, bed, l, x, to); break;
    case 3: gather_some(3, odd, bed, l, x, to); break;
    default: gather_some(4, odd, bed, l, x, to); break;
    }
  }
}

static void gather_lines(const TbBed *bed, const double *x, double *lines) {
  for (uint32_t at = 0; at < bed->lanes; at += 8) {
    gather_parity(false, bed, x + at, lines + at);
    gather_parity(true, bed, x + at, lines + at);
  }
}

static INLINE Lanes spread_some(const TbBed *bed, uint32_t from, uint32_t end, const double *across,
                                const double *lines) {
  Lanes sum = zero();
  for (uint32_t l = from; l < end; l++) {
    sum = add(sum, scale(load(lines + (uint64_t)l * bed->lanes), across[l]));
  }
  return sum;
}

static void spread_lines(const TbBed *bed, const double *lines, double *x) {
  const uint32_t even = bed->first_line[1];
  for (uint32_t w = 0; w < pairs_of(bed); w++) {
    const double *across = bed->across + (uint64_t)w * bed->lines;
    double *own = x + (uint64_t)w * bed->lanes,
           *image = x + (uint64_t)image_of(bed, w) * bed->lanes;
    for (uint32_t at = 0; at < bed->lanes; at += 8) {
      const Lanes s = spread_some(bed, 0, even, across, lines + at);
      const Lanes d = spread_some(bed, even, bed->lines, across, lines + at);
      store(image + at, subtract(s, d));
      store(own + at, add(s, d));
    }
  }
}

/* ---- wires ---------------------------------------------------------------------------------- */

static INLINE Lanes second_difference(const double *v) {
  const Lanes middle = load(v);
  return add(subtract(load_unaligned(v - 1), middle), subtract(load_unaligned(v + 1), middle));
}

static void wire_step(uint32_t n, const double *c, const double *inner, const double *now,
                      const double *last, double *bend, double *bend_last, double *next) {
  for (uint32_t i = 0; i < n; i += 8) {
    const Lanes inside = load(inner + i);
    store(bend + i, multiply_lanes(inside, second_difference(now + i)));
    store(bend_last + i, multiply_lanes(inside, second_difference(last + i)));
  }
  for (uint32_t i = 0; i < n; i += 8) {
    const Lanes curve = load(bend + i);
    Lanes push = scale(curve, c[2]);
    push = subtract(push, scale(second_difference(bend + i), c[3]));
    push = add(push, scale(subtract(curve, load(bend_last + i)), c[4]));
    const Lanes coast = subtract(scale(load(now + i), 2.0), scale(load(last + i), c[1]));
    store(next + i, multiply_lanes(load(inner + i), scale(add(coast, push), c[0])));
  }
}

static TbPair wire_losses(uint32_t n, const double *next, const double *last) {
  Lanes first = zero(), second = zero();
  for (uint32_t i = 0; i < n; i += 8) {
    const Lanes step = subtract(load(next + i), load(last + i));
    const Lanes slope =
      subtract(step, subtract(load_unaligned(next + i - 1), load_unaligned(last + i - 1)));
    first = add(first, multiply_lanes(step, step));
    second = add(second, multiply_lanes(slope, slope));
  }
  return (TbPair){join(first), join(second)};
}

/* ---- contacts ------------------------------------------------------------------------------- */

/* eta^(power/2) for eta >= 0 */
static INLINE Lanes raise(uint32_t power, Lanes eta) {
  if (power == 2) return eta;
  return multiply_lanes(eta, power == 3 ? root(eta) : eta);
}

/* Mean of eta^(power/2) over (x, y), both >= 0. */
static INLINE Lanes mean_power(uint32_t power, Lanes x, Lanes y) {
  if (power == 2) return scale(add(x, y), 0.5);
  const Lanes square = add(add(multiply_lanes(x, x), multiply_lanes(x, y)), multiply_lanes(y, y));
  if (power == 4) return scale(square, 1.0 / 3.0);
  const Lanes p = root(x), q = root(y), sum = add(p, q);
  const Lanes quartic = add(square, multiply_lanes(multiply_lanes(p, q), add(x, y)));
  return divide(scale(quartic, 0.4), pick(greater(sum, zero()), sum, all(1.0)));
}

typedef struct Knee {
  Lanes at, force, slope;
} Knee;

/* V' */
static INLINE Lanes static_force(const TbLaw *law, uint32_t power, Knee knee, Lanes eta) {
  const Lanes inside = scale(raise(power, smaller(larger(eta, zero()), knee.at)), law->stiffness);
  const Lanes beyond = add(knee.force, multiply_lanes(knee.slope, subtract(eta, knee.at)));
  return pick(greater(eta, knee.at), beyond, inside);
}

/* V'' */
static INLINE Lanes curvature(const TbLaw *law, uint32_t power, Knee knee, Lanes eta) {
  const Lanes touching = larger(eta, zero());
  Lanes inside = all(law->stiffness);
  if (power == 3) inside = scale(root(touching), 1.5 * law->stiffness);
  if (power == 4) inside = scale(touching, 2.0 * law->stiffness);
  inside = pick(greater(eta, zero()), inside, zero());
  return pick(greater(eta, knee.at), knee.slope, inside);
}

/* Mean of V' between lo and hi: of one piece directly, so that equal ends need no division. */
static INLINE Lanes mean_force(const TbLaw *law, uint32_t power, Knee knee, Lanes lo, Lanes hi) {
  const Lanes from = larger(lo, zero()), top = smaller(hi, knee.at);
  const Lanes power_top = larger(top, zero()), power_from = smaller(from, power_top);
  const Lanes power_mean = scale(mean_power(power, power_from, power_top), law->stiffness);
  const Lanes start = larger(from, knee.at), end = larger(hi, start);
  const Lanes middle = subtract(scale(add(start, end), 0.5), knee.at);
  const Lanes line_mean = add(knee.force, multiply_lanes(knee.slope, middle));
  const Lanes work = add(multiply_lanes(subtract(power_top, power_from), power_mean),
                         multiply_lanes(subtract(end, start), line_mean));
  const Lanes length = subtract(hi, lo);
  const Lanes mixed = divide(work, pick(greater(length, zero()), length, all(1.0)));
  const Mask in_line = greater(lo, knee.at), above = greater(zero(), lo),
             over = greater(hi, knee.at);
  return pick(in_line, line_mean, pick(either(above, over), mixed, power_mean));
}

typedef struct Secant {
  Lanes mean, rise; /* DV/s, and its derivative in s */
} Secant;

/* Where V' goes on as a line. */
static INLINE Secant secant_over_knee(const TbLaw *law, uint32_t power, Lanes y, Lanes s, Lanes x) {
  const Knee knee = {all(law->limit), all(law->limit_force), all(law->limit_slope)};
  const Lanes mean = mean_force(law, power, knee, smaller(x, y), larger(x, y));
  const Mask small = greater(scale(larger(size_of(x), size_of(y)), 1e-5), size_of(s));
  const Lanes divisor = pick(greater(size_of(s), zero()), s, all(1.0));
  const Lanes quotient = divide(subtract(static_force(law, power, knee, x), mean), divisor);
  const Lanes bend = scale(curvature(law, power, knee, add(y, scale(s, 0.5))), 0.5);
  return (Secant){mean, pick(small, bend, larger(quotient, zero()))};
}

/* Below the knee with a = 1, where e is the part of the interval in contact: V' has the mean
 * K (x + y) e/2 of its ends counted from 0, which grows by K e (1 - e/2) entering, K e^2/2 leaving. */
static INLINE Secant secant_of_line(const TbLaw *law, Lanes y, Lanes s, Lanes x) {
  const Lanes end = larger(x, zero()), begin = larger(y, zero());
  const Lanes length = pick(greater(size_of(s), zero()), s, all(1.0));
  const Lanes part = divide(subtract(end, begin), length);
  const Lanes e = pick(greater(zero(), smaller(x, y)), part, all(1.0));
  const Lanes half = scale(e, 0.5);
  const Lanes rest = pick(greater(s, zero()), subtract(all(1.0), half), half);
  return (Secant){multiply_lanes(scale(add(end, begin), law->stiffness), half),
                  multiply_lanes(scale(e, law->stiffness), rest)};
}

/* Below the knee with a = 3/2 or 2, from the roots of both ends alone. */
static INLINE Secant secant_of_power(const TbLaw *law, uint32_t power, Lanes y, Lanes s, Lanes x) {
  const Lanes from = larger(smaller(x, y), zero()), top = larger(larger(x, y), zero());
  const Lanes p = power == 3 ? root(from) : from, q = power == 3 ? root(top) : top;
  const Lanes sum = add(from, top), product = multiply_lanes(from, top);
  const Lanes square = subtract(multiply_lanes(sum, sum), product);
  Lanes inside = scale(square, law->stiffness / 3.0), bend = scale(sum, 0.5 * law->stiffness);
  if (power == 3) {
    const Lanes roots = add(p, q), safe = pick(greater(roots, zero()), roots, all(1.0));
    const Lanes quartic = add(square, multiply_lanes(multiply_lanes(p, q), sum));
    inside = divide(scale(quartic, 0.4 * law->stiffness), safe);
    bend = scale(roots, 0.375 * law->stiffness);
  }
  const Lanes per_s = divide(all(1.0), pick(greater(size_of(s), zero()), s, all(1.0)));
  /* An interval that begins in the air: the work over its length. */
  const Lanes part = multiply_lanes(inside, multiply_lanes(subtract(top, from), size_of(per_s)));
  const Mask air = greater(zero(), smaller(x, y));
  const Lanes mean = pick(air, part, inside);
  const Lanes end = larger(x, zero());
  Lanes force = scale(end, law->stiffness);
  if (power == 4) force = multiply_lanes(force, end);
  if (power == 3) force = multiply_lanes(force, pick(greater(x, y), q, p));
  const Mask small = greater(scale(larger(size_of(x), size_of(y)), 1e-5), size_of(s));
  const Lanes quotient = larger(multiply_lanes(subtract(force, mean), per_s), zero());
  return (Secant){mean, pick(small, bend, quotient)};
}

typedef struct LawArrays {
  const double *y, *s;
  double *force, *slope, *mean;
} LawArrays;

/* (DV/s) max(0, 1 + lambda s/(2k)) and its slope */
static INLINE void law_with_loss(const TbLaw *law, Lanes s, Secant secant, LawArrays at) {
  const Lanes factor = add(all(1.0), scale(s, law->loss));
  const Lanes slope = add(multiply_lanes(secant.rise, factor), scale(secant.mean, law->loss));
  const Lanes force = multiply_lanes(secant.mean, factor);
  store(at.mean, secant.mean);
  store(at.force, pick(greater(factor, zero()), force, zero()));
  store(at.slope, pick(greater(factor, zero()), slope, zero()));
}

/* Rare: out of the way of the rest. */
static __attribute__((noinline)) void law_over_knee(const TbLaw *law, uint32_t power,
                                                    LawArrays at) {
  const Lanes y = load(at.y), s = load(at.s), x = add(y, s);
  Secant secant = power == 2   ? secant_over_knee(law, 2, y, s, x)
                  : power == 3 ? secant_over_knee(law, 3, y, s, x)
                               : secant_over_knee(law, 4, y, s, x);
  secant.rise = pick(greater(larger(x, y), zero()), secant.rise, zero());
  secant.mean = pick(greater(larger(x, y), zero()), secant.mean, zero());
  law_with_loss(law, s, secant, at);
}

static INLINE void law_at(const TbLaw *law, uint32_t power, uint32_t n, LawArrays arrays) {
  for (uint32_t i = 0; i < n; i += 8) {
    const LawArrays at = {arrays.y + i, arrays.s + i, arrays.force + i, arrays.slope + i,
                          arrays.mean + i};
    const Lanes y = load(at.y), s = load(at.s), x = add(y, s), top = larger(x, y);
    if (any(greater(top, all(law->limit)))) {
      law_over_knee(law, power, at);
      continue;
    }
    Secant secant;
    if (power == 2) {
      secant = secant_of_line(law, y, s, x);
    } else {
      secant = secant_of_power(law, power, y, s, x);
      secant.rise = pick(greater(top, zero()), secant.rise, zero());
      secant.mean = pick(greater(top, zero()), secant.mean, zero());
    }
    law_with_loss(law, s, secant, at);
  }
}

static void law_of(const TbLaw *law, uint32_t power, uint32_t n, const double *y, const double *s,
                   double *force, double *slope, double *mean) {
  const LawArrays arrays = {y, s, force, slope, mean};
  switch (power) { /* one copy of the code for each */
  case 2: law_at(law, 2, n, arrays); break;
  case 3: law_at(law, 3, n, arrays); break;
  default: law_at(law, 4, n, arrays); break;
  }
}

static bool touches(uint32_t n, const double *y, const double *s, const double *f) {
  Lanes most = zero();
  for (uint32_t i = 0; i < n; i += 8) {
    const Lanes before = load(y + i), after = add(before, load(s + i));
    most = larger(most, larger(larger(before, after), size_of(load(f + i))));
  }
  return largest_of(most) > 0.0;
}

static TbPair sizes(uint32_t n, const double *b, const double *y) {
  Lanes most = zero(), deepest = zero();
  for (uint32_t i = 0; i < n; i += 8) {
    most = larger(size_of(load(b + i)), most);
    deepest = larger(load(y + i), deepest);
  }
  return (TbPair){largest_of(most), largest_of(deepest)};
}

static double difference(uint32_t n, const double *x, const double *y) {
  Lanes most = zero();
  for (uint32_t i = 0; i < n; i += 8)
    most = larger(size_of(subtract(load(x + i), load(y + i))), most);
  return largest_of(most);
}

static void subtract_arrays(uint32_t n, const double *x, const double *y, double *out) {
  for (uint32_t i = 0; i < n; i += 8) store(out + i, subtract(load(x + i), load(y + i)));
}

static void extrapolate(uint32_t n, double t, const double *x, const double *before,
                        const double *base, double *out) {
  for (uint32_t i = 0; i < n; i += 8) {
    store(out + i, add(load(base + i), scale(subtract(load(x + i), load(before + i)), t)));
  }
}

static double residual(uint32_t n, const double *s, const double *b, const double *p, double *r) {
  Lanes most = zero();
  for (uint32_t i = 0; i < n; i += 8) {
    const Lanes left = add(load(p + i), subtract(load(s + i), load(b + i)));
    store(r + i, left);
    most = larger(size_of(left), most);
  }
  return largest_of(most);
}

static void weigh(uint32_t n, const double *slope, double *weight, double *r) {
  for (uint32_t i = 0; i < n; i += 8) {
    const Lanes w = root(load(slope + i));
    store(weight + i, w);
    store(r + i, subtract(zero(), multiply_lanes(w, load(r + i))));
  }
}

static void balance(uint32_t n, double t, const double *s_at, const double *law,
                    const double *slope, const double *f_at, const double *f_last, const double *p,
                    const double *p_last, double sums[3]) {
  Lanes value = zero(), derivative = zero(), size = zero();
  for (uint32_t i = 0; i < n; i += 8) {
    const Lanes s = load(s_at + i), f = load(f_at + i), g = subtract(f, load(f_last + i));
    const Lanes m = subtract(load(p + i), load(p_last + i)), moved = add(f, scale(g, t));
    const Lanes left = subtract(load(law + i), moved);
    const Lanes bend = multiply_lanes(s, add(multiply_lanes(load(slope + i), m), g));
    value = add(value, multiply_lanes(s, left));
    derivative = subtract(derivative, add(multiply_lanes(m, left), bend));
    size = add(size, size_of(multiply_lanes(s, moved)));
  }
  sums[0] = join(value);
  sums[1] = join(derivative);
  sums[2] = join(size);
}

static double lost(uint32_t n, const double *s, const double *f, const double *mean) {
  Lanes sum = zero();
  for (uint32_t i = 0; i < n; i += 8) {
    sum = add(sum, multiply_lanes(load(s + i), subtract(load(f + i), load(mean + i))));
  }
  return join(sum);
}

static void penetrate(uint32_t n, double side, double shift, const double *w, const double *v,
                      const double *rest, const double *last, const double *load_at, double *b) {
  const Lanes shifted = all(shift);
  for (uint32_t i = 0; i < n; i += 8) {
    const Lanes deviation = subtract(scale(load(w + i), side), load(v + i));
    const Lanes eta = add(add(deviation, load(rest + i)), shifted);
    store(b + i, add(subtract(eta, load(last + i)), load(load_at + i)));
  }
}

static void move(uint32_t n, const double *own, const double *f, const double *rest,
                 const double *last, const double *s, double *v, double *eta) {
  for (uint32_t i = 0; i < n; i += 8) {
    const Lanes change = subtract(load(f + i), load(rest + i));
    store(v + i, add(load(v + i), multiply_lanes(load(own + i), change)));
    store(eta + i, add(load(last + i), load(s + i)));
  }
}

/* ---- conjugate gradients -------------------------------------------------------------------- */

static void product(uint32_t n, double *out, const double *x, const double *y) {
  for (uint32_t i = 0; i < n; i += 8) store(out + i, multiply_lanes(load(x + i), load(y + i)));
}

static double turn(uint32_t n, double *out, const double *d, const double *w, const double *m) {
  Lanes sum = zero();
  for (uint32_t i = 0; i < n; i += 8) {
    const Lanes direction = load(d + i);
    const Lanes turned = add(direction, multiply_lanes(load(w + i), load(m + i)));
    store(out + i, turned);
    sum = add(sum, multiply_lanes(direction, turned));
  }
  return join(sum);
}

static double advance(uint32_t n, double t, double *p, const double *d, double *r,
                      const double *m) {
  Lanes sum = zero();
  for (uint32_t i = 0; i < n; i += 8) {
    store(p + i, add(load(p + i), scale(load(d + i), t)));
    const Lanes left = subtract(load(r + i), scale(load(m + i), t));
    store(r + i, left);
    sum = add(sum, multiply_lanes(left, left));
  }
  return join(sum);
}

static void redirect(uint32_t n, double t, double *d, const double *r) {
  for (uint32_t i = 0; i < n; i += 8) store(d + i, add(load(r + i), scale(load(d + i), t)));
}

const TbKernels TB_KERNELS = {
  .two_step = two_step,
  .multiply = multiply,
  .multiply_single = multiply_single,
  .reach = reach,
  .dot = dot,
  .add_scaled = add_scaled,
  .add_scaled_single = add_scaled_single,
  .hold = hold,
  .add_product = add_product,
  .readout = readout,
  .losses = losses,
  .gather_lines = gather_lines,
  .spread_lines = spread_lines,
  .wire_step = wire_step,
  .wire_losses = wire_losses,
  .law = law_of,
  .touches = touches,
  .sizes = sizes,
  .difference = difference,
  .subtract = subtract_arrays,
  .extrapolate = extrapolate,
  .residual = residual,
  .weigh = weigh,
  .balance = balance,
  .lost = lost,
  .penetrate = penetrate,
  .move = move,
  .product = product,
  .turn = turn,
  .advance = advance,
  .redirect = redirect,
};
