/* SPDX-License-Identifier: MIT */
/* Energy stored between two successive instants, counted from the rest state [J]. Audio-safe.
 *
 * Modes and wires are quadratic in their deviation from rest. A contact contributes the mean over
 * the two instants of V(eta) - V(eta_r) - f_r (eta - eta_r - shift): the linear terms of head,
 * wires and gravity around the equilibrium sum up to -f_r times the deviation. A wire whose tension
 * has moved by dT since rest adds dT Int (v_r'^2/2 + v_r' v') dx. */
#ifndef TB_ENERGY_H
#define TB_ENERGY_H

#include "state/state.h"

double tb_energy_stored(const TbView *view, const TbPhase *next, const TbPhase *now);

/* The part of tb_energy_stored() that the wires and their contacts store. */
double tb_energy_wires(const TbView *view, const TbPhase *next, const TbPhase *now);
/* Energy of the high band; no balance includes it. */
double tb_energy_high(const TbView *view);
/* Kinetic energy alone, of head, wires and strikers. */
double tb_energy_motion(const TbView *view, const TbPhase *next, const TbPhase *now);

/* Losses [J] of the step from view->last to view->next, without those of contacts. */
typedef struct TbLosses {
  double head, radiated, shell, wires;
} TbLosses;
TbLosses tb_losses(const TbView *view);
/* The same with the modes' losses known: of heads, sound and shell. */
TbLosses tb_losses_with(const TbView *view, const double by[3]);

#endif
