/* SPDX-License-Identifier: MIT */
/* Compiled once per instruction set, with TB_KERNELS naming the table it fills. */
#include "kernels.h"

/* Eight lanes in as many registers as the instruction set needs for them. */
#if defined(__AVX2__)
#  define WIDTH 4
#else
#  define WIDTH 2
#endif
#define PARTS (8 / WIDTH)

typedef double Vector __attribute__((vector_size(8 * WIDTH), may_alias));

typedef struct Lanes {
  Vector part[PARTS];
} Lanes;

static inline Lanes load(const double *p) {
  Lanes x;
  for (int i = 0; i < PARTS; i++) x.part[i] = ((const Vector *)(const void *)p)[i];
  return x;
}

static inline void store(double *p, Lanes x) {
  for (int i = 0; i < PARTS; i++) ((Vector *)(void *)p)[i] = x.part[i];
}

static inline Lanes zero(void) {
  Lanes x;
  for (int i = 0; i < PARTS; i++) x.part[i] = (Vector){0.0};
  return x;
}

static inline Lanes add(Lanes x, Lanes y) {
  for (int i = 0; i < PARTS; i++) x.part[i] += y.part[i];
  return x;
}

static inline Lanes subtract(Lanes x, Lanes y) {
  for (int i = 0; i < PARTS; i++) x.part[i] -= y.part[i];
  return x;
}

static inline Lanes multiply_lanes(Lanes x, Lanes y) {
  for (int i = 0; i < PARTS; i++) x.part[i] *= y.part[i];
  return x;
}

static inline Lanes scale(Lanes x, double factor) {
  for (int i = 0; i < PARTS; i++) x.part[i] *= factor;
  return x;
}

static inline double join(Lanes x) {
  double s[8] __attribute__((aligned(64)));
  store(s, x);
  return ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]));
}

static void two_step(uint32_t n, double *out, const double *a, const double *x, const double *b,
                     const double *y) {
  for (uint32_t i = 0; i < n; i += 8) {
    store(out + i, subtract(multiply_lanes(load(a + i), load(x + i)),
                            multiply_lanes(load(b + i), load(y + i))));
  }
}

/* Four blocks side by side: enough independent sums to hide the latency of an addition. */
static void multiply_four(uint32_t n, double *out, const double *matrix, const double *x) {
  const uint64_t block = 8u * (uint64_t)n;
  Lanes s0 = zero(), s1 = zero(), s2 = zero(), s3 = zero();
  for (uint32_t i = 0; i < n; i++) {
    const double *m = matrix + 8u * (uint64_t)i;
    s0 = add(s0, scale(load(m), x[i]));
    s1 = add(s1, scale(load(m + block), x[i]));
    s2 = add(s2, scale(load(m + 2 * block), x[i]));
    s3 = add(s3, scale(load(m + 3 * block), x[i]));
  }
  store(out, s0);
  store(out + 8, s1);
  store(out + 16, s2);
  store(out + 24, s3);
}

static void multiply(uint32_t blocks, uint32_t n, double *out, const double *matrix,
                     const double *x) {
  const uint64_t block = 8u * (uint64_t)n;
  uint32_t b = 0;
  for (; b + 4 <= blocks; b += 4) multiply_four(n, out + 8 * b, matrix + b * block, x);
  for (; b < blocks; b++) {
    Lanes sum = zero();
    for (uint32_t i = 0; i < n; i++) {
      sum = add(sum, scale(load(matrix + b * block + 8u * (uint64_t)i), x[i]));
    }
    store(out + 8 * b, sum);
  }
}

static double dot(uint32_t n, const double *x, const double *y) {
  Lanes sum = zero();
  for (uint32_t i = 0; i < n; i += 8) sum = add(sum, multiply_lanes(load(x + i), load(y + i)));
  return join(sum);
}

static void add_scaled(uint32_t n, double *out, double f, const double *x) {
  for (uint32_t i = 0; i < n; i += 8) store(out + i, add(load(out + i), scale(load(x + i), f)));
}

static void add_product(uint32_t n, double *out, const double *x, const double *y) {
  for (uint32_t i = 0; i < n; i += 8) {
    store(out + i, add(load(out + i), multiply_lanes(load(x + i), load(y + i))));
  }
}

static double readout(uint32_t n, const double *u, const double *v, const double *next,
                      const double *now, const double *last) {
  Lanes sum = zero();
  for (uint32_t i = 0; i < n; i += 8) {
    const Lanes q2 = load(next + i), q1 = load(now + i), q0 = load(last + i);
    const Lanes bend = subtract(subtract(q2, q1), subtract(q1, q0));
    sum = add(
      sum, add(multiply_lanes(load(u + i), bend), multiply_lanes(load(v + i), subtract(q2, q0))));
  }
  return join(sum);
}

static TbPair losses(uint32_t n, const double *u, const double *v, const double *next,
                     const double *last) {
  Lanes first = zero(), second = zero();
  for (uint32_t i = 0; i < n; i += 8) {
    const Lanes step = subtract(load(next + i), load(last + i));
    const Lanes square = multiply_lanes(step, step);
    first = add(first, multiply_lanes(load(u + i), square));
    second = add(second, multiply_lanes(load(v + i), square));
  }
  return (TbPair){join(first), join(second)};
}

const TbKernels TB_KERNELS = {two_step, multiply, dot, add_scaled, add_product, readout, losses};
