/* SPDX-License-Identifier: MIT */
/* The loops of the contact solve in single precision (singlesolve.h), and of what the wires do to modes, by the
 * rules of kernels.h: the same bits from every instruction set. */
#ifndef TB_SINGLE_KERNELS_H
#define TB_SINGLE_KERNELS_H

#include "kernels/kernels.h"

/* Penetrations of single precision that may be none: it rounds gaps of millimetres by less. [m] */
#define TB_NEAR 1e-9f

struct TbLaw;
struct TbSingleBed;

/* One or two vectors that go through the first `part` of a table's n columns at once; part is a multiple of 4. What few
 * rows `blocks` blocks of eight leave come from the transposed table, [n/8][stride][8], where they are neighbours;
 * part is a multiple of 8 then. */
typedef struct TbSingleGather {
  uint32_t vectors, blocks, n, part;
  uint32_t rest, stride;
  const float *matrix, *transposed, *x[2];
  double *out[2];
} TbSingleGather;

/* The way in: everything in single precision, root = sqrt(y) or 0, s = b - p, the largest |b|, and the largest y
 * or 0. */
typedef struct TbSingleStart {
  const double *from_b, *from_p, *from_y, *from_own, *from_f;
  float *b, *p, *y, *root, *own, *f, *s;
  float change, depth;
} TbSingleStart;

/* The way out: f + t (f - f_last), the same of p, and s = b - p, in double; Sum s (law - mean), and how many
 * slopes > 0. */
typedef struct TbSingleEnd {
  float t;
  const float *b, *f, *f_last, *p, *p_last, *law, *mean, *slope;
  double *to_f, *to_p, *to_s;
  float lost;
  uint32_t touching;
} TbSingleEnd;

/* What a balance is made of (kernels.h), the largest |law - f|, and the largest |f|. */
typedef struct TbSingleSums {
  float value, derivative, size, miss, most;
} TbSingleSums;

typedef struct TbSingleKernels {
  /* To single precision, x and x - y, and back. */
  void (*narrow)(uint32_t n, const double *x, float *out);
  void (*narrow_change)(uint32_t n, const double *x, const double *y, float *out);
  void (*widen)(uint32_t n, const float *x, double *out);
  /* out += x */
  void (*add_widened)(uint32_t n, const float *x, double *out);
  void (*start)(uint32_t n, TbSingleStart *start);
  void (*end)(uint32_t n, TbSingleEnd *end);

  /* out[v][8 b + l] = Sum_i matrix[b][i][l] x[v][i], i < part */
  void (*gather)(const TbSingleGather *gather);
  /* out = f[0] x[0] + f[1] x[1] + ... - base, of `count` */
  void (*combine)(uint32_t n, uint32_t count, const float *f, const float *const *x,
                  const float *base, float *out);
  /* As in kernels.h. */
  TbPair (*ring)(const TbSingleRing *ring);
  TbPair (*two_dots)(uint32_t n, const float *u, const float *v, const float *x);

  /* b = (side w - (v - v_last)) + load; whether y or y + b is above -TB_NEAR anywhere. */
  bool (*penetrate)(uint32_t n, float side, const float *w, const double *v, const double *v_last,
                    const double *load, const double *y, double *b);

  /* Between rows x[wires * lanes] and the grid; `scratch` as singlebed.h says. */
  void (*contract)(const struct TbSingleBed *bed, const float *x, float *scratch, float *grid);
  void (*expand)(const struct TbSingleBed *bed, const float *grid, float *scratch, float *x);
  /* out = G grid, class by class. */
  void (*comply)(const struct TbSingleBed *bed, const float *grid, float *out);

  /* The laws of `wires` wires with `lanes` rows each, as `law` in kernels.h; powers of tb_law_power();
   * root = sqrt(y), 0 where y < 0. */
  void (*laws)(uint32_t wires, uint32_t lanes, const struct TbLaw *laws, const float *y,
               const float *root, const float *s, float *force, float *slope, float *mean);
  /* Largest |x - y| */
  float (*difference)(uint32_t n, const float *x, const float *y);
  /* f = f_last + (law - f_last)/(1 + slope (own + head)) */
  void (*relax)(uint32_t n, const float *law, const float *slope, const float *own,
                const float *head, const float *f_last, float *f);
  /* s = b - p; largest |s| */
  float (*change)(uint32_t n, const float *b, const float *p, float *s);
  /* f = law + weight x, s = b - p; largest |s| */
  float (*follow)(uint32_t n, const float *law, const float *weight, const float *x, const float *b,
                  const float *p, float *f, float *s);
  /* Sum x y */
  float (*dot)(uint32_t n, const float *x, const float *y);
  /* out += f x; out += x y; out = x y */
  void (*add_scaled)(uint32_t n, float *out, float f, const float *x);
  void (*add_product)(uint32_t n, float *out, const float *x, const float *y);
  void (*product)(uint32_t n, float *out, const float *x, const float *y);
  /* weight = sqrt(slope), d = -weight (p - p_last); Sum d d */
  float (*weigh)(uint32_t n, const float *slope, const float *p, const float *p_last, float *weight,
                 float *d);
  /* Conjugate gradients as in kernels.h. */
  float (*turn)(uint32_t n, float *out, const float *d, const float *w, const float *m);
  float (*advance)(uint32_t n, float t, float *p, const float *d, float *r, const float *m);
  void (*redirect)(uint32_t n, float t, float *d, const float *r);
  /* As in kernels.h. */
  TbSingleSums (*balance)(uint32_t n, float t, const float *s, const float *law, const float *slope,
                          const float *f, const float *f_last, const float *p, const float *p_last);
  /* out = base + t (x - before) */
  void (*extrapolate)(uint32_t n, float t, const float *x, const float *before, const float *base,
                      float *out);
} TbSingleKernels;

extern const TbSingleKernels tb_single_kernels_baseline;
#ifdef TB_HAVE_AVX2
extern const TbSingleKernels tb_single_kernels_avx2;
#endif

#endif
