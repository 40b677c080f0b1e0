/* SPDX-License-Identifier: MIT */
/* Between modes and contact points, both ways: w_j = Sum_i phi_i(x_j) q_i, F_i = Sum_j phi_i(x_j) f_j.
 *
 * Wires whose middles lie on one line across are mirror images of themselves. Then even modes move
 * the two points of a mirrored pair alike, odd modes oppositely, and each group of modes needs only
 * one point of each pair: half the points and half the modes, twice, is half the work. */
#ifndef TB_PROJECTION_H
#define TB_PROJECTION_H

#include "kernels.h"
#include "modes.h"

/* One group of modes on the folded points. */
typedef struct TbProjectionGroup {
  uint32_t first, modes; /* in the order of TbModes; a multiple of 8 */
  double *gather;        /* [points/8][modes][8]: to points */
  double *scatter;       /* [modes/8][points][8]: to modes */
} TbProjectionGroup;

typedef struct TbProjection {
  uint32_t groups, points, stride; /* points: folded and padded to 8 */
  uint32_t folded;                 /* points without padding */
  uint32_t *left, *right;          /* [folded]: rows of each pair, equal for one on the mirror */
  TbProjectionGroup group[2];
} TbProjection;

TaborStatus tb_projection_prepare(TbProjection *projection, TbArena *arena, const TbModes *modes,
                                  const TbHead *head, const TbWires *wires);

/* Doubles of scratch that the two functions below need. */
static inline uint32_t tb_projection_scratch(const TbProjection *p) { return 2u * p->points; }

/* w[row] from modal displacements q[padded]; rows beyond the wires' become 0. Audio-safe. */
void tb_project(const TbProjection *projection, const TbKernels *kernels, const double *q,
                double *scratch, double *w);

/* Modal forces of the coupled modes, F[group[groups]], from row forces f[stride]. Audio-safe. */
void tb_project_forces(const TbProjection *projection, const TbKernels *kernels, const double *f,
                       double *scratch, double *modal);

#endif
