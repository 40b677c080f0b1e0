/* SPDX-License-Identifier: MIT */
/* The last resort against energy from a capped solve, right for any contact forces whatever.
 *
 * If the new energy exceeds the old, every x(n+1) becomes x(n-1) + t (x(n+1) - x(n-1)) with the largest
 * t in [0, 1] for which it does not. E(t) is convex, and E(0) is the old energy exactly, since the
 * energy between two instants does not depend on their order. What is lost shows in the residual.
 * Audio-safe. */
#ifndef TB_GUARD_H
#define TB_GUARD_H

#include "state.h"

/* Call after view->next is filled and before losses are booked. */
void tb_guard(TbView *view);

#endif
