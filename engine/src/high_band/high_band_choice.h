/* SPDX-License-Identifier: MIT */
/* Which of all modes the high band keeps (high_band.h). Set-up only. */
#ifndef TB_HIGH_BAND_CHOICE_H
#define TB_HIGH_BAND_CHOICE_H

#include "high_band/high_band_modes.h"

#define TB_SIXTHS 80u /* of an octave, from 20 Hz on */

/* The sixth of an octave that has the frequency omega, and the frequency where one begins [rad/s].
 */
uint32_t tb_sixth_of(double omega);
double tb_sixth_from(uint32_t sixth);

/* True if modes share sixth of an octave and head, and are both of the air or of the head. */
bool tb_high_modes_same_band(const TbHighMode *a, const TbHighMode *b);

/* The energy that a unit force on the mode's head brings to microphone `mic`. */
double tb_high_mode_energy(const TbHighDrum *drum, const TbHighMode *mode, uint32_t mic);

/* Keeps the loudest of each sixth of an octave, in place: 99.9 % of its energy, less if those were
 * more than `most` with copies. They carry what is left out. */
TbHighModes tb_high_modes_thin(const TbHighDrum *drum, TbHighMode *candidates, uint32_t count,
                               uint32_t most);

#endif
