/* SPDX-License-Identifier: MIT */
/* Heads that stretch: large deflections raise the tension, and the pitch glides down as they decay.
 *
 * Berger's approximation, one scalar per head h [Berger1955, NSS]: the tension rises by
 * S/(2A) Int |grad w|^2 dA,
 *   U_h = S_h/(8 A) (q^T G_h q)^2,  q^T G_h q = Int |grad w_h|^2 dA,
 * S [N/m] the sheet's stretching stiffness, A its area. G_h counts as its diagonal: the exact one couples
 * modes of one order too, which changes glides by less than a tenth. Only modes below 12 times the lowest
 * frequency count, 24 times at studio and reference: higher ones hardly stretch a head. q counts from rest:
 * the sag under gravity is some 0.1 mm.
 *
 * Over two steps, with y_h = G_h q^n and theta_h = y_h.(q+ + q-)/2,
 *   force -(S_h/2A) theta_h y_h, stored energy S_h/(8A) (q+^T G_h q^n)^2, exactly conservative.
 * It is implicit in q+ through theta alone. With Y = [y_b y_r], P = diag(S_h/2A), g the modes' gains and x
 * the displacement without it,
 *   theta = S2 Y^T (x + q-)/2, S2 = (1 + Y^T g Y P/2)^-1, q+ = x - g Y P theta,
 * and the contacts see the compliance M - r^T W r, W = P S2/2, r = Y^T g Phi, Phi their signed shapes.
 * A contact's own slope limit uses M, which is the larger. G is prepared by
 * model/stretch_gain.h. Audio-safe. */
#ifndef TB_STRETCH_H
#define TB_STRETCH_H

#include "step/state.h"

/* After the modes' free motion, before the contacts: Y^T (x + q-), r and W. The force itself comes
 * with the contacts' (tb_stretch_respond): until then next.q is x. */
void tb_stretch_free(TbView *view);
/* What the stretch does to the free motion, and what the forces at rest do beyond M f_rest, which knows nothing
 * of it: adds it to view->change, and slots[TB_SLOTS] receives it for the strikers' b. */
void tb_stretch_yield(TbView *view, double *slots);
/* Before the solve: the last forces' response M f, which the solve starts from and moves along, with the
 * stretch of this sample instead of the last one's. */
void tb_stretch_renew(TbView *view);
/* After the contacts have moved the modes: adds the force. They changed Y^T q+ by -r f, so theta is known. */
void tb_stretch_respond(TbView *view);
/* When `product` has been computed anew, without any stretch. */
void tb_stretch_clear(TbView *view);
/* Energy stored between two instants [J]. */
double tb_stretch_energy(const TbView *view, const double *next, const double *now);

#endif
