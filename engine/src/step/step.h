/* SPDX-License-Identifier: MIT */
/* One sample of one drum. Audio-safe. */
#ifndef TB_STEP_H
#define TB_STEP_H

#include "state/state.h"

/* Advances the drum by one sample. pressure[mic] [Pa times gain over full_scale] receives the
 * signals of the microphones whose bit is set in `heard`, and 0 for the others. */
void tb_step(TbView *view, uint32_t heard, double *pressure);

#endif
