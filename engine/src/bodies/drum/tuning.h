/* SPDX-License-Identifier: MIT */
/* Tensions for the pitches of a definition (bodies/drum/head_pitch.h). Set-up only. */
#ifndef TB_TUNING_H
#define TB_TUNING_H

#include "math/arena.h"

/* tabor_drum_def_tune() for a valid definition, with the allocator and the watch of `beside`. */
TaborStatus tb_tune(TaborDrumDef *def, const TbArena *beside, TaborError *error);
/* The same by a formula, within some ten per cent of the tension, for estimates; a pitch that the
 * head cannot have gives the nearest tension. */
void tb_tune_roughly(TaborDrumDef *def);

#endif
