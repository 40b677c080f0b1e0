/* SPDX-License-Identifier: MIT */
/* The bed (wire_grid.h) and the head's compliance under it rounded to single precision. */
#ifndef TB_WIRE_GRIDF_H
#define TB_WIRE_GRIDF_H

#include "model/compliance.h"

/* Rounds the bed's own shapes to single precision, so that both precisions mean the same grid, and copies it. */
bool tb_wire_gridf_prepare(TbWireGridF *wire_gridf, TbArena *arena, TbWireGrid *wire_grid);

bool tb_compliancef_prepare(TbComplianceF *compliancef, TbArena *arena,
                            const TbCompliance *compliance);

#endif
