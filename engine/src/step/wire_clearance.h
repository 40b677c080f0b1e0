/* SPDX-License-Identifier: MIT */
/* Wires that hang clear of the head.
 *
 * With the strainer off, wires lie still some millimetres away from a head that moves by a fraction of
 * that. While no point of the head can come near one of them, neither the wires nor the head's motion
 * under them is computed: their deviations, contact forces and changes of penetration are exactly 0.
 *
 * The head's displacement under the wires is at most Sum_i |q_i| max |phi_i| (model/wire_reach.h). The wires count as lifted while that stays below half of the least gap; it would take 30 m/s to
 * cross the other half of the least gap that counts within one sample, even at 22,050 Hz. Audio-safe. */
#ifndef TB_WIRE_CLEARANCE_H
#define TB_WIRE_CLEARANCE_H

#include "step/state.h"

/* Lifts wires that lie still and out of reach. */
void tb_wire_clearance_begin(TbView *view);
/* After a step: lowers them when the head comes near. */
void tb_wire_clearance_follow(TbView *view);
/* Lowers them: all that was left out is made good. Before anything of theirs is moved. */
void tb_wire_clearance_end(TbView *view);

#endif
