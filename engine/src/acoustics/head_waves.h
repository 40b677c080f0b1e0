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

/* Wavenumber of a wave of frequency omega. */
double tb_head_wave_number(const TaborHeadDef *head, const TaborAirDef *air, double omega);

#endif
