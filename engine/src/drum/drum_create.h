/* SPDX-License-Identifier: MIT */
/* Creation and destruction of drums and swaps: the functions that allocate and free. Set-up
 * only. */
#ifndef TB_DRUM_CREATE_H
#define TB_DRUM_CREATE_H

#include "drum/drum.h"

/* Computes a swap's mapping from its old to its new model, in its arena. Returns false if memory
 * ran out. */
bool tb_swap_map(TaborSwap *swap);

#endif
