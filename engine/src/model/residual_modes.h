/* SPDX-License-Identifier: MIT */
/* What a head yields to a striker by the modes that a model leaves out.
 *
 * Two-way modes end at omega_c. A head without those above finds a tip too stiff a thing: beyond omega_c it
 * answers like a mass, and the tip's stiffness rings against that with nothing to carry the motion away. But
 * waves as short as these leave the patch, radius a, and are gone before the rim returns them: near the patch
 * the head is an infinite membrane, S(K) = T K^2 + D K^4, of mass mu(K) = rho + 2 rho0/K per area with the
 * air on both sides, and omega(K)^2 = S/mu. A force f spread over the patch moves the head's mean under it by
 *   d = f Int_{K_c}^inf B^2/(S - omega^2 mu) K dK/(2 pi),  B = 2 J1(K a)/(K a),  omega(K_c) = omega_c,
 * more than the two-way modes say. Its mobility is nothing but springy below omega_c and has the real part
 * omega B^2/(4 T) above (D = 0, no air).
 *
 * The integral is cut into TB_MISSING cells, each an oscillator of unit mass that the force drives by phi:
 *   phi^2 = Int B^2/mu K dK/(2 pi),  C = Int B^2/S K dK/(2 pi),  omega_i^2 = phi^2/C:
 * so they yield together as the missing modes do, at low frequencies and at high ones. Each decays by half
 * its cell's width in frequency: side by side, such resonances are as smooth as the continuum (within 2 exp(-pi)),
 * if a fifth short of it half an octave above the limit, by tails that reach below. What they lose is the head's, in
 * waves; without losses they keep it. The last cell has no end; what the rate cannot follow there is a spring. They
 * are modes like any other in the recursion of modes.h, so all that keeps those exact in energy keeps these. (One
 * spring with a damper, f = d/C + r d', would do for the spring; but at the limit, where the real part leaps to its
 * full size, it has a fifth of it or less under a drumstick, K_c a = 1 to 2, and over two steps without loss it
 * rings at a quarter of the rate.)
 *
 * Limits: C sums up to (1/(2 pi T)) Int_{K_c a}^inf (2 J1(u)/u)^2 du/u for D = 0; omega_c -> infinity or
 * a -> infinity leaves nothing. A point, a = 0, would yield without bound: it has no missing modes here. */
#ifndef TB_RESIDUAL_MODES_H
#define TB_RESIDUAL_MODES_H

#include "definition/params.h"

#define TB_MISSING 8u

/* Of one striker on one head; all 0: nothing is missing. */
typedef struct TbResidualModes {
  double a[TB_MISSING], b[TB_MISSING]; /* the recursion: see modes.h */
  double stiffness[TB_MISSING];        /* K' [1/s2] */
  double loss[TB_MISSING];             /* tanh(sk)/(2k^2) [1/s2] */
  double shape[TB_MISSING];            /* phi [kg^-1/2] */
  double drive[TB_MISSING];            /* g phi */
  double compliance;                   /* Sum g phi^2: over one step [m/N] */
} TbResidualModes;

/* Of the batter head above omega_c = 2 pi `bandwidth` [Hz], under a patch of `patch_radius` [m]. Set-up only. */
void tb_residual_modes_prepare(TbResidualModes *mobility, const TaborDrumDef *def, double bandwidth,
                               double patch_radius, double time_step);

/* Static compliance C and inverse mass [1/kg] of the modes with wavenumbers from..to [1/m]. Set-up only. */
void tb_residual_modes_between(const TaborDrumDef *def, double patch_radius, double from, double to,
                               double *compliance, double *inverse_mass);

/* All below is audio-safe; arrays are [TB_MISSING]. */

/* next, without a force. */
void tb_residual_modes_step(const TbResidualModes *mobility, double *next, const double *now,
                            const double *last);
/* next with a force f > 0 that presses the head down. */
void tb_residual_modes_press(const TbResidualModes *mobility, double force, double *next);
/* What the head moves up more than its modes say [m]. */
double tb_residual_modes_displacement(const TbResidualModes *mobility, const double *x);
/* Stored between two instants, and lost in a step [J]. */
double tb_residual_modes_energy(const TbResidualModes *mobility, double rate, const double *next,
                                const double *now);
double tb_residual_modes_loss(const TbResidualModes *mobility, const double *next,
                              const double *last);
/* The two instants of a motion under `from` as it goes on under `to`, phase and action kept (swap.c). */
void tb_residual_modes_carry(const TbResidualModes *from, const TbResidualModes *to, double *now,
                             double *last);

#endif
