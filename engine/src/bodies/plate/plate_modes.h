/* SPDX-License-Identifier: MIT */
/* A plate as a body: a disc or a cymbal, with a free edge, held in its middle, with air on both
 * sides.
 *
 * Its deflection is a sum of modes of the flat, even disc (disc_modes.h), u their amplitudes; in
 * vacuo it has the mass M and the stiffness K of plate_forms.h. The air couples the modes of one
 * order, first by its mass at low frequency,
 *   (K + K_mount) u = omega^2 (M + Y^T A Y) u,
 * Y the Bessel amplitudes of the disc's modes, A the air's mass, then by mass and resistance at
 * each mode's own frequency (loaded_mode.h). The mount holds the rigid motion, u_0 of m < 2, by the
 * momentum p = (M u)_0 in it,
 *   u^T K_mount u = (2 pi f)^2 p^2/M_00,  f of the heave for m = 0 and of the tilt for m = 1,
 * with the loss 2 zeta 2 pi f p^2/M_00, so that bent modes, which have no such momentum in vacuo,
 * stay as they are. Otherwise the plate loses
 *   C = sigma0 M + eta K/omega, so that the amplitude decays by sigma0/2 + eta omega/2 [1/s].
 * Left out: that a mount with a felt couples to bending, thermal loss, shear and rotary inertia
 * (the wave is longer than ten thicknesses up to 16 kHz in a bronze disc of 1 mm).
 *
 * Limits: without air a flat disc has the frequencies of [Leissa1969], a cap those of
 * [ThomasTouzeChaigne2005]; a rigid disc that heaves has the air's mass 8/3 rho0 R^3. Set-up only.
 */
#ifndef TB_PLATE_MODES_H
#define TB_PLATE_MODES_H

#include "bodies/body.h"

extern const TbBodyKind tb_body_plate;

/* D = E h^3/(12 (1 - nu^2)) [N m]. */
double tb_plate_stiffness(const TaborPlateDef *plate, double thickness);

#endif
