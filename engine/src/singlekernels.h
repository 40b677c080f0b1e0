/* SPDX-License-Identifier: MIT */
/* The loops of the contact solve in single precision (singlesolve.h), and of what the wires do to modes, by the
 * rules of kernels.h: the same bits from every instruction set. */
#ifndef TB_SINGLE_KERNELS_H
#define TB_SINGLE_KERNELS_H

#include "kernels.h"

struct TbLaw;
struct TbSingleBed;

/* One or two vectors that go through the first `part` of a table's n columns at once. */
typedef struct TbSingleGather {
  uint32_t vectors, blocks, n, part;
  const float *matrix, *x[2];
  double *out[2];
} TbSingleGather;

typedef struct TbSingleKernels {
  /* To single precision: out = x, and x - y. */
  void (*narrow)(uint32_t n, const double *x, float *out);
  void (*narrow_difference)(uint32_t n, const double *x, const double *y, float *out);
  /* And back. */
  void (*widen)(uint32_t n, const float *x, double *out);

  /* out[v][8 b + l] = Sum_i matrix[b][i][l] x[v][i], i ascending, i < part */
  void (*gather)(const TbSingleGather *gather);
  /* out = f[0] x[0] + f[1] x[1] + ..., of `count` */
  void (*combine)(uint32_t n, uint32_t count, float *out, const float *f, const float *const *x);
  /* As in kernels.h. */
  TbPair (*ring)(const TbSingleRing *ring);
  TbPair (*two_dots)(uint32_t n, const float *u, const float *v, const float *x);

  /* Between rows x[wires * lanes] and the grid; `scratch` as singlebed.h says. */
  void (*contract)(const struct TbSingleBed *bed, const float *x, float *scratch, float *grid);
  void (*expand)(const struct TbSingleBed *bed, const float *grid, float *scratch, float *x);
  /* out = G grid, class by class. */
  void (*comply)(const struct TbSingleBed *bed, const float *grid, float *out);

  /* The laws of `wires` wires with `lanes` rows each, as `law` in kernels.h; powers of tb_law_power(). */
  void (*laws)(uint32_t wires, uint32_t lanes, const struct TbLaw *laws, const float *y,
               const float *s, float *force, float *slope, float *mean);
  /* Largest |x|, and largest |x - y|. */
  float (*largest)(uint32_t n, const float *x);
  float (*difference)(uint32_t n, const float *x, const float *y);
  /* How many x > 0. */
  uint32_t (*count)(uint32_t n, const float *x);
  void (*subtract)(uint32_t n, const float *x, const float *y, float *out);
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
  void (*balance)(uint32_t n, float t, const float *s, const float *law, const float *slope,
                  const float *f, const float *f_last, const float *p, const float *p_last,
                  float sums[3]);
  float (*lost)(uint32_t n, const float *s, const float *f, const float *mean);
  /* out = base + t (x - before) */
  void (*extrapolate)(uint32_t n, float t, const float *x, const float *before, const float *base,
                      float *out);
} TbSingleKernels;

extern const TbSingleKernels tb_single_kernels_baseline;
#ifdef TB_HAVE_AVX2
extern const TbSingleKernels tb_single_kernels_avx2;
#endif

#endif
