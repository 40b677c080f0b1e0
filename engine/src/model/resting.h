/* SPDX-License-Identifier: MIT */
/* How little a mode may move before it rests (heads/moving_modes.h), which modes never do, and what
 * microphones hear of each (step/sleep.h). Set-up only.
 *
 * A mode that turns by theta = omega k in a step changes by d = t A in a step at most, t = 2
 * sin(theta/2), where A is its amplitude. A microphone with the weights a and b (mics.h) hears |a
 * e^(i theta) - b| d of it, the square of which is
 *   h d^2,  h = (a - b)^2 + a b t^2,  t^2 = K' k^2.
 * `heard` is h over the square of full scale, at the microphone that hears the mode best, a gain
 * below 1 taken as 1: a fader that is down may be pushed up.
 *
 * A mode of energy E has A = sqrt(2 E)/omega. Powers of modes add, so N modes are heard below -120
 * dBFS together if each is below 1e-6/sqrt(N) of full scale; and they hold less than 1e-11 J
 * together if each has 1e-11/N. Both hold of what rests. A soft stroke of 0.1 m/s brings 6e-5 J. */
#ifndef TB_RESTING_H
#define TB_RESTING_H

#include "model/model.h"

/* Fills model->resting. Call when everything else is there. */
TaborStatus tb_resting_prepare(TaborModel *model);

#endif
