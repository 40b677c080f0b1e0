/* SPDX-License-Identifier: MIT */
/* The output of a step: the high band, which is driven by the contact forces but does not act back
 * on the contacts, and the microphones. Audio-safe. */
#ifndef TB_MIC_OUTPUT_H
#define TB_MIC_OUTPUT_H

#include "state/state.h"

/* The first microphone of a set of bits; 0 of none. */
uint32_t tb_first_heard(uint32_t heard);

/* Moves the high band from view->now to view->next. Writes the signals of the microphones in the
 * mask `heard` to pressure[mic] as fractions of full scale, and 0 for the others. `unchanged`:
 * nothing touched in this step or in the last one. */
void tb_mic_output(TbView *view, uint32_t heard, bool unchanged, double *pressure);

/* Call between two steps after modes have come to rest: what was heard of them goes without a
 * click. */
void tb_mic_hear_anew(TbView *view);

#endif
