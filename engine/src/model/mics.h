/* SPDX-License-Identifier: MIT */
/* Microphones: weights that turn each mode's motion into sound pressure, from its radiation. Set-up
 * only. */
#ifndef TB_MICS_H
#define TB_MICS_H

#include "model/modes.h"

struct TaborModel;

/* Steps by which a sound is taken earlier if two steps make a frame: the delay of the filter on its
 * way to the output (state/halve_rate.h). A microphone that is closer than this way of sound, 14 mm
 * at 48 kHz, hears the rest later.
 */
enum { TB_HALVE_STEPS = 4 };

/* Finds which modes of head.modes other drums' sound moves at some microphone: low[2 row + sine].
 * Call before the modes are listed; sets the microphones' travel. */
TaborStatus tb_mics_find_low(struct TaborModel *model, TbArena *scratch, uint8_t *low);
/* Computes weights, delays and frequency responses of all microphones, into model->mics. */
TaborStatus tb_mics_prepare(struct TaborModel *model);

/* Weights of a mode that turns by `turn` = omega k in a step for the pressure `size` field e^{i
 * phase} per unit amplitude; the rest as for tb_mic_weights(). */
void tb_pressure_weights(double turn, const TbPole *pole, double size, const double *field,
                         double phase, double *ahead, double *behind);

/* Weights of a mode for microphone `index`. The pressure u (q+ - 2q + q-) + v (q+ - q-) equals
 * -omega^2 rho0 R I cos or sin(m theta) per unit amplitude, I = field[0] + i field[1], advanced by
 * the microphone's delay. The weights include the factor sin(omega k)/(omega k), since the
 * recursion's response to a force is too large by the inverse of this factor. ahead = u + v and
 * behind = u - v weigh q+ and q-. The weight of q is minus their sum, so a step needs only sums
 * over its newest instant. */
void tb_mic_weights(const struct TaborModel *model, uint32_t index, double omega,
                    const TbPole *pole, uint32_t m, bool sine_copy, const double *field,
                    double *ahead, double *behind);

#endif
