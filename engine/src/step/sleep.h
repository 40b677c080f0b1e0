/* SPDX-License-Identifier: MIT */
/* Falling asleep: a drum that has died away stops, and costs nothing until it is played again.
 * Unless something holds it away from its rest, it returns there exactly; what it still held is
 * booked as lost. Audio-safe.
 *
 * At draft and live it sleeps when nobody hears it: what its microphones would hear of all modes,
 * whose powers add (model/resting.h), is below -110 dBFS, and the wires touch what they touch at
 * rest, so that none rattles. Modes that hardly radiate, and wires between their contacts, may
 * still swing: 4e-7 J of a snare drum's stroke of 4.5 m/s, by which it would be awake for three
 * seconds more. At studio and reference, without losses and without any sound, a drum sleeps when
 * its motion is within rounding of nothing. */
#ifndef TB_SLEEP_H
#define TB_SLEEP_H

#include "state/state.h"

/* To be called every `steps` steps, 64: puts a drum to sleep that has been still for 16 calls,
 * clears vanished modes before they become denormal numbers, keeps a plate's large deflections
 * right, and puts a drum to rest whose state is not finite. */
void tb_sleep_check(TbView *view, uint32_t steps);

#endif
