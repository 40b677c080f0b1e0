/* SPDX-License-Identifier: MIT */
/* The arithmetic that the compiler and its options must give the engine; anything else is refused
 * here, in one line. Numbers that are not finite are recognised by comparison, which options that
 * assume finite numbers remove; sums and products must be rounded to their type one by one, or the
 * bits would differ from machine to machine; saved states and stored models hold numbers as a
 * little-endian machine has them; and the kernels are written in the vector types of GCC and clang,
 * as long as two doubles at least. */
#ifndef TB_ARITHMETIC_H
#define TB_ARITHMETIC_H

#include <float.h>

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__) ||           \
  defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#  error                                                                                           \
    "Tabor cannot be compiled with options for fast math: it must know NaN, and round each sum."
#elif !defined(FLT_EVAL_METHOD) || FLT_EVAL_METHOD != 0
#  error "Tabor needs FLT_EVAL_METHOD 0: on 32-bit x86 compile with -msse2 -mfpmath=sse."
#elif !defined(__BYTE_ORDER__) || __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__
#  error "Tabor needs a little-endian target."
#elif !defined(__GNUC__)
#  error "Tabor needs a compiler with the vector types of GCC and clang."
#elif (defined(__i386__) || defined(__x86_64__)) && !defined(__SSE2__)
#  error "Tabor needs the vectors of SSE2 on x86: compile with -msse2."
#elif defined(__arm__) && !defined(__ARM_NEON)
#  error "Tabor needs the vectors of NEON on 32-bit ARM: compile with -mfpu=neon."
#endif

#endif
