/* SPDX-License-Identifier: MIT */
/* Falling asleep: a drum that has died away stops, and costs nothing until it is played again. It returns to its rest
 * exactly if it is within rounding of it. Audio-safe. */
#ifndef TB_SLEEP_H
#define TB_SLEEP_H

#include "state/state.h"

/* To be called every 64 samples: puts a drum to sleep that has been still for 16 calls, clears vanished modes before they
 * become denormal numbers, and puts a drum to rest whose state is not finite. */
void tb_sleep_check(TbView *view);

#endif
