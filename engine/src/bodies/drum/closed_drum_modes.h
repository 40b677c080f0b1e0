/* SPDX-License-Identifier: MIT */
/* Modes of a drum with air inside: frequencies from cavity_eigen.h, then each mode's losses and
 * sound.
 *
 * Losses of a mode v of unit modal mass, decay rate 1/2 v^T C v:
 *   heads: rho (sigma0 + sigma_k K + sigma1 K^2) per area, as for a single head, and felt_ring.h;
 *   cavity: friction, heat conduction and absorption at its walls, P/(2E) (cavity.h);
 *   rim: rim.h;
 *   outside: the radiation resistance of both heads and of the rim at the mode's frequency.
 * Low modes radiate from the finite rigid shell (shell_radiation.h) and get the mass of the air
 * outside at their own frequency (a Rayleigh quotient, right to second order). Modes of high order,
 * or above the shell's largest x, radiate as in air.h ("Drum"); from 0.9 of that x on, one passes
 * into the other. Microphones outside the shell hear that field, those inside the one of
 * cavity_pressure.h. Set-up only. */
#ifndef TB_CLOSED_DRUM_MODES_H
#define TB_CLOSED_DRUM_MODES_H

#include "air_model/shell_radiation.h"
#include "bodies/body.h"
#include "bodies/drum/cavity_eigen.h"

static inline bool tb_is_two_headed(const TaborDrumDef *def) { return def->two_headed != 0; }

static inline bool tb_has_cavity(const TaborDrumDef *def) {
  return tb_is_two_headed(def) || def->shell.boundary == TABOR_BOUNDARY_CLOSED;
}

/* The air inside, with the wall's admittance to motions of order m at omega [rad/s]. */
TbCavity tb_closed_drum_cavity(const TaborDrumDef *def, uint32_t m, double omega);

/* The highest frequency [Hz], at most `bandwidth`, below which two heads and the air between them
 * have no more than `most` modes. The count uses asymptotic formulas. */
double tb_closed_drum_bandwidth(const TaborDrumDef *def, double bandwidth, uint32_t most);
/* How many modes, sine copies counted, they have below `bandwidth` [Hz], by the same formulas. */
double tb_closed_drum_mode_count(const TaborDrumDef *def, double bandwidth);

/* About how many coordinates an order m of the drum has that is computed from Bessel functions with
 * zeros up to `basis_top` and up to `limit` [rad/s]: those of the heads and of the enclosed air. */
double tb_closed_drum_order_size(const TaborDrumDef *def, double m, double basis_top, double limit);

/* Frequency [rad/s], at most `limit`, up to which the air's modes are those of the cylinder. */
double tb_closed_drum_air_top(const TaborDrumDef *def, double limit);
/* How many of them, sine copies counted, there are below `omega`, by the same formulas. */
double tb_closed_drum_air_modes(const TaborDrumDef *def, double omega);

/* The shell of a drum and its microphones. Returns false if memory ran out. */
bool tb_closed_drum_shell(const TaborDrumDef *def, TbArena *arena, TbShellMesh *shell);

/* Like tb_single_head_order(), for a drum with air inside. `shell` is NULL without air. */
TaborStatus tb_closed_drum_order(const TaborDrumDef *def, TbArena *arena, TbArena *scratch,
                                 const TbAirOrder *air, const TbRim *rim, const TbShellMesh *shell,
                                 TbModeLimits limit, TbBodyOrder *order, TbBodyMode *modes,
                                 uint32_t room);

#endif
