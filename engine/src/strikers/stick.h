/* SPDX-License-Identifier: MIT */
/* The stick as a body: a tapered beam (model/stick_bending.h) that touches the head, the hoop,
 * or both.
 *
 * Its coordinates are height and tilt. The kinetic energy is that of the moments of mass S0, S1, S2
 * about the tip, so contacts at distances x_j from the tip have heights z_j that move by
 *   z_j,tt = Sum_i C_ij f_i,  C_ij = (S2 - S1 (x_i + x_j) + S0 x_i x_j)/(S0 S2 - S1^2).
 * So each contact keeps its own row in the contact solve, of mass 1/C_jj, and a pair shares the
 * off-diagonal k^2 C_12 of M (solve.h). Kinetic energy is v^T C^-1 v/2. The stick also bends: the
 * height of contact j is z_j + Sum_n phi_n(x_j) q_n, and k^2 C_ij becomes k^2 C_ij + Sum_n g_n
 * phi_n(x_i) phi_n(x_j) in M. Energy of bending is stored energy of strikers; the hand's damping of
 * bending is damper_loss.
 *
 * Limit: 1/C at the tip is the striker's mass M, so a stiff stick that touches the head alone is
 * the plain striker of mass M.
 *
 * - Plain stroke, buzz, stroke on the rim: one contact at the tip; z moves as M z_tt = f.
 * - Rimshot: the tip meets the head at the stroke's place, and the shaft meets the hoop at the
 *   stroke's angle, a horizontal distance d = R - r away; along the stick the distance is sqrt(d^2
 *   + height^2). The stick comes down without rotation at the stroke's speed, S0 v^2/2 = 2.5 M v^2.
 *   Its angle makes the shaft reach the hoop 0.8 ms after the tip reaches the head: d (tan(angle) -
 *   height/d) is the gap, 2 mm at 2.5 m/s.
 * - Cross-stick: the stick lies across the drum, its tip at the stroke's place, its shaft over the
 *   hoop opposite, d = R + r away. It turns about its tip and meets the hoop with the stroke's
 *   speed: S2 (v/d)^2/2, hand included. The hand presses the shaft down: h = -(F0 + c z_s,t), the
 *   damper centred, is one more force at the place s of the shaft. So the shaft bounces some times
 *   on the hoop and comes to rest there. The palm lies on the head over the tip, as a damping hand.
 *   F0 falls evenly to nothing in 0.3 s, the palm's resistance in the last 0.1 s of it; then both
 *   are gone. F0 and c do not depend on the grip, as the hand's mass does not. The next cross-stick
 *   takes the stick of the last along.
 *
 * On drums wider than the stick's length, the tip is as near to the stroke's place as it can be
 * within 0.2 m of the hoop (cross-stick: 0.3 m). The tip is never nearer than 0.03 m to the
 * hoop. */
#ifndef TB_STICK_H
#define TB_STICK_H

#include "state/state.h"

/* One contact of a rod. */
typedef struct TbStickContact {
  double radius, angle; /* on the head, or on the hoop [m], [deg] */
  double mass;          /* 1/C_jj [kg] */
  double velocity;      /* downwards [m/s] */
  double gap;           /* above the surface that it will strike [m] */
  double along;         /* distance from the tip [m] */
} TbStickContact;

typedef struct TbStickContacts {
  TbStickContact tip, shaft;
  double cross; /* C_12 [1/kg] */
} TbStickContacts;

/* A stick at the requested `radius` and `angle`. */
TbStickContacts tb_stick_rimshot(const TaborDrumDef *def, const TbStick *stick, double velocity,
                                 double radius, double angle);
TbStickContacts tb_stick_across(const TaborDrumDef *def, const TbStick *stick, double velocity,
                                double radius, double angle);

/* In a stroke of the tip alone: heads of mallets, fingers and brushes do not bend. */
bool tb_stick_bends(const TbView *view, uint32_t striker);
/* The body of a slot whose stick bends, in its grip. */
const TbStickBody *tb_stick_body(const TbView *view, uint32_t slot);
/* Computes the slot's phi from its place along the stick. */
void tb_stick_place(TbView *view, uint32_t slot);
/* Bow, press and flexibility below need a slot whose stick bends. */

/* Moves all sticks' bending by one step, without forces. */
void tb_stick_step(TbView *view);
/* Bending part of the height of a slot's end [m]. */
double tb_stick_bow(const TbView *view, uint32_t slot, const TbPhase *phase);
/* Adds the effect of a force on a slot's end to the bending at the next instant. */
void tb_stick_press(TbView *view, uint32_t slot, double force);
/* Displacement of one end by bending, one step after a unit force on `other`, which may be the same
 * end [m/N]. */
double tb_stick_flexibility(const TbView *view, uint32_t slot, uint32_t other);
/* Energy stored in the bending of a slot's stick between two instants [J]; of a pair the tip's slot
 * has it all. */
double tb_stick_bending(const TbView *view, uint32_t slot, const TbPhase *next, const TbPhase *now);
/* Energy that this bending loses in a step [J]. */
double tb_stick_loss(const TbView *view, uint32_t slot);
/* Displacement of a slot's end in one step by a unit force at the stick's end `other`, which may be
 * the same, without bending [m/N]; and this end's next height without contact forces [m]. Both need
 * a slot that is an end. */
double tb_stick_compliance(const TbView *view, uint32_t slot, uint32_t other);
double tb_stick_free_height(const TbView *view, uint32_t slot);
/* A slot's part of twice the kinetic energy of its body between two instants [J]. */
double tb_stick_motion(const TbView *view, uint32_t slot, const double *next, const double *now);
/* Change of a slot's height in one step by the force at the other end of its body [m]. */
double tb_stick_pull(const TbView *view, uint32_t slot);

#endif
