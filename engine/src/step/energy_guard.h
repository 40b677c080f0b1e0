/* SPDX-License-Identifier: MIT */
/* The last resort against energy created by a capped solve. It holds for any contact forces.
 *
 * If the new energy and the losses of modes and wires exceed the old energy and the work of hands,
 * of fingers that pluck, of a pedal and of sound from outside, every x(n+1) becomes x(n-1) + t
 * (x(n+1) - x(n-1)). t in [0, 1] is near the largest value for which new energy and losses do not
 * exceed the old energy and the work. The sum of new energy and losses is convex in t. At t = 0 it
 * is exactly the old energy, since the energy between two instants does not depend on their order
 * and nothing is lost. The energy that the shortened step loses appears in the residual.
 * Audio-safe. */
#ifndef TB_ENERGY_GUARD_H
#define TB_ENERGY_GUARD_H

#include "state/state.h"

/* next = last + t (next - last), of modes, wires and edges. */
void tb_shorten_modes(TbView *view, double t);
/* Energy stored between view->next and view->now, with what modes and wires lose in the step, less
 * the work that comes in by others than strikers [J]. */
double tb_energy_and_losses(const TbView *view);

/* Returns true if the step was shortened. Call after view->next is filled and before losses are
 * booked. */
bool tb_energy_guard(TbView *view);

#endif
