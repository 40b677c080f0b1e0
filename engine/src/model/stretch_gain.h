/* SPDX-License-Identifier: MIT */
/* G of heads/stretch.h: for each head that stretches, the diagonal of Int |grad w|^2 dA over the
 * modes, and beside it what stretch_mixing.h has. Set-up only. */
#ifndef TB_STRETCH_GAIN_H
#define TB_STRETCH_GAIN_H

#include "model/model.h"

/* Fills model->stretch. */
TaborStatus tb_stretch_prepare(TaborModel *model);
/* Which modes count: those up to `times` the lowest frequency; and which mix (stretch_mixing.h). */
typedef struct TbStretchExtent {
  double times;
  TbMixingLimits mixing;
} TbStretchExtent;

/* The same to another extent, for tests of what it leaves out. */
TaborStatus tb_stretch_prepare_to(TaborModel *model, TbStretchExtent extent);

#endif
