/* SPDX-License-Identifier: MIT */
/* The bed (bed.h) and the head's compliance under it rounded to single precision. */
#ifndef TB_BEDF_H
#define TB_BEDF_H

#include "model/compliance.h"

/* Rounds the bed's own shapes to single precision, so that both precisions mean the same grid, and copies it. */
bool tb_bedf_prepare(TbBedF *bedf, TbArena *arena, TbBed *bed);

bool tb_compliancef_prepare(TbComplianceF *compliancef, TbArena *arena,
                            const TbCompliance *compliance);

#endif
