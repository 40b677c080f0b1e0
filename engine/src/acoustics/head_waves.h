/* SPDX-License-Identifier: MIT */
/* Plane waves on a head with air on both sides, as long as they are slower than sound:
 *   omega^2 = (T k^2 + D k^4)/m,  m = rho + 2 rho0/(k sqrt(1 - (omega/(c0 k))^2)).
 * Set-up only. */
#ifndef TB_HEAD_WAVES_H
#define TB_HEAD_WAVES_H

#include "definition/params.h"

/* Frequency [rad/s] of a wave of wavenumber k [1/m], and *mass, m [kg/m2]. */
double tb_head_wave_frequency(const TaborHeadDef *head, const TaborAirDef *air, double wavenumber,
                              double *mass);

/* Decay rate [1/s] that the losses of head (head.h) and felt ring (felt_ring.h) give to one Bessel function by itself;
 * `mass` as above, `slope`: J_{m+1}(zero). */
double tb_head_wave_decay_rate(const TaborHeadDef *head, double radius, uint32_t m, double zero,
                               double slope, double mass);

/* Wavenumber of a wave of frequency omega. */
double tb_head_wave_number(const TaborHeadDef *head, const TaborAirDef *air, double omega);

#endif
