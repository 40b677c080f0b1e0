/* SPDX-License-Identifier: MIT */
/* G of step/stretch.h: for each head that stretches, the diagonal of Int |grad w|^2 dA over the
 * modes. Set-up only. */
#ifndef TB_STRETCH_GAIN_H
#define TB_STRETCH_GAIN_H

#include "model/model.h"

/* Fills model->stretch. */
TaborStatus tb_stretch_prepare(TaborModel *model);
/* The same with the modes up to `times` the lowest frequency, for tests of what the others do. */
TaborStatus tb_stretch_prepare_to(TaborModel *model, double times);

#endif
