/* SPDX-License-Identifier: MIT */
/* The loops that take the time, compiled once per instruction set from one source.
 *
 * Every choice computes the same bits: sums run in 8 fixed lanes that one fixed tree joins, or term
 * by term in ascending order into independent results; nothing is contracted into fused operations.
 * Lengths are multiples of 8 (only `multiply` takes any n), arrays aligned to 64 bytes. Audio-safe. */
#ifndef TB_KERNELS_H
#define TB_KERNELS_H

#include <stdbool.h>
#include <stdint.h>

struct TbBed;
struct TbLaw;
struct TbWireCoefficients;

typedef struct TbPair {
  double first, second;
} TbPair;

/* Parts of the modes' arrays: `size` from each `from` on. */
typedef struct TbParts {
  uint32_t count, from[5], size[5];
} TbParts;

/* Heads that stretch, one or two (stretch.h). */
typedef struct TbStretching {
  uint32_t heads;
  const double *gain[2], *g, *q, *next, *last; /* [modes] */
  double *pull[2];                             /* [modes], out */
  double along[2], own[2][2];                  /* out */
} TbStretching;

/* One or two vectors that go through the beginning of a table at once; the matrix is of single precision if
 * `single` is there. */
typedef struct TbGather {
  uint32_t vectors, blocks, n, part; /* of the table's n columns the first `part` */
  const double *matrix;
  const float *single;
  const double *x[2];
  double *out[2];
} TbGather;

/* Neighbouring modes of the high band, up to `end`. */
typedef struct TbRingPart {
  uint32_t end;
  bool pushed, held;
} TbRingPart;

typedef struct TbRingParts {
  uint32_t count;
  TbRingPart part[4];
  double loss, most; /* of what is held */
} TbRingParts;

/* A step of the high band, heard by one microphone (listen.h), in either precision; arrays are [modes], `push` is
 * read where modes are pushed, `hold` where they are held. */
#define TB_RING(name, real)                                                                        \
  typedef struct name {                                                                            \
    TbRingParts parts;                                                                             \
    const real *a, *b, *now, *last, *hold, *ahead, *behind;                                        \
    const float *push;                                                                             \
    real *next;                                                                                    \
  } name
TB_RING(TbRing, double);
TB_RING(TbSingleRing, float);

typedef struct TbKernels {
  /* out = a x - b y */
  void (*two_step)(uint32_t n, double *out, const double *a, const double *x, const double *b,
                   const double *y);
  /* out[8 b + l] = Sum_i matrix[b][i][l] x[i], i ascending, for b < blocks, i < n */
  void (*multiply)(uint32_t blocks, uint32_t n, double *out, const double *matrix, const double *x);
  /* The same with a matrix of single precision, summed in double. */
  void (*multiply_single)(uint32_t blocks, uint32_t n, double *out, const float *matrix,
                          const double *x);
  /* out[v][8 b + l] = Sum_i matrix[b][i][l] x[v][i], i ascending, i < part */
  void (*gather)(const TbGather *gather);
  /* y_h = gain_h q, pull_h = g y_h, along_h = Sum y_h (next + last), own_hl = Sum y_h pull_l */
  void (*stretch)(const TbParts *parts, TbStretching *stretching);
  /* next += f_0 pull_0 + f_1 pull_1, the latter for two heads */
  void (*unstretch)(const TbParts *parts, uint32_t heads, const double f[2],
                    const double *const pull[2], double *next);
  /* Sum c |x| */
  double (*reach)(uint32_t n, const double *c, const double *x);
  /* Sum x y */
  double (*dot)(uint32_t n, const double *x, const double *y);
  /* out += f x */
  void (*add_scaled)(uint32_t n, double *out, double f, const double *x);
  /* next = a now - b last + push, then next += min(loss hold, most) (last - next); Sum ahead next and
   * Sum behind next. */
  TbPair (*ring)(const TbRing *ring);
  /* out += x y */
  void (*add_product)(uint32_t n, double *out, const double *x, const double *y);
  /* Sum u x and Sum v x */
  TbPair (*two_dots)(uint32_t n, const double *u, const double *v, const double *x);
  /* sums[i] = Sum w[i] d^2, d = next - last, for i < count, 2 or 3 */
  void (*losses)(uint32_t n, uint32_t count, const double *const w[3], const double *next,
                 const double *last, double sums[3]);

  /* The bed (bed.h), between x[wires][lanes] and lines[lines][lanes]. Where the bed is its own mirror image
   * across, wires and their images go in pairs, and lines are even under the exchange of the two before the
   * odd ones: lines[l] = Sum over pairs of across[v][l] (x[v] +- x[image]) */
  void (*gather_lines)(const struct TbBed *bed, const double *x, double *lines);
  /* x[v], x[image] = Sum over even lines of across[v][l] lines[l] +- Sum over odd ones */
  void (*spread_lines)(const struct TbBed *bed, const double *lines, double *x);

  /* Wires (wires.h), coefficients of each and v at its `lanes`, readable one lane before and after; inner is 1
   * at inner nodes, else 0. One step without forces; `bend` is scratch, readable like v. */
  void (*wire_step)(uint32_t wires, uint32_t lanes, const struct TbWireCoefficients *c,
                    const double *inner, const double *now, const double *last, double *bend,
                    double *next);
  /* What they lose in a step, Sum over wires of loss_0 Sum d^2 + loss_1 Sum (d[i] - d[i-1])^2, d = next - last. */
  double (*wire_losses)(uint32_t wires, uint32_t lanes, const struct TbWireCoefficients *c,
                        const double *next, const double *last);
  /* out[l] = Sum over wires of f[w][l]; returns Sum loss f. */
  double (*gather_wires)(uint32_t wires, uint32_t lanes, const double *f, const double *loss,
                         double *out);

  /* Contacts (solve.h), law.h's formulas for an exponent of 1, 3/2 or 2 (power 2, 3 or 4): force and
   * slope at s, and the mean of V' between y and y + s. */
  void (*law)(const struct TbLaw *law, uint32_t power, uint32_t n, const double *y, const double *s,
              double *force, double *slope, double *mean);
  /* Whether y > 0, y + s > 0 or f != 0 anywhere. */
  bool (*touches)(uint32_t n, const double *y, const double *s, const double *f);
  /* Largest |b|, and largest y or 0. */
  TbPair (*sizes)(uint32_t n, const double *b, const double *y);
  /* Largest |x - y| */
  double (*difference)(uint32_t n, const double *x, const double *y);
  /* out = x - y */
  void (*subtract)(uint32_t n, const double *x, const double *y, double *out);
  /* out = base + t (x - before) */
  void (*extrapolate)(uint32_t n, double t, const double *x, const double *before,
                      const double *base, double *out);
  /* r = (s - b) + p; largest |r| */
  double (*residual)(uint32_t n, const double *s, const double *b, const double *p, double *r);
  /* weight = sqrt(slope), r = -weight r */
  void (*weigh)(uint32_t n, const double *slope, double *weight, double *r);
  /* With g = f - f_last, m = p - p_last, f' = f + t g: Sum s (law - f'), its derivative in t, which is
   * -Sum m (law - f') + s (slope m + g), and Sum |s f'|. */
  void (*balance)(uint32_t n, double t, const double *s, const double *law, const double *slope,
                  const double *f, const double *f_last, const double *p, const double *p_last,
                  double sums[3]);
  /* Sum s (f - mean) */
  double (*lost)(uint32_t n, const double *s, const double *f, const double *mean);
  /* eta = (side w - v) + rest + shift, the wire's, b = (eta - last) + load */
  void (*penetrate)(uint32_t wires, uint32_t lanes, double side, const double *shift,
                    const double *w, const double *v, const double *rest, const double *last,
                    const double *load, double *b);
  /* v += own (f - rest), eta = last + s */
  void (*move)(uint32_t n, const double *own, const double *f, const double *rest,
               const double *last, const double *s, double *v, double *eta);

  /* Conjugate gradients: out = x y; out = d + w m, returns Sum d out; p += t d, r -= t m, returns
   * Sum r r; d = r + t d. */
  void (*product)(uint32_t n, double *out, const double *x, const double *y);
  double (*turn)(uint32_t n, double *out, const double *d, const double *w, const double *m);
  double (*advance)(uint32_t n, double t, double *p, const double *d, double *r, const double *m);
  void (*redirect)(uint32_t n, double t, double *d, const double *r);
} TbKernels;

extern const TbKernels tb_kernels_baseline;
#ifdef TB_HAVE_AVX2
extern const TbKernels tb_kernels_avx2;
#endif
#ifdef TB_HAVE_AVX512
extern const TbKernels tb_kernels_avx512;
#endif

#endif
