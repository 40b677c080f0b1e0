/* SPDX-License-Identifier: MIT */
/* What the lowest modes of a closed drum have radiated together (model/radiated_power.h). Audio-safe. */
#ifndef TB_RADIATED_ENERGY_H
#define TB_RADIATED_ENERGY_H

#include "state/state.h"

/* Energy [J] that goes on in the TB_FAR_STEPS steps from this one on, of which view->next, now and last are the motion, less
 * what these modes lose to the air; 0 at the other steps. */
double tb_radiated_beyond(const TbView *view);

#endif
