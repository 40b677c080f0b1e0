/* SPDX-License-Identifier: MIT */
/* G of step/stretch.h: the diagonal of Int |grad w|^2 dA over the modes, of each head that stretches. Set-up only. */
#ifndef TB_STRETCH_GAIN_H
#define TB_STRETCH_GAIN_H

#include "model/model.h"

/* Fills model->stretch. */
TaborStatus tb_stretch_prepare(TaborModel *model);

#endif
