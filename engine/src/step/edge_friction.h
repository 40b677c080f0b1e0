/* SPDX-License-Identifier: MIT */
/* Friction of a hi-hat's edges where they are pressed together.
 *
 * Edges that slide on each other take energy from the bending of both plates. How they slide is not
 * computed. Recorded closed hi-hats decay in all octaves alike, in 0.2 to 0.5 s, and open ones in
 * about a second; so all motion of the plates decays at the rate s = friction F more [1/s], F the
 * sum of the contact forces [N]: every EVERY steps of k the motion of the last two is shortened,
 *   x(n+1) := x(n-1) + (1 - EVERY k s) (x(n+1) - x(n-1)),
 * for modes and edges. That never creates energy, as in step/energy_guard.h: new energy and losses
 * are convex in the factor, and at 0 they are the old energy. The difference is booked as lost in
 * contacts. While a striker or a hand touches, no edge slides. Audio-safe. */
#ifndef TB_EDGE_FRICTION_H
#define TB_EDGE_FRICTION_H

#include "state/state.h"

/* Shortens the step to view->next, if it is due; true if it did. Call before losses are booked. */
bool tb_edge_friction(TbView *view);

#endif
