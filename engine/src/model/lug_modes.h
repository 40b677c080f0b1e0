/* SPDX-License-Identifier: MIT */
/* The modes of heads whose lugs pull unevenly: which modes are coupled, and the frequencies that result. What the
 * coupling does in every sample is in step/lug_forces.h. Set-up only. */
#ifndef TB_LUG_MODES_H
#define TB_LUG_MODES_H

#include "model/model.h"

/* dK of the heads' lower modes, and the modes that come of it, into model->lugs.
 * TABOR_ERROR_RANGE, and `error` says why, if a head would go slack. */
TaborStatus tb_lug_modes_prepare(TaborModel *model, TaborError *error);

#endif
