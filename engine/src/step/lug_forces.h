/* SPDX-License-Identifier: MIT */
/* What uneven lugs do to the modes.
 *
 * The tension's deviation N - T (lug_tension.h) adds dK_ab = Int grad a . (N - T) grad b dA to the modes'
 * diagonal stiffness, which turns each pair of cosine and sine to axes of its own, splits it, and couples
 * neighbouring orders. The modes stay the even head's, and with them all symmetries of the tables on the
 * wires; their lower ones feel -dK q as a force at each instant. Energy gains q+^T dK q/2, exactly
 * conservative since dK is symmetric to the bit. dK is scaled by sin(w k)/(w k), by which the recursion
 * answers too much, so that split frequencies are right as well.
 *
 * Limits: a uniform deviation d moves w^2 of a membrane in vacuo by a part d. Modes above the coupled ones
 * stay pairs. The rest state is the even head's. dK is prepared by
 * model/lug_modes.h. Audio-safe. */
#ifndef TB_LUG_FORCES_H
#define TB_LUG_FORCES_H

#include "step/state.h"

/* After the modes' free motion: takes what dK pulls from view->next. */
void tb_lug_forces_pull(TbView *view);
/* Energy stored between two instants [J]. */
double tb_lug_forces_energy(const TbView *view, const double *next, const double *now);

#endif
