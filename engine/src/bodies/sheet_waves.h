/* SPDX-License-Identifier: MIT */
/* Plane waves on a sheet, a head or a plate, with air on both sides, as long as they are slower
 * than sound:
 *   omega^2 = (T k^2 + D k^4)/m,  m = rho + 2 rho0/(k sqrt(1 - (omega/(c0 k))^2)).
 * Set-up only. */
#ifndef TB_SHEET_WAVES_H
#define TB_SHEET_WAVES_H

#include "definition/params.h"

/* Stiffness T K^2 + D K^4 of a sheet per area [N/m3], K its wavenumber [1/m]. */
double tb_sheet_stiffness(const TaborHeadDef *head, double wavenumber);
/* The part of the loss that a rigidly lifted film does not have [1/s]: sigma_k K + sigma1 K^2
 * (bodies/drum/drum_modes.h). */
double tb_sheet_film_loss(const TaborHeadDef *head, double wavenumber);

/* Frequency [rad/s] of a wave of wavenumber k [1/m], and *mass, m [kg/m2]. */
double tb_sheet_wave_frequency(const TaborHeadDef *head, const TaborAirDef *air, double wavenumber,
                               double *mass);

/* Decay rate [1/s] that the losses of the sheet (bodies/drum/drum_modes.h) and felt ring
 * (felt_ring.h) give to one Bessel function by itself; `mass` as above, `slope`: J_{m+1}(zero). */
double tb_sheet_wave_decay_rate(const TaborHeadDef *head, double radius, uint32_t m, double zero,
                                double slope, double mass);

/* Wavenumber of a wave of frequency omega. */
double tb_sheet_wave_number(const TaborHeadDef *head, const TaborAirDef *air, double omega);

#endif
