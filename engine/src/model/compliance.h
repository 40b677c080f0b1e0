/* SPDX-License-Identifier: MIT */
/* Compliance of the head under the bed of wires, on the grid (wire_grid.h): c = G C, one matrix per
 * symmetry class. The matrix is the sum of table gain table^T over the modes of the class,
 * symmetric to the bit. */
#ifndef TB_COMPLIANCE_H
#define TB_COMPLIANCE_H

#include "model/projection.h"

/* gain[modes padded]: displacement of each mode under a unit force. */
TaborStatus tb_compliance_prepare(TbCompliance *compliance, TbArena *arena,
                                  const TbProjection *projection, const double *gain);

#endif
