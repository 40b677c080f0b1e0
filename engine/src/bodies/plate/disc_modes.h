/* SPDX-License-Identifier: MIT */
/* Modes of a thin flat disc of uniform thickness in vacuo, with a free or a clamped edge
 * [Leissa1969] ch. 2. Free ones are deflections of a plate; clamped ones serve as its functions of
 * stress, which vanish at a free edge together with their slope.
 *
 *   D lap^2 w + rho h w_tt = 0,  D = E h^3/(12 (1 - nu^2)).
 * In the angular order m, with x = r/R and l = lambda,
 *   w = J_m(l x) + (c/I_m(l)) I_m(l x),  omega = l^2 sqrt(D/(rho h))/R^2.
 * Free (no moment, no shear at the edge): l is a root of
 *   (l^2 J + (1 - nu)(l J' - m^2 J)) (l^2 q - (1 - nu) m^2 (q - 1))
 *     = (l^3 J' + (1 - nu) m^2 (l J' - J)) (l^2 - (1 - nu)(q - m^2)),
 *   q = l I_m'(l)/I_m(l) = m + l I_{m+1}/I_m,
 *   c = (l^2 J + (1 - nu)(l J' - m^2 J))/(l^2 - (1 - nu)(q - m^2)).
 * Clamped: l J' = q J, c = -J.
 * The ratio of the modified functions is a continued fraction [DLMF] 10.33.1, so nothing overflows.
 * For m = 0 and 1 the rigid motions x^m come first of the free ones, with l = 0.
 *
 * With J_m(z) = 0, [DLMF] 10.22 gives the amplitudes of
 *   w = e x^m + Sum_i v_i J_m(z_i x),  e = J + c,
 *   v_i = (2 l^2/(z_i J_{m+1}(z_i))) (J/(z_i^2 - l^2) - c/(z_i^2 + l^2)).
 * Limits: the frequency parameters l^2 of [Leissa1969], tables 2.1 and 2.5; a rigid motion has no
 * v. Set-up only. */
#ifndef TB_DISC_MODES_H
#define TB_DISC_MODES_H

#include "math/bessel_table.h"

typedef enum TbDiscEdge { TB_DISC_FREE, TB_DISC_CLAMPED } TbDiscEdge;

typedef struct TbDiscMode {
  double lambda; /* 0: rigid */
  double j;      /* J_m(lambda) */
  double c;
  double edge; /* e */
} TbDiscMode;

/* The modes of order m up to lambda = `top`, ascending, at most `room`; returns their number.
 * Poisson's ratio is without effect on clamped ones. */
uint32_t tb_disc_modes(TbDiscEdge edge, uint32_t m, double poisson_ratio, double top,
                       TbDiscMode *modes, uint32_t room);

/* v_i at the zero z_i, `z_slope`: J_{m+1}(z_i). */
double tb_disc_amplitude(const TbDiscMode *mode, double zero, double z_slope);

/* A mode along a radius: arrays [count] of its value and, for the surface w(r) cos(m theta), of
 *   radial  w_rr,   azimuthal  w_r/r - m^2 w/r^2,   twist  m (w_r/r - w/r^2),
 * the factors of cos(m theta), cos(m theta) and -sin(m theta). */
typedef struct TbDiscWave {
  double *value, *radial, *azimuthal, *twist; /* 1, 1/m^2, 1/m^2, 1/m^2 */
} TbDiscWave;

/* Finds them at r[count] > 0 [m] on a disc of this radius [m]; `table` as in bessel_table.h, or
 * NULL. */
void tb_disc_wave(const TbDiscMode *mode, const TbBesselTable *table, uint32_t m, double radius,
                  uint32_t count, const double *r, const TbDiscWave *wave);

#endif
