/* SPDX-License-Identifier: MIT */
/* Compliance of a head under a striker by the modes that a model leaves out.
 *
 * Two-way modes end at omega_c. To a tip, a head without the modes above is too stiff: beyond
 * omega_c it answers like a mass, and the tip's stiffness rings against that mass with nothing to
 * carry the motion away. In fact such short waves leave the patch, radius a, and are gone before
 * the rim returns them. Near the patch the head is an infinite membrane, S(K) = T K^2 + D K^4, of
 * mass mu(K) = rho + 2 rho0/K per area with the air on both sides, and omega(K)^2 = S/mu. A force f
 * spread over the patch moves the head's mean under the patch by
 *   d = f Int_{K_c}^inf B^2/(S - omega^2 mu) K dK/(2 pi),  B = 2 J1(K a)/(K a),
 *     omega(K_c) = omega_c,
 * more than the two-way modes do. The mobility of this part is purely springy below omega_c and has
 * the real part omega B^2/(4 T) above (D = 0, no air).
 *
 * The integral is cut into TB_TRUNCATED cells, each an oscillator of unit mass that the force
 * drives by phi:
 *   phi^2 = Int B^2/mu K dK/(2 pi),  C = Int B^2/S K dK/(2 pi),  omega_i^2 = phi^2/C.
 * Together the cells yield as the truncated modes do, at low and at high frequencies. Each decays
 * by half its cell's width in frequency. Side by side, such resonances are as smooth as the
 * continuum (within 2 exp(-pi)), but half an octave above omega_c they are a fifth short of it,
 * because their tails reach below omega_c. Their losses are the head's, in waves; without losses
 * the cells keep the energy. The last cell has no upper end; its part too fast for the sample rate
 * is a spring. The cells use the recursion of modes.h, so they are as exact in energy as other
 * modes. (One spring with a damper, f = d/C + r d', would do for the spring. But at the limit,
 * where the real part leaps to its full size, the spring has a fifth of it or less under a
 * drumstick, K_c a = 1 to 2; and over two steps without loss the spring rings at a quarter of the
 * sample rate.)
 *
 * Limits: C sums up to (1/(2 pi T)) Int_{K_c a}^inf (2 J1(u)/u)^2 du/u for D = 0. For omega_c ->
 * infinity or a -> infinity, nothing is missing. A point, a = 0, would yield without bound: it has
 * no truncated modes here. */
#ifndef TB_TRUNCATED_MODES_H
#define TB_TRUNCATED_MODES_H

#include "definition/params.h"

#define TB_TRUNCATED 8u

/* A sheet between two halves of space. */
typedef struct TbSheetInAir {
  const TaborHeadDef *sheet;
  const TaborAirDef *air;
  bool losses; /* false: what is truncated does not lose energy */
} TbSheetInAir;

/* Truncated modes of one striker on one head; all 0: none. */
typedef struct TbTruncatedModes {
  double a[TB_TRUNCATED], b[TB_TRUNCATED]; /* the recursion: see modes.h */
  double stiffness[TB_TRUNCATED];          /* K' [1/s2] */
  double loss[TB_TRUNCATED];               /* tanh(sk)/(2k^2) [1/s2] */
  double shape[TB_TRUNCATED];              /* phi [kg^-1/2] */
  double drive[TB_TRUNCATED];              /* g phi */
  double compliance;                       /* Sum g phi^2: over one step [m/N] */
} TbTruncatedModes;

/* Prepares the truncated modes of a sheet above omega_c = 2 pi `bandwidth` [Hz], under a
 * patch of `patch_radius` [m]. Set-up only. */
void tb_truncated_modes_prepare(TbTruncatedModes *mobility, const TbSheetInAir *sheet,
                                double bandwidth, double patch_radius, double time_step);

/* Static compliance C and inverse mass [1/kg] of the modes with wavenumbers `from` to `to` [1/m].
 * Set-up only. */
void tb_truncated_modes_between(const TbSheetInAir *sheet, double patch_radius, double from,
                                double to, double *compliance, double *inverse_mass);

/* All below is audio-safe; arrays are [TB_TRUNCATED]. */

/* Computes `next` without a force. */
void tb_truncated_modes_step(const TbTruncatedModes *mobility, double *next, const double *now,
                             const double *last);
/* Adds the effect of a force f > 0 that presses the head down to `next`. */
void tb_truncated_modes_press(const TbTruncatedModes *mobility, double force, double *next);
/* Upward displacement of the head by the truncated modes [m]. */
double tb_truncated_modes_displacement(const TbTruncatedModes *mobility, const double *x);
/* Energy stored between two instants, and energy lost in a step [J]. */
double tb_truncated_modes_energy(const TbTruncatedModes *mobility, double rate, const double *next,
                                 const double *now);
double tb_truncated_modes_loss(const TbTruncatedModes *mobility, const double *next,
                               const double *last);
/* Converts the two instants of a motion from the coefficients of `from` to those of `to`, keeping
 * phase and action (swap.c). */
void tb_truncated_modes_carry(const TbTruncatedModes *from, const TbTruncatedModes *to,
                              double ratio, double *now, double *last);

#endif
