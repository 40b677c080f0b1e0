/* SPDX-License-Identifier: MIT */
/* The modes of heads whose lugs pull unevenly: the choice of coupled modes, and the resulting
 * frequencies. heads/lug_forces.h has the coupling in every sample. Set-up only. */
#ifndef TB_LUG_MODES_H
#define TB_LUG_MODES_H

#include "model/model.h"

/* Computes dK of the heads' lower modes and the resulting modes, into model->lugs. Returns
 * TABOR_ERROR_RANGE with an explanation in `error` if a head would go slack. */
TaborStatus tb_lug_modes_prepare(TaborModel *model, TaborError *error);

#endif
