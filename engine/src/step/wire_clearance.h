/* SPDX-License-Identifier: MIT */
/* Wires that hang clear of the head ("lifted").
 *
 * With the strainer off, wires lie still some millimetres away from a head that moves by a fraction
 * of that distance. While no point of the head can come near a wire, neither the wires nor the
 * head's motion under them is computed: the wires' deviations, contact forces and changes of
 * penetration are exactly 0. Only a drum that is defined with its strainer off lifts its wires:
 * where it is thrown off while it is played, they hang in another shape than that of rest, and go
 * on being computed.
 *
 * The head's displacement under the wires is at most Sum_i |q_i| max |phi_i| (model/wire_reach.h).
 * The wires count as lifted while this bound stays below half of the least gap. A head would have
 * to move at 30 m/s to cross the other half in one step, even at 22,050 Hz.
 * Audio-safe. */
#ifndef TB_WIRE_CLEARANCE_H
#define TB_WIRE_CLEARANCE_H

#include "state/state.h"

/* Lifts wires that lie still and out of the head's reach. */
void tb_wire_clearance_begin(TbView *view);
/* Lowers the wires if the head comes near. Call after a step. */
void tb_wire_clearance_follow(TbView *view);
/* Lowers the wires and computes every quantity that was skipped. Call before anything of the wires
 * is moved. */
void tb_wire_clearance_end(TbView *view);

/* True if every wire has the tension that the definition gives it. */
bool tb_wires_have_own_tension(const TbView *view);

#endif
