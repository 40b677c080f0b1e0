/* SPDX-License-Identifier: MIT */
/* A step's data of stretching heads (heads/stretch.h). */
#ifndef TB_STRETCH_VIEW_H
#define TB_STRETCH_VIEW_H

#include "model/model.h"

typedef struct TbStretchView {
  double *pull[TB_COUPLINGS];  /* [modes padded]: see stretch.h */
  double *mixed[TB_COUPLINGS]; /* [modes padded] G q off G's diagonal */
  double *carry;               /* [grid size + TB_SLOTS]: part of `product` due to past stretch */
  double along[TB_COUPLINGS],
    rest[TB_COUPLINGS]; /* Y^T (x + q-), and the effect of rest forces on it */
  uint32_t count;       /* heads that stretch in this step: all that can, or none */
  TbStretching sums;    /* of this sample, if `summed` */
  bool summed;
  float *scratch; /* of a plate's large deflections */
} TbStretchView;

#endif
