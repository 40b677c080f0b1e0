/* SPDX-License-Identifier: MIT */
/* Modes of a drum with air inside: frequencies from cavity_eigen.h, then each mode's losses and
 * sound.
 *
 * Losses of a mode v of unit modal mass, decay rate 1/2 v^T C v:
 *   heads: rho (sigma0 + sigma1 K^2) per area, as for a single head;
 *   cavity: friction, heat conduction and absorption at its walls, P/(2E) (cavity.h);
 *   outside: the radiation resistance of both heads in free space at the mode's frequency (air.h).
 * Microphones outside the shell hear the field of air.h, those inside that of cavity_pressure.h.
 * Set-up only. */
#ifndef TB_CLOSED_DRUM_MODES_H
#define TB_CLOSED_DRUM_MODES_H

#include "acoustics/cavity_eigen.h"
#include "acoustics/head.h"

static inline bool tb_is_two_headed(const TaborDrumDef *def) { return def->two_headed != 0; }

static inline bool tb_has_cavity(const TaborDrumDef *def) {
  return tb_is_two_headed(def) || def->shell.boundary == TABOR_BOUNDARY_CLOSED;
}

/* The air inside. */
TbCavity tb_closed_drum_cavity(const TaborDrumDef *def);

/* The highest frequency [Hz], at most `bandwidth`, below which two heads and the air between them
 * have no more than TB_MAX_MODES modes. The count uses asymptotic formulas. */
double tb_closed_drum_bandwidth(const TaborDrumDef *def, double bandwidth);

/* Like tb_single_head_order(), for a drum with air inside. */
TaborStatus tb_closed_drum_order(const TaborDrumDef *def, TbArena *arena, TbArena *scratch,
                                 const TbAirOrder *air, double limit, TbHeadOrder *order,
                                 TbHeadMode *modes, uint32_t room);

#endif
