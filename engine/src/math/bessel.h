/* SPDX-License-Identifier: MIT */
/* Bessel functions by backward recurrence (Miller's algorithm, [DLMF] 3.6(iv), 10.74(iv)).
 *
 * J_{l-1}(x) = (2 l/x) J_l(x) - J_{l+1}(x) is stable downwards. Started far above both order and
 * argument, it converges to a multiple of J_l. A known sum then scales the result: 1 = J_0 + 2
 * (J_2 + J_4 + ...) for whole orders, sin x/x for spherical ones.
 *
 * Only + - * /, sqrt and comparisons are used: the same bits on every machine, and allowed on the
 * audio path. Absolute error below 1e-14 for orders to 400 and arguments to 2000. */
#ifndef TB_BESSEL_H
#define TB_BESSEL_H

#include <stdint.h>

/* J_m(x), m >= 0, x >= 0. */
double tb_bessel_j(uint32_t m, double x);

/* j[0] = J_m(x) and j[1] = J_{m+1}(x), x > 0. */
void tb_bessel_pair(uint32_t m, double x, double j[2]);

/* J_m[i](x[i]) for 8 orders and arguments at once, one per SIMD lane. */
void tb_bessel_j8(const uint32_t m[8], const double x[8], double j[8]);

/* j[l][i] = J_{l+1/2}(x[i]), l = 0 .. count-1, for 8 arguments x[i] > 0 at once. */
void tb_bessel_half8(const double x[8], uint32_t count, double *j);

/* j[l][i] = J_l(x[i]), otherwise like tb_bessel_half8(). */
void tb_bessel_whole8(const double x[8], uint32_t count, double *j);

/* The order above which J(x) is negligible in double precision. */
uint32_t tb_bessel_reach(double x);

/* Writes the zeros of J_m below `top`, ascending, at most `room`. Returns their number. Set-up
 * only. */
uint32_t tb_bessel_zeros(uint32_t m, double top, double *zeros, uint32_t room);

#endif
