/* SPDX-License-Identifier: MIT */
/* Cost of the set-up of a drum's modes: see model/build_estimate.h. Set-up only. */
#ifndef TB_DRUM_COST_H
#define TB_DRUM_COST_H

#include "bodies/body.h"

/* As TbBodyKind.cost. */
TbBodyCost tb_drum_cost(const TaborDrumDef *def, const TaborDrumDef *resolved, double basis_top,
                        double bandwidth, uint32_t most_modes);

#endif
