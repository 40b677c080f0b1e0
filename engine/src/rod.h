/* SPDX-License-Identifier: MIT */
/* The stick as a body: a rigid, uniform rod of length L = 0.4 m and mass m = 4 M that touches head and hoop.
 *
 * It has height and tilt, m z_tt = Sum f_j, I p_tt = Sum xi_j f_j, I = m L^2/12, xi_j how far from its middle the
 * contact j lies. With two contacts the heights z_j = z + xi_j p of these say as much, and move by
 *   z_j,tt = Sum_i C_ij f_i,  C_ij = 1/m + xi_i xi_j/I,
 * so each keeps a row of its own in the contact solve, of mass 1/C_jj, and the pair shares the off-diagonal
 * k^2 C_12 of M (solve.h). Kinetic energy is v^T C^-1 v/2.
 *
 * Limit: C at the tip is 4/m = 1/M, so a rod that touches the head alone is the plain striker of mass M.
 *
 * - Rimshot: tip on the head at the stroke's place, shaft over the hoop at the stroke's angle, d = R - r away
 *   on the level; along the stick it is sqrt(d^2 + height^2). The stick comes down flat, all of it at the
 *   stroke's speed, m v^2/2 = 2 M v^2, and is held at such an angle that the shaft is due on the hoop 0.8 ms
 *   after the tip on the head: d (tan(angle) - height/d) is the gap, 2 mm at 2.5 m/s.
 * - Cross-stick: the stick lies across, tip at the stroke's place, shaft over the hoop opposite, d = R + r away.
 *   It turns about its tip, which rests, and meets the hoop with the stroke's speed: (m L^2/3) (v/d)^2/2. The palm
 *   lies on the head over the tip, a damping hand, for half a second.
 * - Rim: the stick strikes the hoop alone, with mass M.
 * On drums wider than a stick is long the tip comes as near to the stroke's place as 0.2 m from the hoop let it, across
 * 0.3 m; it is never nearer to the hoop than 0.03 m. No hand holds the stick in these milliseconds. */
#ifndef TB_ROD_H
#define TB_ROD_H

#include "state.h"

/* What one contact of a rod brings. */
typedef struct TbRodEnd {
  double radius, angle; /* of the head, or of the hoop [m], [deg] */
  double mass;          /* 1/C_jj [kg] */
  double velocity;      /* downwards [m/s] */
  double gap;           /* above what it is to strike [m] */
} TbRodEnd;

typedef struct TbRod {
  TbRodEnd tip, shaft;
  double cross; /* C_12 [1/kg] */
} TbRod;

/* Of a stick with mass `mass` at its tip, `radius` and `angle` as asked for. */
TbRod tb_rod_rimshot(const TaborDrumDef *def, double mass, double velocity, double radius,
                     double angle);
TbRod tb_rod_across(const TaborDrumDef *def, double mass, double velocity, double radius,
                    double angle);

/* A slot's part of twice the kinetic energy of its body between two instants [J]. */
double tb_rod_motion(const TbView *view, uint32_t slot, const double *next, const double *now);
/* What the force at the other end of its body adds to a slot's height in one step [m]. */
double tb_rod_pull(const TbView *view, uint32_t slot);

#endif
