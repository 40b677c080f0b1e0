/* SPDX-License-Identifier: MIT */
/* The number type of a template (a source *_tmpl.c, or a header included by one): double, or float
 * if TB_FLOAT is defined. Names that exist for both types have no suffix for double. For float,
 * types end in F, and functions and tables end in f, as sqrt and sqrtf do. */
#ifndef TB_REAL_H
#define TB_REAL_H

#include <math.h>

#include "math/arithmetic.h"

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
