/* SPDX-License-Identifier: MIT */
/* The power that the lowest modes of a closed drum send out together, from the pressure far away
 * (far_field.h).
 *
 * A mode's resistance is what it would lose if it moved alone at its own frequency. A stick or a
 * beater moves all modes as one dent, at other frequencies than theirs, and the sounds of modes of
 * one order add up or cancel. So the ledger books what the far field carries: in each direction,
 * order and copy the pressure of all modes, weighed as microphones weigh them (mics.h), squared.
 * Energy that the modes' resistances take beyond that is booked as loss of the heads. Modes of
 * higher orders, or above k R = TB_FAR_TOP, book their own resistance; so do all while sound from
 * outside pushes, since much of their field then is that sound, scattered. Set-up only. */
#ifndef TB_RADIATED_POWER_H
#define TB_RADIATED_POWER_H

#include "model/modes.h"

/* Steps between two looks at the far field: of motion that strikers force this leaves a quarter of
 * the step rate's bandwidth, 6 kHz at 48 kHz. */
enum { TB_FAR_STEPS = 4 };

/* Orders and copies: cos(m theta), and sin(m theta) for m > 0. */
enum { TB_FAR_GROUPS = 2 * TB_FAR_ORDERS - 1 };

/* With d+ = q+ - q, d- = q- - q of the modes of a group,
 *   Sum_i (Sum_j ahead[j][i] d+_j + behind[j][i] d-_j)^2
 * is the energy [J] that the group sends out in TB_FAR_STEPS steps, and Sum_j loss[j] (d+_j -
 * d-_j)^2 what its modes lose to the air meanwhile. */
typedef struct TbRadiatedPower {
  uint32_t group[TB_FAR_GROUPS + 1]; /* first entry of each group */
  uint32_t *mode;                    /* [entries] */
  double *loss;                      /* [entries] [kg/s^2] */
  double *ahead, *behind;            /* [entries][TB_FAR_NODES] */
} TbRadiatedPower;

struct TaborModel;

/* Fills model->power. */
TaborStatus tb_radiated_power_prepare(struct TaborModel *model);

#endif
