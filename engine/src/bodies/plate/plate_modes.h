/* SPDX-License-Identifier: MIT */
/* A flat plate as a body: a disc with a free edge, held in its middle, with air on both sides.
 *
 * In vacuo its modes are those of free_plate.h. The air couples those of one order, first by its
 * mass at low frequency,
 *   K u = omega^2 M u,  K = diag(omega_k^2 M_k),  M_kl = M_k [k = l] + y_k^T A y_l,
 * u the amplitudes of the modes in vacuo, y_k their Bessel amplitudes, A the air's mass, then by
 * mass and resistance at each mode's own frequency (loaded_mode.h). Rigid motions have the
 * stiffness of the mount,
 *   K = M (2 pi f)^2,  f of the heave for m = 0 and of the tilt for m = 1,
 * and its loss 2 zeta 2 pi f M. Bending loses
 *   C = sigma0 M + eta K/omega, so that the amplitude decays by sigma0/2 + eta omega/2 [1/s].
 * Left out: that a mount with a felt couples to bending, thermal loss, shear and rotary inertia
 * (the wave is longer than ten thicknesses up to 16 kHz in a bronze disc of 1 mm).
 *
 * Limits: without air the frequencies of [Leissa1969]; a rigid disc that heaves has the air's mass
 * 8/3 rho0 R^3. Set-up only. */
#ifndef TB_PLATE_MODES_H
#define TB_PLATE_MODES_H

#include "bodies/body.h"

extern const TbBodyKind tb_body_plate;

/* D = E h^3/(12 (1 - nu^2)) [N m]. */
double tb_plate_stiffness(const TaborPlateDef *plate);

#endif
