/* SPDX-License-Identifier: MIT */
/* The stick as a body: a uniform rod of length L = 0.4 m and mass m = 4 M that touches head and
 * hoop.
 *
 * Its coordinates are height and tilt, m z_tt = Sum f_j, I p_tt = Sum xi_j f_j, I = m L^2/12, with
 * xi_j the distance of contact j from the middle. With two contacts, the heights z_j = z + xi_j p
 * are equivalent coordinates and move by
 *   z_j,tt = Sum_i C_ij f_i,  C_ij = 1/m + xi_i xi_j/I.
 * So each contact keeps its own row in the contact solve, of mass 1/C_jj, and the pair shares the
 * off-diagonal k^2 C_12 of M (solve.h). Kinetic energy is v^T C^-1 v/2. The rod also bends
 * (stick_bending.h): the height of end j is z_j + Sum_n psi_n(x_j) q_n, and C_ij becomes C_ij +
 * Sum_n g_n psi_n(x_i) psi_n(x_j)/(m k^2) in M.
 *
 * Limit: C at the tip is 4/m = 1/M, so a stiff rod that touches the head alone is the plain striker
 * of mass M.
 *
 * - Rimshot: the tip meets the head at the stroke's place, and the shaft meets the hoop at the
 *   stroke's angle, a horizontal distance d = R - r away; along the stick the distance is sqrt(d^2
 *   + height^2). The stick comes down without rotation at the stroke's speed, m v^2/2 = 2 M v^2.
 *   Its angle makes the shaft reach the hoop 0.8 ms after the tip reaches the head: d (tan(angle) -
 *   height/d) is the gap, 2 mm at 2.5 m/s.
 * - Cross-stick: the stick lies across the drum, its tip at the stroke's place, its shaft over the
 *   hoop opposite, d = R + r away. It turns about its resting tip and meets the hoop with the
 *   stroke's speed: (m L^2/3) (v/d)^2/2. The fingers that hold the tip add 0.2 kg there, which
 *   keeps the tip from being thrown. The palm lies on the head over the tip for 0.3 s, as a damping
 *   hand.
 * - Rim: the stick strikes the hoop alone, with mass M.
 *
 * On drums wider than the stick's length, the tip is as near to the stroke's place as it can be
 * within 0.2 m of the hoop (cross-stick: 0.3 m). The tip is never nearer than 0.03 m to the
 * hoop. */
#ifndef TB_STICK_RIGID_H
#define TB_STICK_RIGID_H

#include "step/state.h"

/* One contact of a rod. */
typedef struct TbRigidStickEnd {
  double radius, angle; /* on the head, or on the hoop [m], [deg] */
  double mass;          /* 1/C_jj [kg] */
  double velocity;      /* downwards [m/s] */
  double gap;           /* above the surface that it will strike [m] */
  double along;         /* distance from the tip [m] */
} TbRigidStickEnd;

typedef struct TbRigidStick {
  TbRigidStickEnd tip, shaft;
  double cross; /* C_12 [1/kg] */
} TbRigidStick;

/* A stick with mass `mass` at its tip, at the requested `radius` and `angle`. */
TbRigidStick tb_rigid_stick_rimshot(const TaborDrumDef *def, double mass, double velocity,
                                    double radius, double angle);
TbRigidStick tb_rigid_stick_across(const TaborDrumDef *def, double mass, double velocity,
                                   double radius, double angle);

/* Computes psi m^(-1/2) at the distance `along` from the tip, for the stick that the slot
 * describes. */
void tb_rigid_stick_bend(const TbView *view, const TbSlot *slot, double along, double *bend);
/* Moves all sticks' bending by one step, without forces. */
void tb_rigid_stick_step(TbView *view);
/* Bending part of the height of a slot's end [m]. */
double tb_rigid_stick_bow(const TbView *view, uint32_t slot, const TbPhase *phase);
/* Adds the effect of a force on a slot's end to the bending at the next instant. */
void tb_rigid_stick_press(TbView *view, uint32_t slot, double force);
/* Displacement of one end by bending, one step after a unit force on `other`, which may be the same
 * end [m/N]. */
double tb_rigid_stick_flexibility(const TbView *view, uint32_t slot, uint32_t other);
/* Energy of a slot's stick: stored in bending between two instants, counted with its tip; and lost
 * in a step [J]. */
double tb_rigid_stick_bending(const TbView *view, uint32_t slot, const TbPhase *next,
                              const TbPhase *now);
double tb_rigid_stick_loss(const TbView *view, uint32_t slot);
/* A slot's part of twice the kinetic energy of its body between two instants [J]. */
double tb_rigid_stick_motion(const TbView *view, uint32_t slot, const double *next,
                             const double *now);
/* Change of a slot's height in one step by the force at the other end of its body [m]. */
double tb_rigid_stick_pull(const TbView *view, uint32_t slot);

#endif
