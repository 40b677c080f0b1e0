/* SPDX-License-Identifier: MIT */
/* How contact forces move the drum depends on which slots are in play and on what hands do to them. Audio-safe. */
#ifndef TB_COUPLING_H
#define TB_COUPLING_H

#include "step/state.h"

/* Call after a slot was filled, freed or held otherwise, or wires have changed: computes anew what the rest load and
 * the forces of the last step do. */
void tb_coupling_renew(TbView *view);

#endif
