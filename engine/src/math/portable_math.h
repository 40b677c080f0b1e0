/* SPDX-License-Identifier: MIT */
/* The functions of libm that the engine needs, made of + - * / and sqrt: the same bits on every
 * machine. From libm itself the engine calls only functions with exact or correctly rounded
 * results: sqrt, fabs, floor, ceil, fmin, fmax.
 *
 *   sin, cos   x = n pi/2 + r, |r| <= pi/4, with pi/2 in four parts; Taylor's series of r
 *   exp        x = n ln 2 + r, |r| <= ln 2/2; Taylor's series of r
 *   log        x = 2^e f with f in [sqrt(1/2), sqrt(2)); series of log f = 2 atanh((f - 1)/(f + 1))
 *
 * tests/engine/test_portable_math.c measures the errors stated here. One ulp is one unit in the
 * last place. */
#ifndef TB_PORTABLE_MATH_H
#define TB_PORTABLE_MATH_H

#include <stdbool.h>
#include <stdint.h>

#include "math/arithmetic.h"

/* Within 1.5 ulp or, near a zero, 1.8e-16 for |x| <= 4e8; NaN beyond. */
double tb_sin(double x);
double tb_cos(double x);
void tb_sin_cos(double x, double *sine, double *cosine);

/* sine[i], cosine[i] of x[i], i < count, as accurate and in half the time; set-up only. */
void tb_sin_cos_array(uint32_t count, const double *restrict x, double *restrict sine,
                      double *restrict cosine);

/* Within 1 ulp; 0 below -708 and infinite above 709.78. */
double tb_exp(double x);

/* Within 2 ulp for x >= 2.3e-308; minus infinity for 0 <= x below that, NaN for x < 0. */
double tb_log(double x);

/* Within 4 ulp. Overflow gives infinity, as for tb_exp(). */
double tb_sinh(double x);
double tb_cosh(double x);
double tb_tanh(double x);

/* Cube root of x >= 0, within 2 ulp. */
double tb_cbrt(double x);

/* sqrt(x^2 + y^2) without overflow, within 2 ulp. */
double tb_hypot(double x, double y);

/* x^n, within n ulp. */
double tb_whole_power(double x, uint32_t n);

/* x^a for finite x >= 0 and 0 <= a <= 4; x = 0 gives 0 (a > 0). For the audio path. Relative error
 * below 4e-14 for x in (1e-40, 1e40). */
double tb_power(double x, double a);

/* sin and cos of an angle in degrees, |angle| <= 1e9; exact at multiples of 90. */
void tb_sin_cos_degrees(double angle, double *sine, double *cosine);

/* The direction of x, y in degrees, -180 to 180; 0 for the origin. */
double tb_arc_degrees(double y, double x);

#endif
