/* SPDX-License-Identifier: MIT */
/* Every now and then a plate's large deflections get their auxiliary variable set right
 * (heads/von_karman.h), and pass energy to modes that they do not reach (heads/cascade.h).
 * Audio-safe. */
#ifndef TB_PLATE_RELAX_H
#define TB_PLATE_RELAX_H

#include "state/state.h"

/* Call every `steps` steps, between two. Nothing changes while something strikes the plate: the
 * energy of the contact would change with the modes. */
void tb_plate_relax(TbView *view, uint32_t steps);

#endif
