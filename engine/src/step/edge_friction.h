/* SPDX-License-Identifier: MIT */
/* Friction at the edges of plates: of a hi-hat's, where they are pressed together, and of a hand
 * that grips the edge of a cymbal.
 *
 * Edges that slide on each other take energy from the bending of both plates. How they slide is not
 * computed. Recorded closed hi-hats decay in all octaves alike, in 0.2 to 0.5 s, and open ones in
 * about a second; so all motion of the plates decays at the rate s = friction F more [1/s], F the
 * sum of the contact forces [N].
 *
 * A hand of resistance R that grips the edge takes R (phi_i at the edge)^2/2 from mode i. Fingers
 * on a hand's width meet both modes of each pair, and M phi^2 of a cymbal of mass M is 4 at 250 Hz
 * and 1 at 8 kHz; so all motion decays at s = R/M more, as recorded chokes do, in 0.2 to 0.5 s.
 *
 * Every EVERY steps of k the motion of the last two is shortened,
 *   x(n+1) := x(n-1) + (1 - EVERY k s) (x(n+1) - x(n-1)),
 * for modes and edges. That never creates energy, as in step/energy_guard.h: new energy and losses
 * are convex in the factor, and at 0 they are the old energy. The difference is booked as lost in
 * contacts, and in dampers where a hand takes it. While a striker or another hand touches, neither
 * acts. Audio-safe. */
#ifndef TB_EDGE_FRICTION_H
#define TB_EDGE_FRICTION_H

#include "state/state.h"

/* Shortens the step to view->next, if it is due; true if it did. Call before losses are booked. */
bool tb_edge_friction(TbView *view);

#endif
