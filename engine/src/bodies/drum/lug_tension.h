/* SPDX-License-Identifier: MIT */
/* The tension of a head that its lugs stretch unevenly.
 *
 * Lug j of n, at (j - 1/2) 2 pi/n, pulls with T (1 + d_j). The hoop carries the pull from lug to
 * lug: d around the rim is the trigonometric polynomial of least degree through the d_j,
 *   d(t) = Sum_p c_p cos(p t) + s_p sin(p t), p = 0 .. n/2.
 * Inside, the sheet is in plane elastic equilibrium. The tensions are N_rr = chi_r/r + chi_tt/r^2,
 * N_tt = chi_rr, N_rt = -(chi_t/r)_r of Airy's function chi, lap lap chi = 0. With N_rr = d and no
 * shear at the rim, and r in units of the head's radius, harmonic p from 2 on gives
 *   N_rr = (p r^(p-2) - (p-2) r^p)/2, N_tt = ((p+2) r^p - p r^(p-2))/2 times cos p t,
 *   N_rt = p (r^p - r^(p-2))/2 times sin p t
 * (p = 2: the centre is stretched one way and slackened the other). p = 0 gives N_rr = N_tt = 1. A
 * pull to one side, p = 1, needs the edge's friction: N_rr = r, N_tt = 3 r, N_rt = r. */
#ifndef TB_LUG_TENSION_H
#define TB_LUG_TENSION_H

#include "tabor/tabor.h"

#define TB_LUG_HARMONICS (TABOR_MAX_LUGS / 2 + 1)

/* Deviation from T, in units of T, in harmonics of the angle. */
typedef struct TbLugTension {
  uint32_t harmonics; /* p below this */
  double c[TB_LUG_HARMONICS], s[TB_LUG_HARMONICS];
} TbLugTension;

/* N - T [T] at a point. */
typedef struct TbTension {
  double rr, tt, rt;
} TbTension;

/* Relative deviations of all lugs, deviation[lug_count]: a lug's own value if set, otherwise drawn
 * at random. */
void tb_lug_deviations(const TaborHeadDef *head, double *deviation);

/* Prepares the field of a head in coordinates turned by `turn` [rad]. Returns false if the tension
 * is the definition's everywhere. */
bool tb_lug_tension_prepare(TbLugTension *field, const TaborHeadDef *head, double turn);

/* The tension at radius r, 0 < r <= 1, and an angle [rad]. */
TbTension tb_lug_tension_at(const TbLugTension *field, double r, double angle);

#endif
