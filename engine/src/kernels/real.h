/* SPDX-License-Identifier: MIT */
/* The type of numbers of a template (a source *_tmpl.c, or a header that one includes): double, or float where
 * TB_FLOAT is defined. What there is of both has a name without suffix for double and ends in F, or f if it is a
 * function or a table, for float, as sqrt and sqrtf do. */
#ifndef TB_REAL_H
#define TB_REAL_H

#include <math.h>

#ifdef TB_FLOAT
typedef float Real;
enum { SINGLE = 1 };
#  define REAL_SIZE(x) fabsf(x)
#  define TYPE_OF(name) name##F
#  define NAME_OF(name) name##f
#else
typedef double Real;
enum { SINGLE = 0 };
#  define REAL_SIZE(x) fabs(x)
#  define TYPE_OF(name) name
#  define NAME_OF(name) name
#endif
#define REAL(value) ((Real)(value))

#endif
