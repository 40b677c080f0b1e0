/* SPDX-License-Identifier: MIT */
/* The shape of a drum to the eye: heads on a polar grid, wires, sticks.
 *
 * A head is displaced at radius r_i and angle t_j by a sum over its modes,
 *   w(r_i, t_j) = Sum_m (C_m(r_i) cos(m t_j) + S_m(r_i) sin(m t_j)),
 *   C_m(r_i) = Sum over the modes of order m of R(r_i) q,
 * R the mode's radial shape relative to the bearing edge (bodies/body.h), q its displacement with
 * that of rest; S_m likewise of the sine copies; t counts from the model's axis. So there are
 * tables of R over radii and of cosines over angles, and none over both. Limiting case: at the
 * centre w is the probe's height. */
#ifndef TB_VIEW_H
#define TB_VIEW_H

#include "state/state.h"

/* A mode that moves this head: its index among the model's modes, its order's sum, and R. */
typedef struct TbViewMode {
  uint32_t mode, sum; /* sum: 2 m, and 1 more for a sine copy */
  const double *radial;
} TbViewMode;

typedef struct TbViewHead {
  uint32_t count;
  TbViewMode *modes;
  double *displacement; /* [radii][angles] */
} TbViewHead;

typedef struct TbViewTables {
  TaborView seen; /* first: what the caller has */
  TbArena arena;
  TaborModel *model;
  double bandwidth; /* as asked [Hz]: modes of the rim may lie above the model's */
  TbViewHead heads[TB_HEADS];
  uint32_t orders;   /* with a mode */
  double *turn;      /* [2 orders][angles]: cosine, then sine of each order */
  double *sums;      /* [2 orders][radii]: C_m and S_m */
  double *wires;     /* [wires][points] */
  double *contact;   /* [wires][points] */
  double *wire_ends; /* [wires][4] */
} TbViewTables;

#endif
