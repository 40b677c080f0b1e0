/* SPDX-License-Identifier: MIT */
/* The sound that a mode of a closed drum sends out, far away, and the power in it.
 *
 * At the distance s from the drum's middle and the polar angle t from its axis the pressure per
 * unit amplitude is
 *   p = -omega^2 rho0 R F(t) cos(m theta) (R/s) e^{-i k s},  k s >> 1,
 * and the power of unit amplitude
 *   P = omega^4 rho0 R^4 a_m/(2 c0) Int_{-1}^1 |F|^2 d(cos t),  a_0 = 2 pi, a_m = pi.
 * The integral is Gauss's rule with TB_FAR_NODES nodes, exact for degree 15: waves up to k R =
 * TB_FAR_TOP have spherical orders up to some 6, and |F|^2 twice that. Modes of one order sound
 * together, so powers do not add, but F does. Limit: a slow monopole of the volume amplitude V
 * [m^2] has F = V/(4 pi R^2) and P = omega^4 rho0 V^2/(8 pi c0) [MorseIngard]. Set-up only. */
#ifndef TB_FAR_FIELD_H
#define TB_FAR_FIELD_H

#include "air_model/air.h"

enum { TB_FAR_NODES = 8 }; /* as many as kernels have lanes */

/* Modes of orders below this one, up to this k R, have a far field. */
#define TB_FAR_ORDERS 4u
#define TB_FAR_TOP 4.0

/* The share of the square of p s at each node [Pa^2 m^2] in the power [W], for the mean of cos^2 or
 * sin^2 over all directions: shares[TB_FAR_NODES], Gauss's weights times a_m/(rho0 c0). */
void tb_far_shares(const TaborAirDef *air, uint32_t m, double *shares);

/* The places, in radii from the upper head's centre, where fields are to be known:
 * points[TB_FAR_NODES]. `depth` of the shell in radii. */
void tb_far_points(double depth, TbAirPoint *points);

/* Turns fields I there at x = k R into F: far[2 TB_FAR_NODES], (re, im). */
void tb_far_from_fields(double depth, double x, const double *fields, double *far);

/* Decay rate of the amplitude of a mode of unit mass that feeds the field F. */
double tb_far_decay_rate(const TaborAirDef *air, double radius, uint32_t m, double omega,
                         const double *far);

#endif
