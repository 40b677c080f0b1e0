/* SPDX-License-Identifier: MIT */
/* Modes of a thin flat disc with a free edge, in vacuo [Leissa1969] ch. 2.
 *
 *   D lap^2 w + rho h w_tt = 0,  D = E h^3/(12 (1 - nu^2)),
 * no moment and no shear at the edge. In the angular order m, with x = r/R and l = lambda,
 *   w = J_m(l x) + (c/I_m(l)) I_m(l x),  omega = l^2 sqrt(D/(rho h))/R^2,
 * l a root of
 *   (l^2 J + (1 - nu)(l J' - m^2 J)) (l^2 q - (1 - nu) m^2 (q - 1))
 *     = (l^3 J' + (1 - nu) m^2 (l J' - J)) (l^2 - (1 - nu)(q - m^2)),
 *   q = l I_m'(l)/I_m(l) = m + l I_{m+1}/I_m,
 *   c = (l^2 J + (1 - nu)(l J' - m^2 J))/(l^2 - (1 - nu)(q - m^2)).
 * The ratio of the modified functions is a continued fraction [DLMF] 10.33.1, so nothing overflows.
 * For m = 0 and 1 the rigid motions x^m come first, with l = 0. [DLMF] 10.22 gives
 *   Int_0^1 w^2 x dx = ((1 - m^2/l^2) J^2 + J'^2)/2 + c^2 ((1 + m^2/l^2) - q^2/l^2)/2
 *                      + c (J q - l J')/l^2,
 * and, with J_m(z) = 0, the amplitudes of
 *   w = e x^m + Sum_i v_i J_m(z_i x),  e = J + c,
 *   v_i = (2 l^2/(z_i J_{m+1}(z_i))) (J/(z_i^2 - l^2) - c/(z_i^2 + l^2)).
 * Limits: the frequency parameters l^2 of [Leissa1969], table 2.5; a rigid motion has no v. Set-up
 * only. */
#ifndef TB_FREE_PLATE_H
#define TB_FREE_PLATE_H

#include <stdint.h>

typedef struct TbFreePlateMode {
  double lambda; /* 0: rigid */
  double j;      /* J_m(lambda) */
  double slope;  /* J_m'(lambda) */
  double c;
  double edge;   /* e */
  double square; /* Int_0^1 w^2 x dx */
} TbFreePlateMode;

/* The modes of order m up to lambda = `top`, ascending, at most `room`; returns their number. */
uint32_t tb_free_plate_modes(uint32_t m, double poisson_ratio, double top, TbFreePlateMode *modes,
                             uint32_t room);

/* v_i at the zero z_i, `z_slope`: J_{m+1}(z_i). */
double tb_free_plate_amplitude(const TbFreePlateMode *mode, double zero, double z_slope);

#endif
