/* SPDX-License-Identifier: MIT */
/* The air between a hi-hat's plates, which cushions them as they close and sucks as they open.
 *
 * It has one pressure p over that outside. In a step k the plates take the volume
 *   W = Int (w_top(n+1) - w_top(n-1) - w_bottom(n+1) + w_bottom(n-1)) dA/2
 * from it, and the flow Q leaves between the edges,
 *   p(n+1/2) - p(n-1/2) = -(rho c^2/V) (W + k Q(P)),   P the mean of both,
 *   Q = C A sgn(P) (2 |P|/rho)^(1/2),
 * A the sum of the gaps between the edges, C = pi/(pi + 2) the contraction of a free jet from a
 * slit [Lamb1932, art. 75]. P presses the plates apart. It is found before the contacts are, from
 * the free motion and what contacts added to W in the last step; so it is the mean only nearly. The
 * air holds the energy e = p^2 V/(2 rho c^2), gives P W and loses k P Q to the jet. The energy is
 * kept, and the pressure follows it down: e(n+1/2) is the lesser of that of the pressure above and
 * e(n-1/2) - P W, the rest is lost. So the air creates none, whatever the contacts do.
 *
 * Limits: rigid plates of the radius R that close at the steady speed u, h apart, feel the pressure
 * rho (u R/(2 C h))^2/2; without a gap, the spring rho c^2 (pi R^2)^2/V.
 *
 * The volume is that of closed plates, the pressure is uniform, which holds below 3.83 c/(2 pi R) =
 * 1.2 kHz for 14 inch, the air in the gap has no mass, the jet makes no sound of its own, and the
 * air's load on the inner faces is that of open plates. Audio-safe. */
#ifndef TB_HIHAT_AIR_H
#define TB_HIHAT_AIR_H

#include "state/state.h"

/* Finds P, and adds its force to the free motion in view->next. */
void tb_hihat_air_push(TbView *view);
/* y g F of that force, from y g = pull[padded]. */
double tb_hihat_air_product(const TbView *view, const double *pull);
/* P W of the step to view->next [J]. */
double tb_hihat_air_work(const TbView *view);
/* Ends the step to view->next. Returns the energy that the jet took [J]. */
double tb_hihat_air_end(TbView *view);
/* The air rests. Returns the energy that it held [J]. */
double tb_hihat_air_rest(TbView *view);
/* `to`, whose air rests, goes on with the pressure of `from`. */
void tb_hihat_air_carry(const TbView *from, TbView *to);

#endif
