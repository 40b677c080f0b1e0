/* SPDX-License-Identifier: MIT */
/* The energy that the lowest modes of a closed drum have radiated together
 * (model/radiated_power.h). Audio-safe. */
#ifndef TB_RADIATED_ENERGY_H
#define TB_RADIATED_ENERGY_H

#include "state/state.h"

/* Energy [J] that is radiated in the next TB_FAR_STEPS steps if the motion goes on as in
 * view->next, now and last, less what these modes' losses book as radiated. 0 at the steps between.
 */
double tb_radiated_beyond(const TbView *view);

#endif
