/* SPDX-License-Identifier: MIT */
/* The coupling of a plate's modes by large deflections, for the step: see bodies/membrane.h and
 * heads/von_karman.h. Set-up only. */
#ifndef TB_PLATE_COUPLING_H
#define TB_PLATE_COUPLING_H

#include "kernels/kernels.h"
#include "math/arithmetic.h"
#include "tabor/tabor.h"

typedef struct TbPlateCoupling {
  TbVonKarman tables; /* without pairs: nothing is coupled */
  uint32_t *mode;     /* [pairs][2]: among TbModes, or TB_NO_MODE */
  uint32_t every;     /* it acts in every so many steps */
  double scale;       /* D (h/R)^2: energy at which a plate of thickness h bends by h [J] */
  double quiet;       /* modes that hold less are not coupled [J] */
} TbPlateCoupling;

/* Fills model->plate; model->stretch, which follows it, and model->cascade read it. */
TaborStatus tb_plate_coupling_prepare(TaborModel *model);

#endif
