/* SPDX-License-Identifier: MIT */
/* What of drums and swaps allocates and frees: set-up only. */
#ifndef TB_DRUM_CREATE_H
#define TB_DRUM_CREATE_H

#include "drum/drum.h"

/* A swap's mapping from its old to its new model, into its arena; false if memory ran out. */
bool tb_swap_map(TaborSwap *swap);

#endif
