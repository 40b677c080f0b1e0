/* SPDX-License-Identifier: MIT */
/* The loops that take the time, compiled once per instruction set from one source.
 *
 * Every choice computes the same bits: sums run in 8 fixed lanes that one fixed tree joins, or term
 * by term in ascending order into independent results; nothing is contracted into fused operations.
 * Lengths are multiples of 8 (only `multiply` takes any n), arrays aligned to 64 bytes. Audio-safe. */
#ifndef TB_KERNELS_H
#define TB_KERNELS_H

#include <stdint.h>

struct TbLaw;

typedef struct TbPair {
  double first, second;
} TbPair;

typedef struct TbKernels {
  /* out = a x - b y */
  void (*two_step)(uint32_t n, double *out, const double *a, const double *x, const double *b,
                   const double *y);
  /* out[8 b + l] = Sum_i matrix[b][i][l] x[i], i ascending, for b < blocks, i < n */
  void (*multiply)(uint32_t blocks, uint32_t n, double *out, const double *matrix, const double *x);
  /* The same with a matrix of single precision, summed in double. */
  void (*multiply_single)(uint32_t blocks, uint32_t n, double *out, const float *matrix,
                          const double *x);
  /* Sum x y */
  double (*dot)(uint32_t n, const double *x, const double *y);
  /* out += f x */
  void (*add_scaled)(uint32_t n, double *out, double f, const double *x);
  /* out += x y */
  void (*add_product)(uint32_t n, double *out, const double *x, const double *y);
  /* Sum u (next - 2 now + last) + v (next - last) */
  double (*readout)(uint32_t n, const double *u, const double *v, const double *next,
                    const double *now, const double *last);
  /* Sum u d^2 and Sum v d^2, d = next - last */
  TbPair (*losses)(uint32_t n, const double *u, const double *v, const double *next,
                   const double *last);

  /* The bed (bed.h): `count` blocks of 8 lanes at x[at[k]] with their images at x[image[k]], against
   * `lines` of `lanes` doubles, the first `even` of them even under the exchange of the two.
   * lines[l][0..7] = Sum_k across[wire[k]][l] (x_k +- x_image) */
  void (*gather_lines)(uint32_t even, uint32_t lines, uint32_t lanes, uint32_t count,
                       const uint32_t *wire, const uint32_t *at, const uint32_t *image,
                       const double *across, const double *x, double *to);
  /* x_k, x_image = Sum_even across[wire[k]][l] lines[l][0..7] +- Sum_odd */
  void (*spread_lines)(uint32_t even, uint32_t lines, uint32_t lanes, uint32_t count,
                       const uint32_t *wire, const uint32_t *at, const uint32_t *image,
                       const double *across, const double *from, double *x);

  /* Wires (wires.h): v at n lanes, readable one lane before and after; inner is 1 at inner nodes, else
   * 0. c = {gain, keep, stretch, bend, diffuse}; `bend` and `bend_last` are scratch, readable one lane
   * before and after. */
  void (*wire_step)(uint32_t n, const double *c, const double *inner, const double *now,
                    const double *last, double *bend, double *bend_last, double *next);
  /* Sum d^2 and Sum (d[i] - d[i-1])^2, d = next - last */
  TbPair (*wire_losses)(uint32_t n, const double *next, const double *last);

  /* Contacts (solve.h), law.h's formulas for an exponent of 1, 3/2 or 2 (power 2, 3 or 4), in 8 lanes:
   * force and slope at s, and the mean of V' between y and y + s. */
  void (*law)(const struct TbLaw *law, uint32_t power, const double *y, const double *s,
              double *force, double *slope, double *mean);
  /* Blocks of 8 rows, of which block k begins at rows[k]: to_k = from[rows[k]], and
   * out_k += own[rows[k]] x_k */
  void (*gather)(uint32_t count, const uint32_t *rows, const double *from, double *to);
  void (*add_own)(uint32_t count, const uint32_t *rows, const double *own, const double *x,
                  double *out);
  /* Largest |x - y| in 8 lanes, or `most` if that is larger, lane by lane into most[8]. */
  void (*miss)(const double *x, const double *y, double *most);
  /* r = r + (s - b) in 8 lanes, |r| as above. */
  void (*residual)(const double *s, const double *b, double *r, double *most);
  /* weight = sqrt(slope), r = -weight r */
  void (*weigh)(uint32_t n, const double *slope, double *weight, double *r);
  /* In 8 lanes, with g = f - f_last, m = p - p_last: f + t g against the law's force at s - what
   * TbSolve calls balance: sum[0..7] += s (law - f'), sum[8..] -= m (law - f') + s (slope m + g),
   * sum[16..] += |s f'|. */
  void (*balance)(double t, const double *s, const double *law, const double *slope,
                  const double *f, const double *f_last, const double *p, const double *p_last,
                  double *sum);
  /* touch[b] |= 1 where one of 8 lanes has y > 0, y + s > 0 or f != 0; the number of such blocks */
  uint32_t (*mark)(uint32_t blocks, const double *y, const double *s, const double *f,
                   uint8_t *touch);
  /* eta = (side w - v) + rest + shift, b = (eta - last) + load */
  void (*penetrate)(uint32_t n, double side, double shift, const double *w, const double *v,
                    const double *rest, const double *last, const double *load, double *b);
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
