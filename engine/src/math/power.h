/* SPDX-License-Identifier: MIT */
/* x^a without libm, for the audio path: the same bits on every machine.
 *
 * x = 2^e f with f in [sqrt(1/2), sqrt(2)); log f = 2 atanh((f-1)/(f+1)) by its series, exp by
 * splitting off whole powers of two and Taylor's series. Relative error below 4e-14 for x in
 * (1e-40, 1e40) and 0 <= a <= 4, measured in tests/test_power.c. */
#ifndef TB_POWER_H
#define TB_POWER_H

#include <stdbool.h>
#include <stdint.h>

/* x^a for finite x >= 0, 0 <= a <= 4. x = 0 gives 0 (a > 0). */
double tb_power(double x, double a);

/* sin and cos of an angle in degrees, |angle| <= 1e9; exact at multiples of 90. */
void tb_sin_cos_degrees(double angle, double *sine, double *cosine);

/* The direction of x, y in degrees, -180 to 180; 0 for the origin. */
double tb_arc_degrees(double y, double x);

#endif
