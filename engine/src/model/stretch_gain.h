/* SPDX-License-Identifier: MIT */
/* G of step/stretch.h: for each head that stretches, the diagonal of Int |grad w|^2 dA over the
 * modes. Set-up only. */
#ifndef TB_STRETCH_GAIN_H
#define TB_STRETCH_GAIN_H

#include "model/model.h"

/* Fills model->stretch. */
TaborStatus tb_stretch_prepare(TaborModel *model);

#endif
