/* SPDX-License-Identifier: MIT */
/* Largest displacement that each mode of the head causes at the wires, per unit amplitude: max
 * |phi| over all contact points. The head's displacement under the wires is at most Sum_i |q_i| max
 * |phi_i|; below the clearance no wire can be touched (step/wire_clearance.h). Set-up only. */
#ifndef TB_WIRE_REACH_H
#define TB_WIRE_REACH_H

#include "model/model.h"

/* Fills model->reach[modes padded]. */
TaborStatus tb_wire_reach_prepare(TaborModel *model, TbArena *scratch);

#endif
