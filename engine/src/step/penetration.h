/* SPDX-License-Identifier: MIT */
/* Penetration of the contact points between wires and head: eta = side w - v + eta_rest + shift. w
 * is the head's and v the wire's displacement from rest; `shift` is the penetration added by moving
 * the wires' ends [m]. Audio-safe. */
#ifndef TB_PENETRATION_H
#define TB_PENETRATION_H

#include "step/state.h"

/* Computes phase->eta[stride] from the displacements of `phase`. */
void tb_penetrations_from_displacements(TbView *view, TbPhase *phase);

#endif
