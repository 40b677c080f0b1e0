/* SPDX-License-Identifier: MIT */
/* Stretching heads: large deflections raise the tension, and the pitch glides down as they decay.
 *
 * Berger's approximation, one scalar per head h [Berger1955, NSS]: the tension rises by S/(2A) Int
 * |grad w|^2 dA,
 *   U_h = S_h/(8 A) (q^T G_h q)^2,  q^T G_h q = Int |grad w_h|^2 dA,
 * S [N/m] the sheet's stretching stiffness, A its area. G_h couples modes of one order;
 * model/stretch_mixing.h says which of its terms off the diagonal are kept. Modes up to 96 times
 * the lowest frequency count: a hard stroke leaves as much of q^T G q in every kilohertz that it
 * excites, so that few modes are several dB off on a bass drum. q counts from rest: the sag under
 * gravity is some 0.1 mm.
 *
 * Over two steps, with y_h = G_h q^n and theta_h = y_h.(q+ + q-)/2,
 *   force -(S_h/2A) theta_h y_h, stored energy S_h/(8A) (q+^T G_h q^n)^2, exactly conservative.
 * The force is implicit in q+ through theta alone. With Y = [y_b y_r], P = diag(S_h/2A), g the
 * modes' gains and x the displacement without this force,
 *   theta = S2 Y^T (x + q-)/2, S2 = (1 + Y^T g Y P/2)^-1, q+ = x - g Y P theta,
 * and the contacts see the compliance M - r^T W r, W = P S2/2, r = Y^T g Phi, Phi their signed
 * shapes. A contact's own slope limit uses M, which is the larger. model/stretch_gain.h prepares G.
 * Audio-safe. */
#ifndef TB_STRETCH_H
#define TB_STRETCH_H

#include "state/state.h"

/* Draft and live (TbStretch.hold): a head whose tension has not risen by a 2 000th for 20 ms, while
 * no stick is in play and no loud sound comes from outside, moves as a linear one until one of
 * these comes or, every 64th step, its tension is found to have risen. The pitch is then 0.4 cents
 * too low at most. The energy of the stretch, at most S/(8A) (q^T G q)^2 = (A/2S) dT^2, some 1e-7
 * J, goes and comes back by control. */

/* The modes' free motion, into view->next. */
void tb_stretch_move(TbView *view);
/* Computes Y^T (x + q-), r and W. Call after the modes' free motion and before the contacts.
 * tb_stretch_respond() adds the force itself; until then next.q is x. */
void tb_stretch_free(TbView *view);
/* Adds to view->change, for the wires, and to slots[TB_SLOTS], for the strikers' b, what stretch
 * changes in the free motion and in the response to the forces at rest; M f_rest has no stretch. */
void tb_stretch_yield(TbView *view, double *slots);
/* solve.warm.product, M f, holds the last step's stretch; puts this step's in its place. Call
 * before the solve, which starts from M f and moves along it. */
void tb_stretch_renew(TbView *view);
/* Finds the stretch force, which the last pass over the modes adds (step.c). Call after the
 * contacts have moved the modes. They changed Y^T q+ by -r f, so theta is known. */
void tb_stretch_respond(TbView *view);
/* Call after `product` was recomputed without any stretch. */
void tb_stretch_clear(TbView *view);
/* Energy stored between two instants [J]; nothing while heads move as linear ones. */
double tb_stretch_energy(const TbView *view, const TbPhase *next, const TbPhase *now);

#endif
