/* SPDX-License-Identifier: MIT */
/* What the head yields under the bed, on the grid (wire_grid.h): c = G C, one matrix per class of symmetry,
 * Sum over the class's modes of table gain table^T, symmetric to the bit. */
#ifndef TB_COMPLIANCE_H
#define TB_COMPLIANCE_H

#include "model/projection.h"

/* gain[modes padded]: displacement of each mode under a unit force. */
TaborStatus tb_compliance_prepare(TbCompliance *compliance, TbArena *arena,
                                  const TbProjection *projection, const double *gain);

#endif
