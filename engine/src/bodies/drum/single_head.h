/* SPDX-License-Identifier: MIT */
/* One angular order of a single head: open, in a baffle, or in vacuo (head.h). Set-up only. */
#ifndef TB_SINGLE_HEAD_H
#define TB_SINGLE_HEAD_H

#include "bodies/body.h"
#include "bodies/drum/rim.h"

/* Computes the modes up to `limit`, at most `room`, and their vectors into `order`, whose
 * zeros are set. Returns TABOR_ERROR_MEMORY or TABOR_ERROR_NUMERICS on failure. */
TaborStatus tb_single_head_order(const TaborDrumDef *def, TbArena *arena, TbArena *scratch,
                                 const TbAirOrder *air, const TbRim *rim, TbModeLimits limit,
                                 TbBodyOrder *order, TbBodyMode *modes, uint32_t room);

#endif
