/* SPDX-License-Identifier: MIT */
/* Tables times vectors in the precision of simd_lanes.h. kernels_tmpl.h describes each kernel. For
 * kernels_tmpl.c alone. */
#ifndef TB_SIMD_TABLES_H
#define TB_SIMD_TABLES_H

#include "kernels/kernels.h"
#include "kernels/simd_lanes.h"

/* ---- one vector ----------------------------------------------------------------------------- */

/* Most blocks of rows at once: what fits the registers beside a table's entry. */
enum { MOST_SUMS = SINGLE ? 8 : 6 };

/* Number of blocks to take at once, of `left` and at most `most`: about equal shares, since a small
 * one is dear. */
static INLINE uint32_t share_of(uint32_t left, uint32_t most) {
  const uint32_t turns = (left + most - 1u) / most;
  return (left + turns - 1u) / turns;
}

/* `count` blocks of rows side by side, a constant at every call, by the first n of their `width`
 * columns. `rounded`: the table holds floats. */
static INLINE void multiply_blocks(bool rounded, uint32_t count, uint32_t n, uint32_t width,
                                   Real *out, const void *table, uint32_t block, const Real *x) {
  const uint64_t stride = 8u * (uint64_t)width, from = stride * block;
  const Real *matrix = table;
  const float *floats = table;
  Lanes sum[MOST_SUMS];
  UNROLL(8)
  for (uint32_t b = 0; b < count; b++) sum[b] = zero();
  UNROLL(2)
  for (uint32_t i = 0; i < n; i++) {
    const uint64_t at = from + 8u * (uint64_t)i;
    UNROLL(8)
    for (uint32_t b = 0; b < count; b++) {
      const Lanes m =
        rounded ? load_float(floats + at + b * stride) : load(matrix + at + b * stride);
      sum[b] = add(sum[b], scale(m, x[i]));
    }
  }
  UNROLL(8)
  for (uint32_t b = 0; b < count; b++) store(out + 8 * (block + b), sum[b]);
}

static INLINE void multiply_all(bool rounded, uint32_t from, uint32_t blocks, uint32_t n,
                                uint32_t width, Real *out, const void *table, const Real *x) {
  for (uint32_t b = from, take; b < blocks; b += take) {
    take = share_of(blocks - b, MOST_SUMS);
    switch (take) { /* one copy of the code for each */
    case 1: multiply_blocks(rounded, 1, n, width, out, table, b, x); break;
    case 2: multiply_blocks(rounded, 2, n, width, out, table, b, x); break;
    case 3: multiply_blocks(rounded, 3, n, width, out, table, b, x); break;
    case 4: multiply_blocks(rounded, 4, n, width, out, table, b, x); break;
    case 5: multiply_blocks(rounded, 5, n, width, out, table, b, x); break;
    case 6: multiply_blocks(rounded, 6, n, width, out, table, b, x); break;
    case 7:
      if (MOST_SUMS >= 7) multiply_blocks(rounded, 7, n, width, out, table, b, x);
      break;
    default:
      if (MOST_SUMS >= 8) multiply_blocks(rounded, 8, n, width, out, table, b, x);
      break;
    }
  }
}

static void gemv(uint32_t blocks, uint32_t n, Real *out, const Real *matrix, const Real *x) {
  multiply_all(false, 0, blocks, n, n, out, matrix, x);
}

/* ---- one or two vectors --------------------------------------------------------------------- */

typedef TYPE_OF(TbGather) Gather;

/* Most sums at once, blocks of rows times vectors: what fits the registers of every instruction set
 * beside a table's entry. In single precision a row has several partial sums where there are few
 * sums, so that an addition seldom waits for the one before, and a turn of the loop takes several
 * columns. In double each row has one sum, in ascending order. */
enum { GATHER_SUMS = SINGLE ? 6 : 4, GATHER_COLUMNS = SINGLE ? 4 : 1 };

static INLINE uint32_t ways_of(uint32_t sums) {
  if (!SINGLE || sums >= 4) return 1;
  return sums == 1 ? 4 : 2;
}

static INLINE Lanes entry(bool rounded, const Gather *g, uint64_t at) {
#ifndef TB_FLOAT
  if (rounded) return load_float(g->rounded + at);
#endif
  (void)rounded;
  return load(g->matrix + at);
}

/* `count` blocks side by side for each vector. `rounded`, `vectors` and `count` are constants at
 * every call. */
static INLINE void gather_blocks(bool rounded, uint32_t vectors, uint32_t count, const Gather *g,
                                 uint32_t block) {
  const uint64_t stride = 8u * (uint64_t)g->n, from = stride * block;
  const uint32_t ways = ways_of(vectors * count);
  Lanes sum[4][GATHER_SUMS];
  for (uint32_t w = 0; w < ways; w++) {
    UNROLL(6)
    for (uint32_t s = 0; s < vectors * count; s++) sum[w][s] = zero();
  }
  for (uint64_t i = 0; i < g->part; i += GATHER_COLUMNS) {
    UNROLL(4)
    for (uint32_t c = 0; c < GATHER_COLUMNS; c++) {
      UNROLL(6)
      for (uint32_t b = 0; b < count; b++) {
        const Lanes m = entry(rounded, g, from + b * stride + 8u * (i + c));
        UNROLL(2)
        for (uint32_t v = 0; v < vectors; v++) {
          Lanes *to = &sum[c % ways][v * count + b];
          *to = add(*to, scale(m, g->x[v][i + c]));
        }
      }
    }
  }
  UNROLL(6)
  for (uint32_t s = 0; s < vectors * count; s++) {
    if (ways == 4) sum[1][s] = add(sum[1][s], sum[3][s]);
    if (ways == 4) sum[0][s] = add(sum[0][s], sum[2][s]);
    if (ways >= 2) sum[0][s] = add(sum[0][s], sum[1][s]);
    store_double(g->out[s / count] + 8 * (block + s % count), sum[0][s]);
  }
}

static INLINE void gather_all(bool rounded, uint32_t vectors, const Gather *g) {
  const uint32_t most = SINGLE ? GATHER_SUMS / vectors : 2;
  for (uint32_t b = 0, take; b < g->blocks; b += take) {
    take = share_of(g->blocks - b, most);
    switch (take) { /* one copy of the code for each */
    case 1: gather_blocks(rounded, vectors, 1, g, b); break;
    case 2: gather_blocks(rounded, vectors, 2, g, b); break;
    case 3:
      if (most >= 3) gather_blocks(rounded, vectors, 3, g, b);
      break;
    case 4:
      if (most >= 4) gather_blocks(rounded, vectors, 4, g, b);
      break;
    case 5:
      if (most >= 5) gather_blocks(rounded, vectors, 5, g, b);
      break;
    default:
      if (most >= 6) gather_blocks(rounded, vectors, 6, g, b);
      break;
    }
  }
}

static Real rest_of(const Gather *g, uint32_t row, const Real *x) {
  const Real *column = g->transposed + 8u * row;
  Lanes sum = zero();
  for (uint64_t i = 0; i < g->part; i += 8, column += 8u * g->stride) {
    sum = add(sum, multiply_lanes(load(column), load(x + i)));
  }
  return join(sum);
}

static void gemm(const Gather *g) {
  if (g->vectors == 2) {
    gather_all(false, 2, g);
  } else {
    gather_all(false, 1, g);
  }
  for (uint32_t row = 0; row < g->rest; row++) {
    for (uint32_t v = 0; v < g->vectors; v++) {
      g->out[v][8u * g->blocks + row] = (double)rest_of(g, row, g->x[v]);
    }
  }
}

/* ---- modes that mix -------------------------------------------------------------------------- */

/* So many modes move at most: those behind rest. */
static INLINE uint32_t up_to_rest(const TbMixingBlock *block, const TbParts *moving) {
  uint32_t n = block->count;
  while (n > 0 && block->mode[n - 1u] >= moving->end[block->part[n - 1u]]) n--;
  return n;
}

/* Copies that nothing has struck are exactly zero. */
static INLINE uint32_t up_to_zeros(uint32_t n, const Real *x) {
  while (n > 0 && x[n - 1u] == REAL(0.0)) n--;
  return n;
}

static void mix(const TbMixing *mixing, const TbParts *moving, const double *q,
                double *const out[TB_COUPLINGS]) {
  _Alignas(64) Real x[TB_MIXING_MOST], y[2 * TB_MIXING_MOST];
  for (uint32_t b = 0; b < mixing->count; b++) {
    const TbMixingBlock block = mixing->block[b];
    const uint32_t n = up_to_rest(&block, moving);
    if (n == 0) continue;
    const void *table = SINGLE ? (const void *)block.rounded : block.matrix;
    UNROLL(8)
    for (uint64_t i = 0; i < n; i++) x[i] = (Real)q[block.mode[i]];
    const uint32_t columns = up_to_zeros(n, x);
    uint32_t done = 0; /* blocks of rows */
    for (uint32_t h = 0; h < mixing->heads; h++) {
      const uint32_t first = h * block.count, from = first / 8u, end = (first + n + 7u) / 8u;
      multiply_all(false, from > done ? from : done, end, columns, block.count, y, table, x);
      done = end;
      double *const to = out[h];
      UNROLL(8)
      for (uint64_t i = 0; i < n; i++) to[block.mode[i]] = (double)y[first + i];
    }
  }
}

#ifndef TB_FLOAT
static void gemv_rounded(uint32_t blocks, uint32_t n, double *out, const float *matrix,
                         const double *x) {
  multiply_all(true, 0, blocks, n, n, out, matrix, x);
}

static void gemm_rounded(const TbGather *g) {
  if (g->vectors == 2) {
    gather_all(true, 2, g);
  } else {
    gather_all(true, 1, g);
  }
}
#endif

#endif
