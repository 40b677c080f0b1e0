/* SPDX-License-Identifier: MIT */
/* What is heard of a step: the high band, which hears the contact forces and does not answer, and the
 * microphones. Audio-safe. */
#ifndef TB_MIC_OUTPUT_H
#define TB_MIC_OUTPUT_H

#include "step/state.h"

/* Moves the high band from view->now to view->next, and reads the microphones of the mask `heard` into
 * pressure[mic] as parts of full scale, 0 for the others. `unchanged`: nothing touched in this step and in the
 * last one. */
void tb_mic_output(TbView *view, uint32_t heard, bool unchanged, double *pressure);

#endif
