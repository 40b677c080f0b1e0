/* SPDX-License-Identifier: MIT */
/* The last resort against energy from a capped solve, right for any contact forces whatever.
 *
 * If the new energy and the losses of modes and wires exceed the old energy and the work of hands, every
 * x(n+1) becomes x(n-1) + t (x(n+1) - x(n-1)) with a t in [0, 1], near the largest, for which they do not.
 * Their sum is convex in t, and at t = 0 it is the old energy exactly, since the energy between two
 * instants does not depend on their order and nothing is lost. What the shortened step loses shows in the
 * residual. Audio-safe. */
#ifndef TB_ENERGY_GUARD_H
#define TB_ENERGY_GUARD_H

#include "step/state.h"

/* Call after view->next is filled and before losses are booked. True if the step was shortened. */
bool tb_energy_guard(TbView *view);

#endif
