/* SPDX-License-Identifier: MIT */
/* The last pass over the modes in a sample: what stretching heads add to view->next, what the modes lost in the step, and what
 * the first microphone hears of them. All of it needs no more than the finished displacements, so one pass reads them once.
 * Audio-safe. */
#ifndef TB_MODES_END_H
#define TB_MODES_END_H

#include "step/state.h"

/* Call after tb_stretch_respond(), which finds the stretch's force. Microphone `mic` is heard in view->end. */
void tb_modes_end(TbView *view, uint32_t mic);

#endif
