/* SPDX-License-Identifier: MIT */
/* Compiled once per instruction set, with TB_KERNELS naming the table it fills. */
#include "kernels.h"

#include <math.h>
#include <stdbool.h>

#include "law.h"

/* Eight lanes in as many registers as the instruction set needs for them. */
#if defined(__AVX512F__)
#  define WIDTH 8
#elif defined(__AVX2__)
#  define WIDTH 4
#else
#  define WIDTH 2
#endif
#define PARTS (8 / WIDTH)
/* Lanes live in registers only where no call stands between. */
#define INLINE inline __attribute__((always_inline))

typedef double Vector __attribute__((vector_size(8 * WIDTH), may_alias));

typedef double Unaligned __attribute__((vector_size(8 * WIDTH), may_alias, aligned(8)));
typedef int64_t Bits __attribute__((vector_size(8 * WIDTH)));

typedef struct Lanes {
  Vector part[PARTS];
} Lanes;

/* All ones where true. */
typedef struct Mask {
  Bits part[PARTS];
} Mask;

static INLINE Lanes load(const double *p) {
  Lanes x;
  for (int i = 0; i < PARTS; i++) x.part[i] = ((const Vector *)(const void *)p)[i];
  return x;
}

/* Lane by lane, as in larger(). */
static INLINE Lanes load_single(const float *p) {
  Lanes x;
  for (int i = 0; i < PARTS; i++) {
    for (int j = 0; j < WIDTH; j++) x.part[i][j] = (double)p[i * WIDTH + j];
  }
  return x;
}

static INLINE void store(double *p, Lanes x) {
  for (int i = 0; i < PARTS; i++) ((Vector *)(void *)p)[i] = x.part[i];
}

static INLINE Lanes zero(void) {
  Lanes x;
  for (int i = 0; i < PARTS; i++) x.part[i] = (Vector){0.0};
  return x;
}

static INLINE Lanes add(Lanes x, Lanes y) {
  for (int i = 0; i < PARTS; i++) x.part[i] += y.part[i];
  return x;
}

static INLINE Lanes subtract(Lanes x, Lanes y) {
  for (int i = 0; i < PARTS; i++) x.part[i] -= y.part[i];
  return x;
}

static INLINE Lanes multiply_lanes(Lanes x, Lanes y) {
  for (int i = 0; i < PARTS; i++) x.part[i] *= y.part[i];
  return x;
}

static INLINE Lanes scale(Lanes x, double factor) {
  for (int i = 0; i < PARTS; i++) x.part[i] *= factor;
  return x;
}

static INLINE double join(Lanes x) {
  double s[8] __attribute__((aligned(64)));
  store(s, x);
  return ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]));
}

static INLINE Lanes load_unaligned(const double *p) {
  Lanes x;
  for (int i = 0; i < PARTS; i++) x.part[i] = ((const Unaligned *)(const void *)p)[i];
  return x;
}

static INLINE void store_unaligned(double *p, Lanes x) {
  for (int i = 0; i < PARTS; i++) ((Unaligned *)(void *)p)[i] = x.part[i];
}

static INLINE Lanes all(double value) {
  Lanes x = zero();
  for (int i = 0; i < PARTS; i++) x.part[i] += value;
  return x;
}

static INLINE Lanes divide(Lanes x, Lanes y) {
  for (int i = 0; i < PARTS; i++) x.part[i] /= y.part[i];
  return x;
}

static INLINE Lanes root(Lanes x) {
  for (int i = 0; i < PARTS; i++) {
    for (int j = 0; j < WIDTH; j++) x.part[i][j] = sqrt(x.part[i][j]);
  }
  return x;
}

static INLINE Mask greater(Lanes x, Lanes y) {
  Mask m;
  for (int i = 0; i < PARTS; i++) m.part[i] = x.part[i] > y.part[i];
  return m;
}

static INLINE Mask both(Mask a, Mask b) {
  for (int i = 0; i < PARTS; i++) a.part[i] &= b.part[i];
  return a;
}

static INLINE Mask either(Mask a, Mask b) {
  for (int i = 0; i < PARTS; i++) a.part[i] |= b.part[i];
  return a;
}

static INLINE Lanes pick(Mask m, Lanes x, Lanes y) {
  for (int i = 0; i < PARTS; i++) {
    x.part[i] = (Vector)((m.part[i] & (Bits)x.part[i]) | (~m.part[i] & (Bits)y.part[i]));
  }
  return x;
}

/* Lane by lane, so that the compiler finds its one instruction for it. */
static INLINE Lanes larger(Lanes x, Lanes y) {
  for (int i = 0; i < PARTS; i++) {
    for (int j = 0; j < WIDTH; j++) {
      x.part[i][j] = x.part[i][j] > y.part[i][j] ? x.part[i][j] : y.part[i][j];
    }
  }
  return x;
}

static INLINE Lanes smaller(Lanes x, Lanes y) {
  for (int i = 0; i < PARTS; i++) {
    for (int j = 0; j < WIDTH; j++) {
      x.part[i][j] = x.part[i][j] < y.part[i][j] ? x.part[i][j] : y.part[i][j];
    }
  }
  return x;
}

static INLINE Lanes size_of(Lanes x) { return larger(x, subtract(zero(), x)); }

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

static double dot(uint32_t n, const double *x, const double *y) {
  Lanes sum = zero();
  for (uint32_t i = 0; i < n; i += 8) sum = add(sum, multiply_lanes(load(x + i), load(y + i)));
  return join(sum);
}

static void add_scaled(uint32_t n, double *out, double f, const double *x) {
  for (uint32_t i = 0; i < n; i += 8) store(out + i, add(load(out + i), scale(load(x + i), f)));
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

/* Up to four lines at once, `n` of them known when compiled. */
static INLINE void gather_some(uint32_t n, bool odd, uint32_t lines, uint32_t lanes, uint32_t count,
                               const uint32_t *wire, const uint32_t *at, const uint32_t *image,
                               const double *across, const double *x, double *to) {
  Lanes sum[4] = {zero(), zero(), zero(), zero()};
  for (uint32_t k = 0; k < count; k++) {
    const double *c = across + (uint64_t)wire[k] * lines;
    Lanes v = load(x + at[k]);
    if (at[k] != image[k]) {
      v = odd ? subtract(v, load(x + image[k])) : add(v, load(x + image[k]));
    }
    for (uint32_t l = 0; l < n; l++) sum[l] = add(sum[l], scale(v, c[l]));
  }
  for (uint32_t l = 0; l < n; l++) store(to + (uint64_t)l * lanes, sum[l]);
}

static INLINE void gather_parity(bool odd, uint32_t first, uint32_t end, uint32_t lines,
                                 uint32_t lanes, uint32_t count, const uint32_t *wire,
                                 const uint32_t *at, const uint32_t *image, const double *across,
                                 const double *x, double *to) {
  for (uint32_t l = first; l < end;) {
    const uint32_t n = end - l < 4 ? end - l : 4;
    const double *c = across + l;
    double *out = to + (uint64_t)l * lanes;
    switch (n) {
    case 1: gather_some(1, odd, lines, lanes, count, wire, at, image, c, x, out); break;
    case 2: gather_some(2, odd, lines, lanes, count, wire, at, image, c, x, out); break;
    case 3: gather_some(3, odd, lines, lanes, count, wire, at, image, c, x, out); break;
    default: gather_some(4, odd, lines, lanes, count, wire, at, image, c, x, out); break;
    }
    l += n;
  }
}

static void gather_lines(uint32_t even, uint32_t lines, uint32_t lanes, uint32_t count,
                         const uint32_t *wire, const uint32_t *at, const uint32_t *image,
                         const double *across, const double *x, double *to) {
  gather_parity(false, 0, even, lines, lanes, count, wire, at, image, across, x, to);
  gather_parity(true, even, lines, lines, lanes, count, wire, at, image, across, x, to);
}

static void spread_lines(uint32_t even, uint32_t lines, uint32_t lanes, uint32_t count,
                         const uint32_t *wire, const uint32_t *at, const uint32_t *image,
                         const double *across, const double *from, double *x) {
  for (uint32_t k = 0; k < count; k++) {
    const double *c = across + (uint64_t)wire[k] * lines;
    Lanes s = zero(), d = zero();
    for (uint32_t l = 0; l < even; l++) s = add(s, scale(load(from + (uint64_t)l * lanes), c[l]));
    for (uint32_t l = even; l < lines; l++) {
      d = add(d, scale(load(from + (uint64_t)l * lanes), c[l]));
    }
    store(x + image[k], subtract(s, d));
    store(x + at[k], add(s, d));
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

/* For blocks with a lane beyond the knee, where V' goes on as a line. */
static INLINE Secant secant_over_knee(const TbLaw *law, uint32_t power, Knee knee, Lanes y, Lanes s,
                                      Lanes x) {
  const Lanes mean = mean_force(law, power, knee, smaller(x, y), larger(x, y));
  const Mask small = greater(scale(larger(size_of(x), size_of(y)), 1e-5), size_of(s));
  const Lanes divisor = pick(greater(size_of(s), zero()), s, all(1.0));
  const Lanes quotient = divide(subtract(static_force(law, power, knee, x), mean), divisor);
  const Lanes bend = scale(curvature(law, power, knee, add(y, scale(s, 0.5))), 0.5);
  return (Secant){mean, pick(small, bend, larger(quotient, zero()))};
}

/* Below the knee, from the roots of both ends alone. */
static INLINE Secant secant_of_power(const TbLaw *law, uint32_t power, Lanes y, Lanes s, Lanes x) {
  const Lanes from = larger(smaller(x, y), zero()), top = larger(larger(x, y), zero());
  const Lanes p = power == 3 ? root(from) : from, q = power == 3 ? root(top) : top;
  const Lanes sum = add(from, top), product = multiply_lanes(from, top);
  Lanes inside = scale(sum, 0.5 * law->stiffness), bend = all(0.5 * law->stiffness);
  if (power != 2) {
    const Lanes square = subtract(multiply_lanes(sum, sum), product);
    const Lanes roots = add(p, q), safe = pick(greater(roots, zero()), roots, all(1.0));
    inside = scale(square, law->stiffness / 3.0);
    bend = scale(sum, 0.5 * law->stiffness);
    if (power == 3) {
      const Lanes quartic = add(square, multiply_lanes(multiply_lanes(p, q), sum));
      inside = divide(scale(quartic, 0.4 * law->stiffness), safe);
      bend = scale(roots, 0.375 * law->stiffness);
    }
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

static INLINE bool any(Mask m) {
  Bits bits = m.part[0];
  for (int i = 1; i < PARTS; i++) bits |= m.part[i];
#if WIDTH == 4
  return __builtin_ia32_movmskpd256((Vector)bits) != 0;
#else
  int64_t found = 0;
  for (int i = 0; i < WIDTH; i++) found |= bits[i];
  return found != 0;
#endif
}

static INLINE void law_lanes(const TbLaw *law, uint32_t power, const double *y_at,
                             const double *s_at, double *force_at, double *slope_at,
                             double *mean_at) {
  const Lanes y = load(y_at), s = load(s_at), x = add(y, s);
  Secant secant;
  if (any(greater(larger(x, y), all(law->limit)))) {
    const Knee knee = {all(law->limit), all(law->limit_force), all(law->limit_slope)};
    secant = secant_over_knee(law, power, knee, y, s, x);
  } else {
    secant = secant_of_power(law, power, y, s, x);
  }
  const Lanes factor = add(all(1.0), scale(s, law->loss));
  const Mask touching = either(greater(y, zero()), greater(x, zero()));
  const Mask pushing = both(touching, greater(factor, zero()));
  const Lanes slope = add(multiply_lanes(secant.rise, factor), scale(secant.mean, law->loss));
  store(mean_at, pick(touching, secant.mean, zero()));
  store(force_at, pick(pushing, multiply_lanes(secant.mean, factor), zero()));
  store(slope_at, pick(pushing, slope, zero()));
}

static void law_of(const TbLaw *law, uint32_t power, const double *y, const double *s,
                   double *force, double *slope, double *mean) {
  switch (power) { /* one copy of the code for each */
  case 2: law_lanes(law, 2, y, s, force, slope, mean); break;
  case 3: law_lanes(law, 3, y, s, force, slope, mean); break;
  default: law_lanes(law, 4, y, s, force, slope, mean); break;
  }
}

static void gather(uint32_t count, const uint32_t *rows, const double *from, double *to) {
  for (uint32_t k = 0; k < count; k++) store(to + 8 * k, load(from + rows[k]));
}

static void add_own(uint32_t count, const uint32_t *rows, const double *own, const double *x,
                    double *out) {
  for (uint32_t k = 0; k < count; k++) {
    store(out + 8 * k,
          add(load(out + 8 * k), multiply_lanes(load(own + rows[k]), load(x + 8 * k))));
  }
}

static void miss(const double *x, const double *y, double *most) {
  store(most, larger(load(most), size_of(subtract(load(x), load(y)))));
}

static void residual(const double *s, const double *b, double *r, double *most) {
  const Lanes left = add(load(r), subtract(load(s), load(b)));
  store(r, left);
  store(most, larger(load(most), size_of(left)));
}

static void weigh(uint32_t n, const double *slope, double *weight, double *r) {
  for (uint32_t i = 0; i < n; i += 8) {
    const Lanes w = root(load(slope + i));
    store(weight + i, w);
    store(r + i, subtract(zero(), multiply_lanes(w, load(r + i))));
  }
}

static void balance(double t, const double *s_at, const double *law, const double *slope,
                    const double *f_at, const double *f_last, const double *p, const double *p_last,
                    double *sum) {
  const Lanes s = load(s_at), f = load(f_at), g = subtract(f, load(f_last));
  const Lanes m = subtract(load(p), load(p_last)), moved = add(f, scale(g, t));
  const Lanes left = subtract(load(law), moved);
  const Lanes bend = multiply_lanes(s, add(multiply_lanes(load(slope), m), g));
  store(sum, add(load(sum), multiply_lanes(s, left)));
  store(sum + 8, subtract(load(sum + 8), add(multiply_lanes(m, left), bend)));
  store(sum + 16, add(load(sum + 16), size_of(multiply_lanes(s, moved))));
}

static uint32_t mark(uint32_t blocks, const double *y, const double *s, const double *f,
                     uint8_t *touch) {
  uint32_t count = 0;
  for (uint32_t b = 0; b < blocks; b++) {
    const Lanes before = load(y + 8 * b), after = add(before, load(s + 8 * b));
    const Lanes force = load(f + 8 * b);
    const Lanes most = larger(larger(before, after), size_of(force));
    const Mask m = greater(most, zero());
    touch[b] |= any(m);
    count += touch[b];
  }
  return count;
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
  .dot = dot,
  .add_scaled = add_scaled,
  .add_product = add_product,
  .readout = readout,
  .losses = losses,
  .gather_lines = gather_lines,
  .spread_lines = spread_lines,
  .wire_step = wire_step,
  .wire_losses = wire_losses,
  .law = law_of,
  .gather = gather,
  .add_own = add_own,
  .miss = miss,
  .residual = residual,
  .weigh = weigh,
  .balance = balance,
  .mark = mark,
  .penetrate = penetrate,
  .move = move,
  .product = product,
  .turn = turn,
  .advance = advance,
  .redirect = redirect,
};
