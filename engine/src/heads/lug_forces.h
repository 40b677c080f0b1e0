/* SPDX-License-Identifier: MIT */
/* Forces of unevenly tensioned lugs on the modes.
 *
 * The tension's deviation N - T (lug_tension.h) adds dK_ab = Int grad a . (N - T) grad b dA to the
 * modes' diagonal stiffness. This turns each pair of cosine and sine to axes of its own, splits the
 * pair, and couples neighbouring orders. The modes remain those of the even head, so the tables on
 * the wires keep all their symmetries; the lower modes feel -dK q as a force at each instant. The
 * energy gains q+^T dK q/2, exactly conservative since dK is symmetric to the bit. The recursion
 * answers a force too strongly by the factor w k/sin(w k); dK is scaled by sin(w k)/(w k), so that
 * split frequencies are right as well.
 *
 * Limits: a uniform deviation by a fraction d of the tension moves w^2 of a membrane in vacuo by
 * the fraction d. Modes above the coupled ones stay pairs. The rest state is that of the even head.
 * model/lug_modes.h prepares dK. Audio-safe. */
#ifndef TB_LUG_FORCES_H
#define TB_LUG_FORCES_H

#include "state/state.h"

/* Adds the force -dK q to view->next. Call after the modes' free motion. */
void tb_lug_forces_pull(TbView *view);
/* Energy stored between two instants [J]. */
double tb_lug_forces_energy(const TbView *view, const double *next, const double *now);

#endif
