/* SPDX-License-Identifier: MIT */
/**
 * @file float_mode.h
 * A floating-point mode of a host's own, which a plugin has to leave as it is: it rounds up, and
 * flushes denormals. To be included after cmocka.h.
 */
#ifndef TABOR_TESTS_FLOAT_MODE_H
#define TABOR_TESTS_FLOAT_MODE_H

#include <fenv.h>

#if defined(__x86_64__)
#  include <xmmintrin.h>
#  define FLOAT_MODE_FLUSH 0x8040u
#endif

static inline void float_mode_set(void) {
  (void)fesetround(FE_UPWARD);
#if defined(__x86_64__)
  _mm_setcsr(_mm_getcsr() | FLOAT_MODE_FLUSH);
#endif
}

static inline void float_mode_check(void) {
  assert_int_equal(fegetround(), FE_UPWARD);
#if defined(__x86_64__)
  assert_int_equal(_mm_getcsr() & FLOAT_MODE_FLUSH, FLOAT_MODE_FLUSH);
#endif
}

static inline void float_mode_reset(void) {
  (void)fesetround(FE_TONEAREST);
#if defined(__x86_64__)
  _mm_setcsr(_mm_getcsr() & ~FLOAT_MODE_FLUSH);
#endif
}

#endif
