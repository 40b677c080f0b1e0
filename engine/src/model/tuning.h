/* SPDX-License-Identifier: MIT */
/* Tensions for the pitches of a definition (acoustics/head_pitch.h). Set-up only. */
#ifndef TB_TUNING_H
#define TB_TUNING_H

#include "tabor/tabor.h"

/* tabor_drum_def_tune() for a valid definition, with this allocator. */
TaborStatus tb_tune(TaborDrumDef *def, const TaborAllocator *allocator, TaborError *error);

#endif
