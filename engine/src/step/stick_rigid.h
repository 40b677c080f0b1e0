/* SPDX-License-Identifier: MIT */
/* The stick as a body: a uniform rod of length L = 0.4 m and mass m = 4 M that touches head and hoop.
 *
 * It has height and tilt, m z_tt = Sum f_j, I p_tt = Sum xi_j f_j, I = m L^2/12, xi_j how far from its middle the
 * contact j lies. With two contacts the heights z_j = z + xi_j p of these say as much, and move by
 *   z_j,tt = Sum_i C_ij f_i,  C_ij = 1/m + xi_i xi_j/I,
 * so each keeps a row of its own in the contact solve, of mass 1/C_jj, and the pair shares the off-diagonal
 * k^2 C_12 of M (solve.h). Kinetic energy is v^T C^-1 v/2. It also bends (stick_bending.h): the height of end j is
 * z_j + Sum_n psi_n(x_j) q_n, and C_ij becomes C_ij + Sum_n g_n psi_n(x_i) psi_n(x_j)/(m k^2) in M.
 *
 * Limit: C at the tip is 4/m = 1/M, so a stiff rod that touches the head alone is the plain striker of mass M.
 *
 * - Rimshot: tip on the head at the stroke's place, shaft over the hoop at the stroke's angle, d = R - r away
 *   on the level; along the stick it is sqrt(d^2 + height^2). The stick comes down flat, all of it at the
 *   stroke's speed, m v^2/2 = 2 M v^2, and is held at such an angle that the shaft is due on the hoop 0.8 ms
 *   after the tip on the head: d (tan(angle) - height/d) is the gap, 2 mm at 2.5 m/s.
 * - Cross-stick: the stick lies across, tip at the stroke's place, shaft over the hoop opposite, d = R + r away.
 *   It turns about its tip, which rests, and meets the hoop with the stroke's speed: (m L^2/3) (v/d)^2/2. The
 *   fingers that hold the tip, 0.2 kg more there, keep it from being thrown, and the palm lies on the head over
 *   it, a damping hand, for 0.3 s.
 * - Rim: the stick strikes the hoop alone, with mass M.
 * On drums wider than a stick is long the tip comes as near to the stroke's place as 0.2 m from the hoop let it, across
 * 0.3 m; it is never nearer to the hoop than 0.03 m. */
#ifndef TB_STICK_RIGID_H
#define TB_STICK_RIGID_H

#include "step/state.h"

/* What one contact of a rod brings. */
typedef struct TbRigidStickEnd {
  double radius, angle; /* of the head, or of the hoop [m], [deg] */
  double mass;          /* 1/C_jj [kg] */
  double velocity;      /* downwards [m/s] */
  double gap;           /* above what it is to strike [m] */
  double along;         /* from the tip [m] */
} TbRigidStickEnd;

typedef struct TbRigidStick {
  TbRigidStickEnd tip, shaft;
  double cross; /* C_12 [1/kg] */
} TbRigidStick;

/* Of a stick with mass `mass` at its tip, `radius` and `angle` as asked for. */
TbRigidStick tb_rigid_stick_rimshot(const TaborDrumDef *def, double mass, double velocity,
                                    double radius, double angle);
TbRigidStick tb_rigid_stick_across(const TaborDrumDef *def, double mass, double velocity,
                                   double radius, double angle);

/* psi m^(-1/2) at `along` of the stick that the slot describes. */
void tb_rigid_stick_bend(const TbView *view, const TbSlot *slot, double along, double *bend);
/* All sticks' bending one step on, without forces. */
void tb_rigid_stick_step(TbView *view);
/* What bending adds to the height of a slot's end [m]. */
double tb_rigid_stick_bow(const TbView *view, uint32_t slot, const TbPhase *phase);
/* ... and what a force on it does to the bending at the next instant. */
void tb_rigid_stick_press(TbView *view, uint32_t slot, double force);
/* Displacement by bending of one end one step after a unit force on the other, or on itself [m/N]. */
double tb_rigid_stick_flexibility(const TbView *view, uint32_t slot, uint32_t other);
/* Stored in the bending of a slot's stick between two instants, counted with its tip, and lost in a step [J]. */
double tb_rigid_stick_bending(const TbView *view, uint32_t slot, const TbPhase *next,
                              const TbPhase *now);
double tb_rigid_stick_loss(const TbView *view, uint32_t slot);
/* A slot's part of twice the kinetic energy of its body between two instants [J]. */
double tb_rigid_stick_motion(const TbView *view, uint32_t slot, const double *next,
                             const double *now);
/* What the force at the other end of its body adds to a slot's height in one step [m]. */
double tb_rigid_stick_pull(const TbView *view, uint32_t slot);

#endif
