/* SPDX-License-Identifier: MIT */
/* The loops that take the time, compiled once per instruction set from one source.
 *
 * Every choice computes the same bits: sums run in 8 fixed lanes that one fixed tree joins, or term
 * by term in ascending order into independent results; nothing is contracted into fused operations.
 * Lengths are multiples of 8 (only `multiply` takes any n), arrays aligned to 64 bytes. Audio-safe. */
#ifndef TB_KERNELS_H
#define TB_KERNELS_H

#include <stdint.h>

typedef struct TbPair {
  double first, second;
} TbPair;

typedef struct TbKernels {
  /* out = a x - b y */
  void (*two_step)(uint32_t n, double *out, const double *a, const double *x, const double *b,
                   const double *y);
  /* out[8 b + l] = Sum_i matrix[b][i][l] x[i], i ascending, for b < blocks, i < n */
  void (*multiply)(uint32_t blocks, uint32_t n, double *out, const double *matrix, const double *x);
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
} TbKernels;

extern const TbKernels tb_kernels_baseline;
#ifdef TB_HAVE_AVX2
extern const TbKernels tb_kernels_avx2;
#endif

#endif
