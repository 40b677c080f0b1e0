/* SPDX-License-Identifier: MIT */
/* The floating-point mode of the audio path: round to nearest, no traps, denormals flushed to zero.
 * Without this mode a decaying tail would run a hundred times slower, and the host's mode would
 * change the sound. */
#ifndef TB_FLUSH_DENORMALS_H
#define TB_FLUSH_DENORMALS_H

#include <stdint.h>

#if defined(__SSE2__)
#  include <xmmintrin.h>
typedef unsigned TbFpMode;
static inline TbFpMode tb_fp_enter(void) {
  const TbFpMode mode = _mm_getcsr();
  _mm_setcsr(0x9FC0u); /* flush to zero, denormals are zero, all exceptions masked */
  return mode;
}
static inline void tb_fp_leave(TbFpMode mode) { _mm_setcsr(mode); }
#elif defined(__aarch64__)
typedef uint64_t TbFpMode;
static inline TbFpMode tb_fp_enter(void) {
  TbFpMode mode;
  __asm__ volatile("mrs %0, fpcr" : "=r"(mode));
  __asm__ volatile("msr fpcr, %0" : : "r"((uint64_t)1 << 24));
  return mode;
}
static inline void tb_fp_leave(TbFpMode mode) { __asm__ volatile("msr fpcr, %0" : : "r"(mode)); }
#else
typedef int TbFpMode;
static inline TbFpMode tb_fp_enter(void) { return 0; }
static inline void tb_fp_leave(TbFpMode mode) { (void)mode; }
#endif

#endif
