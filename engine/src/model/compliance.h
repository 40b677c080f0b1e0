/* SPDX-License-Identifier: MIT */
/* What the head yields under the bed, on the grid (bed.h): c = G C, one matrix per class of symmetry,
 * Sum over the class's modes of table gain table^T, symmetric to the bit. */
#ifndef TB_COMPLIANCE_H
#define TB_COMPLIANCE_H

#include "model/projection.h"

typedef struct TbCompliance {
  uint32_t classes;
  uint32_t first[5];       /* of each class in a grid vector, as in TbBed */
  const double *matrix[4]; /* [points/8][points][8] */
} TbCompliance;

/* gain[modes padded]: displacement of each mode under a unit force. */
TaborStatus tb_compliance_prepare(TbCompliance *compliance, TbArena *arena,
                                  const TbProjection *projection, const double *gain);

/* out = G grid. Audio-safe. */
void tb_compliance_apply(const TbCompliance *compliance, const TbKernels *kernels,
                         const double *grid, double *out);

#endif
