/* SPDX-License-Identifier: MIT */
/* Microphones: from each mode's radiation to the weights with which a step reads it. Set-up only. */
#ifndef TB_MICS_H
#define TB_MICS_H

#include "model/modes.h"

struct TaborModel;

/* Weights and delays of all microphones into model->mics. */
TaborStatus tb_mics_prepare(struct TaborModel *model);

/* Weights with which microphone `index` hears a mode: pressure u (q+ - 2q + q-) + v (q+ - q-) is
 * -omega^2 rho0 R I cos or sin(m theta) per unit amplitude, I = field[0] + i field[1], advanced by the
 * delay that is taken out, and times sin(omega k)/(omega k), by which the recursion's answer to a force
 * is too large. ahead = u + v and behind = u - v weigh q+ and q-; q has minus their sum, so that a step needs
 * no sums but those over its newest instant. */
void tb_mic_weights(const struct TaborModel *model, uint32_t index, double omega,
                    const TbPole *pole, uint32_t m, bool sine_copy, const double *field,
                    double *ahead, double *behind);

#endif
