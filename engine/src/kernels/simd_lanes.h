/* SPDX-License-Identifier: MIT */
/* Eight SIMD lanes in as many registers as the instruction set needs for them: doubles, or floats
 * with TB_FLOAT defined. For kernels_tmpl.c alone.
 *
 * Arithmetic uses the compiler's own vector operations. Intrinsics are used only where the compiler
 * finds no single instruction: on x86 and for WebAssembly for comparison, selection, largest and
 * smallest, roots and change of precision; on aarch64 for change of precision alone. On other
 * processors these operations are loops over lanes, with the same results to the bit. */
#ifndef TB_SIMD_LANES_H
#define TB_SIMD_LANES_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

#include "kernels/real.h"

#if defined(__SSE2__)
#  include <immintrin.h>
#elif defined(__aarch64__)
#  include <arm_neon.h>
#elif defined(__wasm_simd128__)
#  include <wasm_simd128.h>
#endif

#ifdef TB_FLOAT
typedef int32_t Whole;
#  if defined(__AVX2__)
#    define WIDTH 8
#  else
#    define WIDTH 4
#  endif
#else
typedef int64_t Whole;
#  if defined(__AVX512F__)
#    define WIDTH 8
#  elif defined(__AVX2__)
#    define WIDTH 4
#  else
#    define WIDTH 2
#  endif
#endif
#define PARTS (8 / WIDTH)
/* Lanes stay in registers only between calls, so every function is inlined. */
#define INLINE inline __attribute__((always_inline))
/* Before a loop over sums, or gcc would keep these in memory. clang would do so with it: it unrolls
 * such loops by itself, and a loop that it is asked to unroll too late. */
#ifdef __clang__
#  define UNROLL(count)
#else
#  define UNROLL(count) UNROLL_AS(GCC unroll count)
#  define UNROLL_AS(words) _Pragma(#  words)
#endif

typedef Real Vector __attribute__((vector_size(WIDTH * sizeof(Real)), may_alias));
typedef Real Unaligned
  __attribute__((vector_size(WIDTH * sizeof(Real)), may_alias, aligned(sizeof(Real))));

typedef struct Lanes {
  Vector part[PARTS];
} Lanes;

/* ---- one register --------------------------------------------------------------------------- */

#if !defined(TB_FLOAT) && WIDTH == 8
typedef __mmask8 Bits;
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
typedef Whole Bits __attribute__((vector_size(WIDTH * sizeof(Whole))));
static INLINE Bits vector_greater(Vector x, Vector y) { return x > y; }
static INLINE Vector vector_pick(Bits m, Vector x, Vector y) {
  return (Vector)((m & (Bits)x) | (~m & (Bits)y));
}
#  if defined(TB_FLOAT) && WIDTH == 8
static INLINE Vector vector_larger(Vector x, Vector y) { return _mm256_max_ps(x, y); }
static INLINE Vector vector_smaller(Vector x, Vector y) { return _mm256_min_ps(x, y); }
static INLINE Vector vector_root(Vector x) { return _mm256_sqrt_ps(x); }
static INLINE bool vector_any(Bits m) { return _mm256_movemask_ps((__m256)m) != 0; }
#  elif defined(TB_FLOAT) && defined(__SSE2__)
static INLINE Vector vector_larger(Vector x, Vector y) { return _mm_max_ps(x, y); }
static INLINE Vector vector_smaller(Vector x, Vector y) { return _mm_min_ps(x, y); }
static INLINE Vector vector_root(Vector x) { return _mm_sqrt_ps(x); }
static INLINE bool vector_any(Bits m) { return _mm_movemask_ps((__m128)m) != 0; }
#  elif WIDTH == 4 && !defined(TB_FLOAT)
static INLINE Vector vector_larger(Vector x, Vector y) { return _mm256_max_pd(x, y); }
static INLINE Vector vector_smaller(Vector x, Vector y) { return _mm256_min_pd(x, y); }
static INLINE Vector vector_root(Vector x) { return _mm256_sqrt_pd(x); }
static INLINE bool vector_any(Bits m) { return _mm256_movemask_pd((__m256d)m) != 0; }
#  elif defined(__SSE2__)
static INLINE Vector vector_larger(Vector x, Vector y) { return _mm_max_pd(x, y); }
static INLINE Vector vector_smaller(Vector x, Vector y) { return _mm_min_pd(x, y); }
static INLINE Vector vector_root(Vector x) { return _mm_sqrt_pd(x); }
static INLINE bool vector_any(Bits m) { return _mm_movemask_pd((__m128d)m) != 0; }
#  elif defined(__wasm_simd128__)
#    ifdef TB_FLOAT
#      define OF_LANES(operation) wasm_f32x4_##operation
#    else
#      define OF_LANES(operation) wasm_f64x2_##operation
#    endif
/* pmax(x, y) is x < y ? y : x, and pmin(x, y) is y < x ? y : x. */
static INLINE Vector vector_larger(Vector x, Vector y) { return (Vector)OF_LANES(pmax)(y, x); }
static INLINE Vector vector_smaller(Vector x, Vector y) { return (Vector)OF_LANES(pmin)(y, x); }
static INLINE Vector vector_root(Vector x) { return (Vector)OF_LANES(sqrt)(x); }
static INLINE bool vector_any(Bits m) { return wasm_v128_any_true(m); }
#  else
static INLINE Vector vector_larger(Vector x, Vector y) { return vector_pick(x > y, x, y); }
static INLINE Vector vector_smaller(Vector x, Vector y) { return vector_pick(y > x, x, y); }
static INLINE Vector vector_root(Vector x) {
  for (int i = 0; i < WIDTH; i++) x[i] = REAL(sqrt(x[i]));
  return x;
}
static INLINE bool vector_any(Bits m) {
  Whole bits = 0;
  for (int i = 0; i < WIDTH; i++) bits |= m[i];
  return bits != 0;
}
#  endif
#endif

/* Lanes in reverse order. */
#if WIDTH == 8
#  define BACKWARDS 7, 6, 5, 4, 3, 2, 1, 0
#elif WIDTH == 4
#  define BACKWARDS 3, 2, 1, 0
#else
#  define BACKWARDS 1, 0
#endif
#ifdef __clang__
static INLINE Vector vector_reverse(Vector x) { return __builtin_shufflevector(x, x, BACKWARDS); }
#else
typedef Whole Order __attribute__((vector_size(WIDTH * sizeof(Whole))));
static INLINE Vector vector_reverse(Vector x) { return __builtin_shuffle(x, (Order){BACKWARDS}); }
#endif

/* Conversion from the other precision, and back. */
#ifdef TB_FLOAT
#  if WIDTH == 8
static INLINE Vector vector_narrow(const double *p) {
  return _mm256_set_m128(_mm256_cvtpd_ps(_mm256_load_pd(p + 4)),
                         _mm256_cvtpd_ps(_mm256_load_pd(p)));
}
static INLINE Vector vector_narrow_change(const double *p, const double *q) {
  return _mm256_set_m128(
    _mm256_cvtpd_ps(_mm256_sub_pd(_mm256_load_pd(p + 4), _mm256_load_pd(q + 4))),
    _mm256_cvtpd_ps(_mm256_sub_pd(_mm256_load_pd(p), _mm256_load_pd(q))));
}
static INLINE void vector_widen(Vector x, double *p) {
  _mm256_store_pd(p, _mm256_cvtps_pd(_mm256_castps256_ps128(x)));
  _mm256_store_pd(p + 4, _mm256_cvtps_pd(_mm256_extractf128_ps(x, 1)));
}
static INLINE void vector_add_wide(Vector x, double *p) {
  const __m256d low = _mm256_cvtps_pd(_mm256_castps256_ps128(x));
  const __m256d high = _mm256_cvtps_pd(_mm256_extractf128_ps(x, 1));
  _mm256_store_pd(p, _mm256_add_pd(_mm256_load_pd(p), low));
  _mm256_store_pd(p + 4, _mm256_add_pd(_mm256_load_pd(p + 4), high));
}
#  elif defined(__SSE2__)
static INLINE Vector vector_narrow(const double *p) {
  return _mm_movelh_ps(_mm_cvtpd_ps(_mm_load_pd(p)), _mm_cvtpd_ps(_mm_load_pd(p + 2)));
}
static INLINE Vector vector_narrow_change(const double *p, const double *q) {
  return _mm_movelh_ps(_mm_cvtpd_ps(_mm_sub_pd(_mm_load_pd(p), _mm_load_pd(q))),
                       _mm_cvtpd_ps(_mm_sub_pd(_mm_load_pd(p + 2), _mm_load_pd(q + 2))));
}
static INLINE void vector_widen(Vector x, double *p) {
  _mm_store_pd(p, _mm_cvtps_pd(x));
  _mm_store_pd(p + 2, _mm_cvtps_pd(_mm_movehl_ps(x, x)));
}
static INLINE void vector_add_wide(Vector x, double *p) {
  _mm_store_pd(p, _mm_add_pd(_mm_load_pd(p), _mm_cvtps_pd(x)));
  _mm_store_pd(p + 2, _mm_add_pd(_mm_load_pd(p + 2), _mm_cvtps_pd(_mm_movehl_ps(x, x))));
}
#  elif defined(__wasm_simd128__)
static INLINE Vector vector_from_pairs(v128_t low, v128_t high) {
  return (Vector)wasm_i64x2_shuffle(wasm_f32x4_demote_f64x2_zero(low),
                                    wasm_f32x4_demote_f64x2_zero(high), 0, 2);
}
static INLINE v128_t low_pair(Vector x) { return wasm_f64x2_promote_low_f32x4(x); }
static INLINE v128_t high_pair(Vector x) {
  return wasm_f64x2_promote_low_f32x4(wasm_i64x2_shuffle(x, x, 1, 1));
}
static INLINE Vector vector_narrow(const double *p) {
  return vector_from_pairs(wasm_v128_load(p), wasm_v128_load(p + 2));
}
static INLINE Vector vector_narrow_change(const double *p, const double *q) {
  return vector_from_pairs(wasm_f64x2_sub(wasm_v128_load(p), wasm_v128_load(q)),
                           wasm_f64x2_sub(wasm_v128_load(p + 2), wasm_v128_load(q + 2)));
}
static INLINE void vector_widen(Vector x, double *p) {
  wasm_v128_store(p, low_pair(x));
  wasm_v128_store(p + 2, high_pair(x));
}
static INLINE void vector_add_wide(Vector x, double *p) {
  wasm_v128_store(p, wasm_f64x2_add(wasm_v128_load(p), low_pair(x)));
  wasm_v128_store(p + 2, wasm_f64x2_add(wasm_v128_load(p + 2), high_pair(x)));
}
#  else
static INLINE Vector vector_narrow(const double *p) {
  return (Vector){(float)p[0], (float)p[1], (float)p[2], (float)p[3]};
}
static INLINE Vector vector_narrow_change(const double *p, const double *q) {
  return (Vector){(float)(p[0] - q[0]), (float)(p[1] - q[1]), (float)(p[2] - q[2]),
                  (float)(p[3] - q[3])};
}
static INLINE void vector_widen(Vector x, double *p) {
  for (int i = 0; i < 4; i++) p[i] = (double)x[i];
}
static INLINE void vector_add_wide(Vector x, double *p) {
  for (int i = 0; i < 4; i++) p[i] += (double)x[i];
}
#  endif
#elif WIDTH == 8
static INLINE Vector vector_widen(const float *p) { return _mm512_cvtps_pd(_mm256_load_ps(p)); }
#elif WIDTH == 4
static INLINE Vector vector_widen(const float *p) { return _mm256_cvtps_pd(_mm_load_ps(p)); }
#elif defined(__SSE2__)
static INLINE Vector vector_widen(const float *p) {
  return _mm_cvtps_pd(_mm_castpd_ps(_mm_load_sd((const double *)(const void *)p)));
}
#elif defined(__aarch64__)
static INLINE Vector vector_widen(const float *p) { return (Vector)vcvt_f64_f32(vld1_f32(p)); }
#elif defined(__wasm_simd128__)
static INLINE Vector vector_widen(const float *p) {
  return (Vector)wasm_f64x2_promote_low_f32x4(wasm_v128_load64_zero(p));
}
#else
static INLINE Vector vector_widen(const float *p) { return (Vector){(double)p[0], (double)p[1]}; }
#endif

/* ---- eight lanes ---------------------------------------------------------------------------- */

static INLINE Lanes load(const Real *p) {
  Lanes x;
  for (int i = 0; i < PARTS; i++) x.part[i] = ((const Vector *)(const void *)p)[i];
  return x;
}

#ifdef TB_FLOAT
static INLINE Lanes load_double(const double *p) {
  Lanes x;
  for (int i = 0; i < PARTS; i++) x.part[i] = vector_narrow(p + i * WIDTH);
  return x;
}

/* p - q, computed in double and then rounded. */
static INLINE Lanes load_change(const double *p, const double *q) {
  Lanes x;
  for (int i = 0; i < PARTS; i++) {
    x.part[i] = vector_narrow_change(p + i * WIDTH, q + i * WIDTH);
  }
  return x;
}

static INLINE void store_double(double *p, Lanes x) {
  for (int i = 0; i < PARTS; i++) vector_widen(x.part[i], p + i * WIDTH);
}

static INLINE void add_double(double *p, Lanes x) {
  for (int i = 0; i < PARTS; i++) vector_add_wide(x.part[i], p + i * WIDTH);
}

static INLINE Lanes load_float(const float *p) { return load(p); }
#else
static INLINE Lanes load_float(const float *p) {
  Lanes x;
  for (int i = 0; i < PARTS; i++) x.part[i] = vector_widen(p + i * WIDTH);
  return x;
}
#endif

static INLINE Lanes load_unaligned(const Real *p) {
  Lanes x;
  for (int i = 0; i < PARTS; i++) x.part[i] = ((const Unaligned *)(const void *)p)[i];
  return x;
}

static INLINE void store(Real *p, Lanes x) {
  for (int i = 0; i < PARTS; i++) ((Vector *)(void *)p)[i] = x.part[i];
}

static INLINE void store_unaligned(Real *p, Lanes x) {
  for (int i = 0; i < PARTS; i++) ((Unaligned *)(void *)p)[i] = x.part[i];
}

static INLINE Lanes reverse(Lanes x) {
  Lanes y;
  for (int i = 0; i < PARTS; i++) y.part[i] = vector_reverse(x.part[PARTS - 1 - i]);
  return y;
}

static INLINE Lanes zero(void) {
  Lanes x;
  for (int i = 0; i < PARTS; i++) x.part[i] = (Vector){0};
  return x;
}

static INLINE Lanes all(Real value) {
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

static INLINE Lanes scale(Lanes x, Real factor) {
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

static INLINE Lanes pick(Mask m, Lanes x, Lanes y) {
  for (int i = 0; i < PARTS; i++) x.part[i] = vector_pick(m.part[i], x.part[i], y.part[i]);
  return x;
}

static INLINE bool any(Mask m) {
  bool found = false;
  for (int i = 0; i < PARTS; i++) found = found || vector_any(m.part[i]);
  return found;
}

/* In double these are the plain loads and stores. */
#ifndef TB_FLOAT
static INLINE Lanes load_double(const double *p) { return load(p); }
static INLINE Lanes load_change(const double *p, const double *q) {
  return subtract(load(p), load(q));
}
static INLINE void store_double(double *p, Lanes x) { store(p, x); }
#endif

/* ---- one number from eight ------------------------------------------------------------------ */

/* join() adds ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7])); largest_of() gives
 * the largest lane, or 0 if all are negative. */
#if defined(__wasm_simd128__)
/* Two lanes: the upper half of a register of floats is joined with the lower one. */
static INLINE Vector upper_half(Vector x) { return (Vector)wasm_i64x2_shuffle(x, x, 1, 1); }

static INLINE Real join(Lanes x) {
#  ifdef TB_FLOAT
  const Vector half = x.part[0] + x.part[1], sum = half + upper_half(half);
#  else
  const Vector sum = (x.part[0] + x.part[2]) + (x.part[1] + x.part[3]);
#  endif
  return sum[0] + sum[1];
}

static INLINE Real largest_of(Lanes x) {
  Vector most = (Vector){0};
  for (int i = 0; i < PARTS; i++) most = vector_larger(x.part[i], most);
  if (SINGLE) most = vector_larger(upper_half(most), most);
  return most[1] > most[0] ? most[1] : most[0];
}
#else
static INLINE Real join(Lanes x) {
  Real s[8] __attribute__((aligned(64)));
  store(s, x);
  return ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]));
}

static INLINE Real largest_of(Lanes x) {
  Real s[8] __attribute__((aligned(64))), most = 0;
  store(s, x);
  for (int i = 0; i < 8; i++) most = s[i] > most ? s[i] : most;
  return most;
}

#endif

#endif
