/* SPDX-License-Identifier: MIT */
/* Eight doubles in as many registers as the instruction set has for them, for kernels.c alone.
 *
 * Arithmetic is the compiler's own on vectors. Only what it finds no single instruction for by itself is
 * named here: for x86 comparing, choosing, largest and smallest, roots, widening; for aarch64 widening alone.
 * Everywhere else these are loops over lanes with the same results to the bit. */
#ifndef TB_LANES_H
#define TB_LANES_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

#if defined(__x86_64__)
#  include <immintrin.h>
#elif defined(__aarch64__)
#  include <arm_neon.h>
#endif

#if defined(__AVX512F__)
#  define WIDTH 8
#elif defined(__AVX2__)
#  define WIDTH 4
#else
#  define WIDTH 2
#endif
#define PARTS (8 / WIDTH)
/* Lanes live in registers only where no call stands between. */
#define INLINE inline __attribute__((always_inline))

typedef double Vector __attribute__((vector_size(8 * WIDTH), may_alias));
typedef double Unaligned __attribute__((vector_size(8 * WIDTH), may_alias, aligned(8)));

typedef struct Lanes {
  Vector part[PARTS];
} Lanes;

/* ---- one register --------------------------------------------------------------------------- */

#if WIDTH == 8
typedef __mmask8 Bits;
static INLINE Vector vector_widen(const float *p) { return _mm512_cvtps_pd(_mm256_load_ps(p)); }
static INLINE Vector vector_larger(Vector x, Vector y) { return _mm512_max_pd(x, y); }
static INLINE Vector vector_smaller(Vector x, Vector y) { return _mm512_min_pd(x, y); }
static INLINE Vector vector_root(Vector x) { return _mm512_sqrt_pd(x); }
static INLINE Bits vector_greater(Vector x, Vector y) {
  return _mm512_cmp_pd_mask(x, y, _CMP_GT_OQ);
}
static INLINE Vector vector_pick(Bits m, Vector x, Vector y) {
  return _mm512_mask_blend_pd(m, y, x);
}
static INLINE bool vector_any(Bits m) { return m != 0; }
#else
typedef int64_t Bits __attribute__((vector_size(8 * WIDTH)));
static INLINE Bits vector_greater(Vector x, Vector y) { return x > y; }
static INLINE Vector vector_pick(Bits m, Vector x, Vector y) {
  return (Vector)((m & (Bits)x) | (~m & (Bits)y));
}
#  if WIDTH == 4
static INLINE Vector vector_widen(const float *p) { return _mm256_cvtps_pd(_mm_load_ps(p)); }
static INLINE Vector vector_larger(Vector x, Vector y) { return _mm256_max_pd(x, y); }
static INLINE Vector vector_smaller(Vector x, Vector y) { return _mm256_min_pd(x, y); }
static INLINE Vector vector_root(Vector x) { return _mm256_sqrt_pd(x); }
static INLINE bool vector_any(Bits m) { return _mm256_movemask_pd((__m256d)m) != 0; }
#  elif defined(__SSE2__)
static INLINE Vector vector_widen(const float *p) {
  return _mm_cvtps_pd(_mm_castpd_ps(_mm_load_sd((const double *)(const void *)p)));
}
static INLINE Vector vector_larger(Vector x, Vector y) { return _mm_max_pd(x, y); }
static INLINE Vector vector_smaller(Vector x, Vector y) { return _mm_min_pd(x, y); }
static INLINE Vector vector_root(Vector x) { return _mm_sqrt_pd(x); }
static INLINE bool vector_any(Bits m) { return _mm_movemask_pd((__m128d)m) != 0; }
#  else
#    if defined(__aarch64__)
static INLINE Vector vector_widen(const float *p) { return (Vector)vcvt_f64_f32(vld1_f32(p)); }
#    else
static INLINE Vector vector_widen(const float *p) { return (Vector){(double)p[0], (double)p[1]}; }
#    endif
static INLINE Vector vector_larger(Vector x, Vector y) { return vector_pick(x > y, x, y); }
static INLINE Vector vector_smaller(Vector x, Vector y) { return vector_pick(y > x, x, y); }
static INLINE Vector vector_root(Vector x) { return (Vector){sqrt(x[0]), sqrt(x[1])}; }
static INLINE bool vector_any(Bits m) { return (m[0] | m[1]) != 0; }
#  endif
#endif

/* ---- eight lanes ---------------------------------------------------------------------------- */

static INLINE Lanes load(const double *p) {
  Lanes x;
  for (int i = 0; i < PARTS; i++) x.part[i] = ((const Vector *)(const void *)p)[i];
  return x;
}

static INLINE Lanes load_single(const float *p) {
  Lanes x;
  for (int i = 0; i < PARTS; i++) x.part[i] = vector_widen(p + i * WIDTH);
  return x;
}

static INLINE Lanes load_unaligned(const double *p) {
  Lanes x;
  for (int i = 0; i < PARTS; i++) x.part[i] = ((const Unaligned *)(const void *)p)[i];
  return x;
}

static INLINE void store(double *p, Lanes x) {
  for (int i = 0; i < PARTS; i++) ((Vector *)(void *)p)[i] = x.part[i];
}

static INLINE void store_unaligned(double *p, Lanes x) {
  for (int i = 0; i < PARTS; i++) ((Unaligned *)(void *)p)[i] = x.part[i];
}

static INLINE Lanes zero(void) {
  Lanes x;
  for (int i = 0; i < PARTS; i++) x.part[i] = (Vector){0.0};
  return x;
}

static INLINE Lanes all(double value) {
  Lanes x = zero();
  for (int i = 0; i < PARTS; i++) x.part[i] += value;
  return x;
}

static INLINE Lanes add(Lanes x, Lanes y) {
  for (int i = 0; i < PARTS; i++) x.part[i] += y.part[i];
  return x;
}

static INLINE Lanes subtract(Lanes x, Lanes y) {
  for (int i = 0; i < PARTS; i++) x.part[i] -= y.part[i];
  return x;
}

static INLINE Lanes multiply_lanes(Lanes x, Lanes y) {
  for (int i = 0; i < PARTS; i++) x.part[i] *= y.part[i];
  return x;
}

static INLINE Lanes scale(Lanes x, double factor) {
  for (int i = 0; i < PARTS; i++) x.part[i] *= factor;
  return x;
}

static INLINE Lanes divide(Lanes x, Lanes y) {
  for (int i = 0; i < PARTS; i++) x.part[i] /= y.part[i];
  return x;
}

static INLINE Lanes root(Lanes x) {
  for (int i = 0; i < PARTS; i++) x.part[i] = vector_root(x.part[i]);
  return x;
}

/* x > y ? x : y, and x < y ? x : y */
static INLINE Lanes larger(Lanes x, Lanes y) {
  for (int i = 0; i < PARTS; i++) x.part[i] = vector_larger(x.part[i], y.part[i]);
  return x;
}

static INLINE Lanes smaller(Lanes x, Lanes y) {
  for (int i = 0; i < PARTS; i++) x.part[i] = vector_smaller(x.part[i], y.part[i]);
  return x;
}

static INLINE Lanes size_of(Lanes x) { return larger(x, subtract(zero(), x)); }

typedef struct Mask {
  Bits part[PARTS];
} Mask;

static INLINE Mask greater(Lanes x, Lanes y) {
  Mask m;
  for (int i = 0; i < PARTS; i++) m.part[i] = vector_greater(x.part[i], y.part[i]);
  return m;
}

static INLINE Mask either(Mask a, Mask b) {
  for (int i = 0; i < PARTS; i++) a.part[i] |= b.part[i];
  return a;
}

static INLINE bool any(Mask m) {
  Bits bits = m.part[0];
  for (int i = 1; i < PARTS; i++) bits |= m.part[i];
  return vector_any(bits);
}

static INLINE Lanes pick(Mask m, Lanes x, Lanes y) {
  for (int i = 0; i < PARTS; i++) x.part[i] = vector_pick(m.part[i], x.part[i], y.part[i]);
  return x;
}

/* ---- one number from eight ------------------------------------------------------------------ */

static INLINE double join(Lanes x) {
  double s[8] __attribute__((aligned(64)));
  store(s, x);
  return ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]));
}

/* The largest, or 0. */
static INLINE double largest_of(Lanes x) {
  double s[8] __attribute__((aligned(64))), most = 0.0;
  store(s, x);
  for (int i = 0; i < 8; i++) most = s[i] > most ? s[i] : most;
  return most;
}

#endif
