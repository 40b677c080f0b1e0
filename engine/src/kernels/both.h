/* SPDX-License-Identifier: MIT */
/* Includes the header TB_TEMPLATE twice: for double and for float. The template sees TB_REAL, the
 * number type; TB_TYPE(name) and TB_NAME(name), the names of types and functions (real.h); and
 * TB_REAL_IS_FLOAT, 0 or 1. No include guard. */
#define TB_REAL double
#define TB_TYPE(name) name
#define TB_NAME(name) name
#define TB_REAL_IS_FLOAT 0
#include TB_TEMPLATE
#undef TB_REAL
#undef TB_TYPE
#undef TB_NAME
#undef TB_REAL_IS_FLOAT

#define TB_REAL float
#define TB_TYPE(name) name##F
#define TB_NAME(name) name##f
#define TB_REAL_IS_FLOAT 1
#include TB_TEMPLATE
#undef TB_REAL
#undef TB_TYPE
#undef TB_NAME
#undef TB_REAL_IS_FLOAT
#undef TB_TEMPLATE
