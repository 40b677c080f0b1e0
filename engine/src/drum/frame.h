/* SPDX-License-Identifier: MIT */
/* One frame of the output of a drum that may be asleep. Audio-safe. */
#ifndef TB_FRAME_H
#define TB_FRAME_H

#include "step/state.h"

/* Advances the state by one frame, asleep or not; pressure[] as for tb_step(). */
void tb_frame(TbView *view, uint32_t heard, double *pressure);

#endif
