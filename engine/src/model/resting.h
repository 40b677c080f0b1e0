/* SPDX-License-Identifier: MIT */
/* How little a mode may move before it rests (heads/moving_modes.h), and which modes never do. Set-up only.
 *
 * A mode of energy E swings by A = sqrt(2 E)/omega, and a microphone with the weights a and b (mics.h) hears at most
 * 2 sin(omega k/2) (|a| + |b|) A of it. Powers of modes add, so N modes are heard below -120 dBFS together if each is below
 * 1e-6/sqrt(N) of full scale; and they hold less than 1e-11 J together if each has 1e-11/N. Both hold of what rests. A soft stroke of
 * 0.1 m/s brings 6e-5 J. */
#ifndef TB_RESTING_H
#define TB_RESTING_H

#include "model/model.h"

/* Fills model->resting. Call when everything else is there. */
TaborStatus tb_resting_prepare(TaborModel *model);

#endif
