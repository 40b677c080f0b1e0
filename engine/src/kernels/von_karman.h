/* SPDX-License-Identifier: MIT */
/* The coupling of a plate's modes (bodies/membrane.h) on a grid of `points` times `angles`: the
 * tables that the kernel of that name works with. */
#ifndef TB_VON_KARMAN_H
#define TB_VON_KARMAN_H

#include <stdint.h>

/* A pair is a radial shape with its two copies, of which that of order 0 has one. Pairs and
 * functions of stress stand by order. */
typedef struct TbVonKarman {
  uint32_t points; /* along the radius, a multiple of 8 */
  uint32_t angles; /* a power of 2 */
  uint32_t pairs, orders, stress_orders;
  const uint32_t *first;        /* [orders + 1]: first pair of each order */
  const uint32_t *first_stress; /* [stress_orders + 1]: first function of stress of each order */
  const float *curvature;       /* [pairs][3][points]: A, B, C */
  const float *stress;          /* [functions][points] */
  const float *rise;            /* b, of each function against the pairs of its order */
  const float *ring;            /* [points]: r dr dtheta [m2] */
  const float *cosine, *sine;   /* [angles] of 2 pi i/angles */
} TbVonKarman;

/* Floats of a drum's scratch for one grid. */
static inline uint32_t tb_von_karman_scratch(const TbVonKarman *plate) {
  return 10u * plate->points * plate->angles;
}

#endif
