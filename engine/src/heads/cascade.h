/* SPDX-License-Identifier: MIT */
/* Energy that goes up a plate's spectrum beyond the modes that large deflections couple one by one.
 *
 * Large slow waves scatter short ones (induced diffusion), whose energy so spreads to shorter ones
 * yet. In third octaves, with e the energy per mode, it passes the edge above band b at
 *   P_b = kappa_b E^1.5 e_b^-0.6 (e_b - e_{b+1})   [W],  0 if e_b <= e_{b+1},
 * E the energy of the large waves; kappa_b falls as 1/(1 + (f/f_r)^4). The first band is the
 * highest of the coupled modes. Law and numbers are fitted to runs in which all modes were coupled
 * (model/cascade.c); where these end, nothing but recordings tells.
 *
 * A band gives by a common factor of its modes' motion. The next one gets it by a kick of its
 * modes' velocities along random signs u_i, of a size s with
 *   s Sum u_i (v_i - K'_i k q_i/2) + n s^2/2 = the energy,
 * which is exact for the recursion of model/modes.h. The larger of both roots turns velocities
 * back; it is taken now and then, as often as energy comes: lines become noise.
 *
 * Limits: nothing moves without large waves, and energy never goes down the spectrum. Audio-safe.
 */
#ifndef TB_CASCADE_STEP_H
#define TB_CASCADE_STEP_H

#include "state/state.h"

/* Whether there is anything to pass on. */
bool tb_cascade_acts(const TbView *view);
/* Passes on the energy of `steps` steps. Call between two steps; tb_mic_hear_anew() afterwards. */
void tb_cascade_pass(TbView *view, uint32_t steps);

#endif
