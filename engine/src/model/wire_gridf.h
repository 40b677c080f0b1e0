/* SPDX-License-Identifier: MIT */
/* The wire grid (wire_grid.h) and the head's compliance on it, rounded to single precision. */
#ifndef TB_WIRE_GRIDF_H
#define TB_WIRE_GRIDF_H

#include "model/compliance.h"

/* Rounds the shapes of `wire_grid` itself to single precision, so that both precisions use the same
 * grid, and copies them to `wire_gridf`. */
bool tb_wire_gridf_prepare(TbWireGridF *wire_gridf, TbArena *arena, TbWireGrid *wire_grid);

bool tb_compliancef_prepare(TbComplianceF *compliancef, TbArena *arena,
                            const TbCompliance *compliance);

#endif
