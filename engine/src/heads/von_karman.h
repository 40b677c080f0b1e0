/* SPDX-License-Identifier: MIT */
/* Large deflections of a plate, by an auxiliary variable with a shift [DucceschiBilbaoWebb2023].
 *
 * With V(q) the coupling terms of bodies/membrane.h, psi^2 stands for 2 V + C, and
 *   g = grad V/sqrt(2 V + C) at q^n,   force -g s,   s = (psi+ + psi-)/2,
 *   psi+ - psi- = g.(q+ - q-)/2,   so that
 *   s = (4 psi- + g.(x - q-))/(4 + g^T b g),
 * x the displacement without this force and b the modes' gains: in the terms of stretch.h Y = g,
 * P = 1/2 and Y^T (x + q-) larger by 4 psi- - 2 g.q-. The plate stores (psi^2 - C)/2 more, exactly
 * conservative for every g, be it in single precision, late or cut off. V is negative
 * where the plate grows softer, as low as minus the modes' energy: C is twice that energy and that
 * of the sticks, and at least -4 V, so that 2 V + C is C/2 or more. A change of C leaves psi^2 - C
 * as it is.
 *
 * It acts in every n-th step, with n g. Rounding and steps let psi^2 - C part from 2 V, by 0.5 % of
 * a stroke's energy: every 256 steps psi is set right, and the modes get the difference by a common
 * factor.
 *
 * Quiet modes move as linear ones: below model/plate_coupling.h's energy, while no stick is in play
 * and no loud sound comes from outside. The coupling then fades out over 20 ms, and in again.
 *
 * Limits: without coupling 2 V = 0 for ever; n = 1 and short steps give the equations of
 * bodies/membrane.h. Audio-safe. */
#ifndef TB_VON_KARMAN_STEP_H
#define TB_VON_KARMAN_STEP_H

#include "state/state.h"

/* The energy by which (psi^2 - C)/2 exceeds V, at most a part of the modes' [J]; 0 where psi stays
 * as it is. Call between two steps. */
double tb_von_karman_excess(const TbView *view);
/* Gives it to the modes. Call tb_mic_hear_anew() afterwards, and change penetrations likewise. */
void tb_von_karman_return(TbView *view, double excess);

#endif
