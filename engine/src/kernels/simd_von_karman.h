/* SPDX-License-Identifier: MIT */
/* The potential of large deflections and its gradient (bodies/membrane.h), in single precision:
 * for kernels_tmpl.c alone.
 *
 * Fields stand on a grid, [angle][point]: along the radius they are sums of tables, around it of
 * Fourier's series, so that
 *   A, B, C   of the deflection, from modes                      two complex transforms
 *   y_j = Sum Psi_j (A B - C^2) ring                             one
 *   F = Sum_j (x_j + y_j) Psi_j                                  one
 *   dV/dq_k = b_k.y + Sum F (A B_k + B A_k - 2 C C_k) ring       two
 * The gradient is that of the V which the same sums give, to rounding, however coarse the grid.
 * Real fields go in pairs through a complex transform: A with B; C, and A B - C^2, and F C, as one
 * half of the points with the other. */
#ifndef TB_SIMD_VON_KARMAN_H
#define TB_SIMD_VON_KARMAN_H

#include <string.h>

#include "kernels/kernels.h"
#include "kernels/simd_lanes.h"

/* Most points along the radius. */
enum { MOST_POINTS = 64 };

/* A complex field. */
typedef struct Field {
  float *re, *im;
} Field;

/* ---- Fourier transform ----------------------------------------------------------------------- */

typedef struct Complex {
  Lanes re, im;
} Complex;

static INLINE Complex load_complex(Field x, uint32_t at) {
  return (Complex){load(x.re + at), load(x.im + at)};
}

static INLINE void store_complex(Field y, uint32_t at, Complex z) {
  store(y.re + at, z.re);
  store(y.im + at, z.im);
}

static INLINE Complex add_complex(Complex x, Complex y) {
  return (Complex){add(x.re, y.re), add(x.im, y.im)};
}

static INLINE Complex subtract_complex(Complex x, Complex y) {
  return (Complex){subtract(x.re, y.re), subtract(x.im, y.im)};
}

/* x exp(-i t) */
static INLINE Complex turn(Complex x, float cosine, float sine) {
  return (Complex){add(scale(x.re, cosine), scale(x.im, sine)),
                   subtract(scale(x.im, cosine), scale(x.re, sine))};
}

/* Four angles, a quarter of the circle apart, `span` floats each. `turns` is a constant at every
 * call: whether the results turn, by steps of the table. */
static INLINE void butterfly(bool turns, const TbVonKarman *plate, uint32_t step, uint32_t span,
                             const uint32_t from[4], uint32_t to, Field x, Field y) {
  const float c1 = plate->cosine[step], s1 = plate->sine[step];
  const float c2 = plate->cosine[2u * step], s2 = plate->sine[2u * step];
  const float c3 = plate->cosine[3u * step], s3 = plate->sine[3u * step];
  for (uint32_t q = 0; q < span; q += 8) {
    const Complex a = load_complex(x, from[0] + q), b = load_complex(x, from[1] + q);
    const Complex c = load_complex(x, from[2] + q), d = load_complex(x, from[3] + q);
    const Complex even = add_complex(a, c), half = subtract_complex(a, c);
    const Complex odd = add_complex(b, d), across = subtract_complex(b, d);
    const Complex ahead = {add(half.re, across.im), subtract(half.im, across.re)};
    const Complex behind = {subtract(half.re, across.im), add(half.im, across.re)};
    const Complex apart = subtract_complex(even, odd);
    store_complex(y, to + q, add_complex(even, odd));
    store_complex(y, to + span + q, turns ? turn(ahead, c1, s1) : ahead);
    store_complex(y, to + 2u * span + q, turns ? turn(apart, c2, s2) : apart);
    store_complex(y, to + 3u * span + q, turns ? turn(behind, c3, s3) : behind);
  }
}

/* One pass of Stockham's transform with radix 4: of n angles, `span` floats each. */
static INLINE void radix_4(const TbVonKarman *plate, uint32_t n, uint32_t span, Field x, Field y) {
  const uint32_t quarter = n / 4u, step = plate->angles / n, apart = span * quarter;
  for (uint32_t p = 0; p < quarter; p++) {
    const uint32_t at = span * p;
    const uint32_t from[4] = {at, at + apart, at + 2u * apart, at + 3u * apart};
    if (p == 0) {
      butterfly(false, plate, 0, span, from, 0, x, y);
    } else {
      butterfly(true, plate, p * step, span, from, 4u * at, x, y);
    }
  }
}

static INLINE void radix_2(uint32_t span, const float *x, float *y) {
  for (uint32_t q = 0; q < span; q += 8) {
    const Lanes a = load(x + q), b = load(x + span + q);
    store(y + q, add(a, b));
    store(y + span + q, subtract(a, b));
  }
}

/* Sum_j x_j exp(-2 pi i j k/n) of `width` floats an angle. The result stands in *x, and what *x was
 * or the work, whichever is left, in *work. */
static void transform(const TbVonKarman *plate, uint32_t width, Field *x, Field *work) {
  uint32_t n = plate->angles, span = width;
  Field from = *x, to = *work;
  for (; n > 1u; n /= 4u) {
    if (n == 2u) {
      radix_2(span, from.re, to.re);
      radix_2(span, from.im, to.im);
    } else {
      radix_4(plate, n, span, from, to);
    }
    const Field swap = from;
    from = to, to = swap;
    span *= 4u;
    if (n == 2u) break;
  }
  *x = from, *work = to;
}

/* Sum_k x_k exp(2 pi i j k/n). */
static void transform_back(const TbVonKarman *plate, uint32_t width, Field *x, Field *work) {
  Field turned = {x->im, x->re}, turned_work = {work->im, work->re};
  transform(plate, width, &turned, &turned_work);
  *x = (Field){turned.im, turned.re};
  *work = (Field){turned_work.im, turned_work.re};
}

/* ---- modes to fields ------------------------------------------------------------------------- */

/* The angle of exp(-i m theta). */
static INLINE uint32_t mirrored(const TbVonKarman *plate, uint32_t m) {
  return m ? plate->angles - m : 0u;
}

/* Sums over the pairs of one order, [points]: cosine and sine parts of A and B, and of C. */
typedef struct Synthesis {
  float a[2][MOST_POINTS], b[2][MOST_POINTS], c[2][MOST_POINTS];
} Synthesis;

static INLINE void synthesize(const TbVonKarman *plate, uint32_t m, const float *q,
                              Synthesis *sums) {
  const uint32_t points = plate->points;
  for (uint32_t v = 0; v < points; v += 8) {
    Lanes ac = zero(), as = zero(), bc = zero(), bs = zero(), cc = zero(), cs = zero();
    for (uint32_t i = plate->first[m]; i < plate->first[m + 1u]; i++) {
      const float *at = plate->curvature + (size_t)3u * points * i + v;
      const Lanes a = load(at), b = load(at + points), c = load(at + 2u * points);
      ac = add(ac, scale(a, q[2u * i]));
      as = add(as, scale(a, q[2u * i + 1u]));
      bc = add(bc, scale(b, q[2u * i]));
      bs = add(bs, scale(b, q[2u * i + 1u]));
      cc = add(cc, scale(c, q[2u * i + 1u]));
      cs = subtract(cs, scale(c, q[2u * i]));
    }
    store(sums->a[0] + v, ac);
    store(sums->a[1] + v, as);
    store(sums->b[0] + v, bc);
    store(sums->b[1] + v, bs);
    store(sums->c[0] + v, cc);
    store(sums->c[1] + v, cs);
  }
}

/* The spectrum of A + i B at orders m and -m. */
static INLINE void spread_both(const TbVonKarman *plate, uint32_t m, const Synthesis *s, Field z) {
  const uint32_t points = plate->points, up = m * points, down = mirrored(plate, m) * points;
  for (uint32_t v = 0; v < points; v += 8) {
    const Lanes ac = load(s->a[0] + v), as = load(s->a[1] + v);
    const Lanes bc = load(s->b[0] + v), bs = load(s->b[1] + v);
    const float half = m ? 0.5f : 1.0f;
    store(z.re + up + v, scale(add(ac, bs), half));
    store(z.im + up + v, scale(subtract(bc, as), half));
    if (m == 0) continue;
    store(z.re + down + v, scale(subtract(ac, bs), half));
    store(z.im + down + v, scale(add(as, bc), half));
  }
}

/* The spectrum, at orders m and -m, of a real field with these cosine and sine parts, its points'
 * first half with i times the second. */
static INLINE void spread_halves(const TbVonKarman *plate, uint32_t m, const float *cosine,
                                 const float *sine, Field z) {
  const uint32_t half = plate->points / 2u, up = m * half, down = mirrored(plate, m) * half;
  const float part = m ? 0.5f : 1.0f;
  for (uint32_t v = 0; v < half; v += 8) {
    const Lanes pc = load(cosine + v), ps = load(sine + v);
    const Lanes qc = load(cosine + half + v), qs = load(sine + half + v);
    store(z.re + up + v, scale(add(pc, qs), part));
    store(z.im + up + v, scale(subtract(qc, ps), part));
    if (m == 0) continue;
    store(z.re + down + v, scale(subtract(pc, qs), part));
    store(z.im + down + v, scale(add(ps, qc), part));
  }
}

/* Orders without pairs, up to the mirrored ones. */
static void clear_orders(const TbVonKarman *plate, uint32_t orders, uint32_t width, Field z) {
  const size_t count = (size_t)(plate->angles - 2u * orders + 1u) * width;
  memset(z.re + (size_t)orders * width, 0, count * sizeof(float));
  memset(z.im + (size_t)orders * width, 0, count * sizeof(float));
}

static void to_fields(const TbVonKarman *plate, const float *q, Field both, Field twist) {
  clear_orders(plate, plate->orders, plate->points, both);
  clear_orders(plate, plate->orders, plate->points / 2u, twist);
  for (uint32_t m = 0; m < plate->orders; m++) {
    Synthesis sums;
    synthesize(plate, m, q, &sums);
    spread_both(plate, m, &sums, both);
    spread_halves(plate, m, sums.c[0], sums.c[1], twist);
  }
}

/* ---- fields to amplitudes -------------------------------------------------------------------- */

/* Cosine and sine parts of order m, [points], of two real fields whose spectrum is that of the
 * first plus i times the second. */
static INLINE void part_both(const TbVonKarman *plate, uint32_t m, Field z, const float *weight,
                             float *c0, float *s0, float *c1, float *s1) {
  const uint32_t points = plate->points, up = m * points, down = mirrored(plate, m) * points;
  for (uint32_t v = 0; v < points; v += 8) {
    const Lanes ring = load(weight + v);
    const Lanes ur = load(z.re + up + v), ui = load(z.im + up + v);
    const Lanes dr = load(z.re + down + v), di = load(z.im + down + v);
    store(c0 + v, multiply_lanes(scale(add(ur, dr), 0.5f), ring));
    store(s0 + v, multiply_lanes(scale(subtract(di, ui), 0.5f), ring));
    store(c1 + v, multiply_lanes(scale(add(ui, di), 0.5f), ring));
    store(s1 + v, multiply_lanes(scale(subtract(ur, dr), 0.5f), ring));
  }
}

/* The same of one real field, whose halves stand in the spectrum. */
static INLINE void part_halves(const TbVonKarman *plate, uint32_t m, Field z, const float *weight,
                               float *cosine, float *sine) {
  const uint32_t half = plate->points / 2u, up = m * half, down = mirrored(plate, m) * half;
  for (uint32_t v = 0; v < half; v += 8) {
    const Lanes near = load(weight + v), far = load(weight + half + v);
    const Lanes ur = load(z.re + up + v), ui = load(z.im + up + v);
    const Lanes dr = load(z.re + down + v), di = load(z.im + down + v);
    store(cosine + v, multiply_lanes(scale(add(ur, dr), 0.5f), near));
    store(sine + v, multiply_lanes(scale(subtract(di, ui), 0.5f), near));
    store(cosine + half + v, multiply_lanes(scale(add(ui, di), 0.5f), far));
    store(sine + half + v, multiply_lanes(scale(subtract(ur, dr), 0.5f), far));
  }
}

static INLINE float dot_points(uint32_t points, const float *x, const float *y) {
  Lanes sum = zero();
  for (uint32_t v = 0; v < points; v += 8) sum = add(sum, multiply_lanes(load(x + v), load(y + v)));
  return join(sum);
}

static INLINE void axpy_points(uint32_t points, float *out, float f, const float *x) {
  for (uint32_t v = 0; v < points; v += 8)
    store(out + v, add(load(out + v), scale(load(x + v), f)));
}

/* Two sums over the pairs of one order: Sum b q of either copy. */
static INLINE TbPair rise_of(const float *rise, uint32_t pairs, const float *q) {
  float c = 0.0f, s = 0.0f;
  for (uint32_t i = 0; i < pairs; i++) {
    c += rise[i] * q[2u * i];
    s += rise[i] * q[2u * i + 1u];
  }
  return (TbPair){(double)c, (double)s};
}

/* From A B - C^2 to F, order by order: returns V's coupling terms Sum x y + y^2/2, and adds b y to
 * the gradient. */
static double stress_function(const TbVonKarman *plate, const float *q, Field product, Field f,
                              float *gradient) {
  const uint32_t points = plate->points;
  const float *rise = plate->rise;
  double potential = 0.0;
  clear_orders(plate, plate->stress_orders, points / 2u, f);
  for (uint32_t m = 0; m < plate->stress_orders; m++) {
    float cosine[MOST_POINTS], sine[MOST_POINTS];
    float f_cosine[MOST_POINTS] = {0.0f}, f_sine[MOST_POINTS] = {0.0f};
    const uint32_t first = plate->first[m], pairs = plate->first[m + 1u] - first;
    part_halves(plate, m, product, plate->ring, cosine, sine);
    for (uint32_t j = plate->first_stress[m]; j < plate->first_stress[m + 1u]; j++) {
      const float *stress = plate->stress + (size_t)points * j;
      const float yc = dot_points(points, cosine, stress);
      const float ys = m ? dot_points(points, sine, stress) : 0.0f;
      const TbPair x = rise_of(rise, pairs, q + 2u * first);
      const float xc = (float)x.first, xs = (float)x.second;
      potential += (double)yc * (double)(xc + 0.5f * yc) + (double)ys * (double)(xs + 0.5f * ys);
      for (uint32_t i = 0; i < pairs; i++) {
        gradient[2u * (first + i)] += rise[i] * yc;
        gradient[2u * (first + i) + 1u] += rise[i] * ys;
      }
      axpy_points(points, f_cosine, xc + yc, stress);
      axpy_points(points, f_sine, xs + ys, stress);
      rise += pairs;
    }
    spread_halves(plate, m, f_cosine, f_sine, f);
  }
  return potential;
}

/* Sum F (A B_k + B A_k - 2 C C_k) ring, added to the gradient. */
static void to_gradient(const TbVonKarman *plate, Field both, Field twist, float *gradient) {
  const uint32_t points = plate->points;
  for (uint32_t m = 0; m < plate->orders; m++) {
    float ac[MOST_POINTS], as[MOST_POINTS], bc[MOST_POINTS], bs[MOST_POINTS];
    float cc[MOST_POINTS], cs[MOST_POINTS];
    part_both(plate, m, both, plate->ring, ac, as, bc, bs);
    part_halves(plate, m, twist, plate->ring, cc, cs);
    for (uint32_t i = plate->first[m]; i < plate->first[m + 1u]; i++) {
      const float *at = plate->curvature + (size_t)3u * points * i;
      Lanes cosine = zero(), sine = zero();
      for (uint32_t v = 0; v < points; v += 8) {
        const Lanes a = load(at + v), b = load(at + points + v), c = load(at + 2u * points + v);
        const Lanes bent_c = add(multiply_lanes(load(ac + v), b), multiply_lanes(load(bc + v), a));
        const Lanes bent_s = add(multiply_lanes(load(as + v), b), multiply_lanes(load(bs + v), a));
        cosine = add(cosine, add(bent_c, multiply_lanes(scale(load(cs + v), 2.0f), c)));
        sine = add(sine, subtract(bent_s, multiply_lanes(scale(load(cc + v), 2.0f), c)));
      }
      gradient[2u * i] += join(cosine);
      if (m) gradient[2u * i + 1u] += join(sine);
    }
  }
}

/* ---- all of it ------------------------------------------------------------------------------- */

/* A B - C^2, its points' halves as real and imaginary part; C stands so, too. */
static void multiply_fields(const TbVonKarman *plate, Field both, Field twist, Field product) {
  const uint32_t points = plate->points, half = points / 2u;
  for (uint32_t j = 0; j < plate->angles; j++) {
    for (uint32_t v = 0; v < half; v += 8) {
      const uint32_t near = j * points + v, far = near + half, at = j * half + v;
      const Lanes c0 = load(twist.re + at), c1 = load(twist.im + at);
      store(product.re + at, subtract(multiply_lanes(load(both.re + near), load(both.im + near)),
                                      multiply_lanes(c0, c0)));
      store(product.im + at, subtract(multiply_lanes(load(both.re + far), load(both.im + far)),
                                      multiply_lanes(c1, c1)));
    }
  }
}

/* Multiplies all by F. */
static void multiply_by(const TbVonKarman *plate, Field f, Field both, Field twist) {
  const uint32_t points = plate->points, half = points / 2u;
  for (uint32_t j = 0; j < plate->angles; j++) {
    for (uint32_t v = 0; v < half; v += 8) {
      const uint32_t near = j * points + v, far = near + half, at = j * half + v;
      const Lanes f0 = load(f.re + at), f1 = load(f.im + at);
      store(both.re + near, multiply_lanes(load(both.re + near), f0));
      store(both.im + near, multiply_lanes(load(both.im + near), f0));
      store(both.re + far, multiply_lanes(load(both.re + far), f1));
      store(both.im + far, multiply_lanes(load(both.im + far), f1));
      store(twist.re + at, multiply_lanes(load(twist.re + at), f0));
      store(twist.im + at, multiply_lanes(load(twist.im + at), f1));
    }
  }
}

static double von_karman(const TbVonKarman *plate, const float *q, float *gradient,
                         float *scratch) {
  const uint32_t size = plate->points * plate->angles, half = plate->points / 2u;
  Field both = {scratch, scratch + size}, work = {scratch + 2u * size, scratch + 3u * size};
  Field twist = {scratch + 4u * size, scratch + 4u * size + size / 2u};
  Field twist_work = {scratch + 5u * size, scratch + 5u * size + size / 2u};
  Field product = {scratch + 6u * size, scratch + 6u * size + size / 2u};
  Field product_work = {scratch + 7u * size, scratch + 7u * size + size / 2u};
  Field f = {scratch + 8u * size, scratch + 8u * size + size / 2u};
  Field f_work = {scratch + 9u * size, scratch + 9u * size + size / 2u};
  memset(gradient, 0, 2u * plate->pairs * sizeof *gradient);
  to_fields(plate, q, both, twist);
  transform_back(plate, plate->points, &both, &work);
  transform_back(plate, half, &twist, &twist_work);
  multiply_fields(plate, both, twist, product);
  transform(plate, half, &product, &product_work);
  const double potential = stress_function(plate, q, product, f, gradient);
  transform_back(plate, half, &f, &f_work);
  multiply_by(plate, f, both, twist);
  transform(plate, plate->points, &both, &work);
  transform(plate, half, &twist, &twist_work);
  to_gradient(plate, both, twist, gradient);
  return potential;
}

#endif
