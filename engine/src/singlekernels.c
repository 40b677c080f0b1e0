/* SPDX-License-Identifier: MIT */
/* Compiled once per instruction set, with TB_SINGLE_KERNELS naming the table it fills. */
#define TB_SINGLE
#include "singlekernels.h"

#include "lanes.h"
#include "lawlanes.h"
#include "ringlanes.h"
#include "singlebed.h"

/* ---- precision ------------------------------------------------------------------------------ */

static void narrow(uint32_t n, const double *x, float *out) {
  for (uint32_t i = 0; i < n; i += 8) store(out + i, load_double(x + i));
}

static void narrow_difference(uint32_t n, const double *x, const double *y, float *out) {
  double left[8] __attribute__((aligned(64)));
  for (uint32_t i = 0; i < n; i += 8) {
    for (uint32_t lane = 0; lane < 8; lane++) left[lane] = x[i + lane] - y[i + lane];
    store(out + i, load_double(left));
  }
}

static void widen(uint32_t n, const float *x, double *out) {
  for (uint32_t i = 0; i < n; i += 8) store_double(out + i, load(x + i));
}

/* ---- modes and grid -------------------------------------------------------------------------- */

/* `count` blocks side by side of each of the vectors; all constants where it is called. */
static INLINE void gather_blocks(uint32_t vectors, uint32_t count, const TbSingleGather *g,
                                 uint32_t block) {
  const uint64_t stride = 8u * (uint64_t)g->n;
  const float *matrix = g->matrix + stride * block;
  Lanes sum[2][4] = {{zero(), zero(), zero(), zero()}, {zero(), zero(), zero(), zero()}};
  for (uint32_t i = 0; i < g->part; i++) {
#pragma GCC unroll 4 /* or the sums would live in memory */
    for (uint32_t b = 0; b < count; b++) {
      const Lanes m = load(matrix + b * stride + 8u * (uint64_t)i);
#pragma GCC unroll 2
      for (uint32_t v = 0; v < vectors; v++) sum[v][b] = add(sum[v][b], scale(m, g->x[v][i]));
    }
  }
  for (uint32_t v = 0; v < vectors; v++) {
    for (uint32_t b = 0; b < count; b++) store_double(g->out[v] + 8 * (block + b), sum[v][b]);
  }
}

static INLINE void gather_all(uint32_t vectors, const TbSingleGather *g) {
  for (uint32_t b = 0; b < g->blocks; b += 4) {
    switch (g->blocks - b) { /* one copy of the code for each */
    case 1: gather_blocks(vectors, 1, g, b); break;
    case 2: gather_blocks(vectors, 2, g, b); break;
    case 3: gather_blocks(vectors, 3, g, b); break;
    default: gather_blocks(vectors, 4, g, b); break;
    }
  }
}

static void gather(const TbSingleGather *g) {
  if (g->vectors == 2) {
    gather_all(2, g);
  } else {
    gather_all(1, g);
  }
}

/* ---- the high band -------------------------------------------------------------------------- */

/* `count` blocks of eight side by side, a constant where it is called. */
static INLINE void combine_blocks(uint32_t blocks, uint32_t count, float *out, const float *f,
                                  const float *const *x, uint32_t at) {
  Lanes sum[4];
  for (uint32_t b = 0; b < blocks; b++) sum[b] = zero();
  for (uint32_t row = 0; row < count; row++) {
#pragma GCC unroll 4 /* or the sums would live in memory */
    for (uint32_t b = 0; b < blocks; b++) {
      sum[b] = add(sum[b], scale(load(x[row] + at + 8 * b), f[row]));
    }
  }
  for (uint32_t b = 0; b < blocks; b++) store(out + at + 8 * b, sum[b]);
}

static void combine(uint32_t n, uint32_t count, float *out, const float *f, const float *const *x) {
  uint32_t at = 0;
  for (; at + 32 <= n; at += 32) combine_blocks(4, count, out, f, x, at);
  for (; at < n; at += 8) combine_blocks(1, count, out, f, x, at);
}

/* ---- the bed -------------------------------------------------------------------------------- */

/* Where the mirror image of a wire stands, and one of each pair. */
static INLINE uint32_t image_of(const TbSingleBed *bed, uint32_t wire) {
  return bed->quarters == 2 ? bed->wires - 1u - wire : wire;
}
static INLINE uint32_t pairs_of(const TbSingleBed *bed) {
  return bed->quarters == 2 ? (bed->wires + 1u) / 2u : bed->wires;
}

/* Up to four lines at once, `n` of them known when compiled: lines[l] = Sum across (x[v] +- x[image]). */
static INLINE void gather_some(uint32_t n, bool odd, const TbSingleBed *bed, uint32_t line,
                               const float *x, float *to) {
  Lanes sum[4] = {zero(), zero(), zero(), zero()};
  for (uint32_t w = 0; w < pairs_of(bed); w++) {
    const uint32_t image = image_of(bed, w);
    const float *c = bed->across + (uint64_t)w * bed->lines + line;
    Lanes v = load(x + (uint64_t)w * bed->lanes);
    if (image != w) {
      const Lanes other = load(x + (uint64_t)image * bed->lanes);
      v = odd ? subtract(v, other) : add(v, other);
    }
    for (uint32_t l = 0; l < n; l++) sum[l] = add(sum[l], scale(v, c[l]));
  }
  for (uint32_t l = 0; l < n; l++) store(to + (uint64_t)(line + l) * bed->lanes, sum[l]);
}

static INLINE void gather_parity(bool odd, const TbSingleBed *bed, const float *x, float *to) {
  const uint32_t end = odd ? bed->lines : bed->even_lines;
  for (uint32_t l = odd ? bed->even_lines : 0; l < end; l += 4) {
    switch (end - l) {
    case 1: gather_some(1, odd, bed, l, x, to); break;
    case 2: gather_some(2, odd, bed, l, x, to); break;
    case 3: gather_some(3, odd, bed, l, x, to); break;
    default: gather_some(4, odd, bed, l, x, to); break;
    }
  }
}

/* `n` lines side by side: out[l] = table^T x[l], with 8 columns of [lanes][padded]. */
static INLINE void columns_of(uint32_t n, const TbSingleBed *bed, const float *table,
                              const float *x, float *out) {
  Lanes sum[4] = {zero(), zero(), zero(), zero()};
  for (uint32_t j = 0; j < bed->lanes; j++) {
    const Lanes shape = load(table + (uint64_t)j * bed->padded);
    for (uint32_t l = 0; l < n; l++) sum[l] = add(sum[l], scale(shape, x[l * bed->lanes + j]));
  }
  for (uint32_t l = 0; l < n; l++) store(out + (uint64_t)l * bed->padded, sum[l]);
}

static void contract(const TbSingleBed *bed, const float *x, float *scratch, float *grid) {
  float *lines = scratch, *points = scratch + bed->lines * bed->lanes;
  for (uint32_t at = 0; at < bed->lanes; at += 8) {
    gather_parity(false, bed, x + at, lines + at);
    gather_parity(true, bed, x + at, lines + at);
  }
  for (uint32_t at = 0; at < bed->padded; at += 8) {
    const float *table = bed->contract + at;
    uint32_t l = 0;
    for (; l + 4 <= bed->lines; l += 4) {
      columns_of(4, bed, table, lines + l * bed->lanes, points + l * bed->padded + at);
    }
    for (; l < bed->lines; l++) {
      columns_of(1, bed, table, lines + l * bed->lanes, points + l * bed->padded + at);
    }
  }
  for (uint32_t i = 0; i < bed->size; i++) grid[i] = 0.0f;
  for (uint32_t l = 0; l < bed->lines; l++) {
    const uint32_t *place = bed->place + l * bed->columns;
    for (uint32_t a = 0; a < bed->columns; a++) grid[place[a]] = points[l * bed->padded + a];
  }
}

/* `n` lines side by side: out[l] = 8 lanes of the shapes' sum. */
static INLINE void lanes_of(uint32_t n, const TbSingleBed *bed, const float *table,
                            const float *points, float *out) {
  Lanes sum[4] = {zero(), zero(), zero(), zero()};
  for (uint32_t a = 0; a < bed->columns; a++) {
    const Lanes shape = load(table + 8u * (uint64_t)a);
    for (uint32_t l = 0; l < n; l++)
      sum[l] = add(sum[l], scale(shape, points[l * bed->padded + a]));
  }
  for (uint32_t l = 0; l < n; l++) store(out + (uint64_t)l * bed->lanes, sum[l]);
}

static INLINE Lanes spread_some(const TbSingleBed *bed, uint32_t from, uint32_t end,
                                const float *across, const float *lines) {
  Lanes sum = zero();
  for (uint32_t l = from; l < end; l++) {
    sum = add(sum, scale(load(lines + (uint64_t)l * bed->lanes), across[l]));
  }
  return sum;
}

static void expand(const TbSingleBed *bed, const float *grid, float *scratch, float *x) {
  float *lines = scratch, *points = scratch + bed->lines * bed->lanes;
  for (uint32_t l = 0; l < bed->lines; l++) {
    const uint32_t *place = bed->place + l * bed->columns;
    for (uint32_t a = 0; a < bed->columns; a++) points[l * bed->padded + a] = grid[place[a]];
  }
  for (uint32_t at = 0; at < bed->lanes; at += 8) {
    const float *table = bed->expand + (uint64_t)at * bed->columns;
    uint32_t l = 0;
    for (; l + 4 <= bed->lines; l += 4) {
      lanes_of(4, bed, table, points + l * bed->padded, lines + l * bed->lanes + at);
    }
    for (; l < bed->lines; l++) {
      lanes_of(1, bed, table, points + l * bed->padded, lines + l * bed->lanes + at);
    }
  }
  for (uint32_t w = 0; w < pairs_of(bed); w++) {
    const float *across = bed->across + (uint64_t)w * bed->lines;
    float *own = x + (uint64_t)w * bed->lanes, *image = x + (uint64_t)image_of(bed, w) * bed->lanes;
    for (uint32_t at = 0; at < bed->lanes; at += 8) {
      const Lanes s = spread_some(bed, 0, bed->even_lines, across, lines + at);
      const Lanes d = spread_some(bed, bed->even_lines, bed->lines, across, lines + at);
      store(image + at, subtract(s, d));
      store(own + at, add(s, d));
    }
  }
}

/* `count` blocks of rows side by side, a constant where it is called. */
static INLINE void multiply_blocks(uint32_t count, uint32_t n, const float *matrix, const float *x,
                                   float *out) {
  const uint64_t block = 8u * (uint64_t)n;
  Lanes sum[4] = {zero(), zero(), zero(), zero()};
  for (uint32_t i = 0; i < n; i++) {
    const float *m = matrix + 8u * (uint64_t)i;
    for (uint32_t b = 0; b < count; b++) sum[b] = add(sum[b], scale(load(m + b * block), x[i]));
  }
  for (uint32_t b = 0; b < count; b++) store(out + 8 * b, sum[b]);
}

static void multiply(uint32_t n, const float *matrix, const float *x, float *out) {
  const uint32_t blocks = n / 8;
  for (uint32_t b = 0; b < blocks; b += 4) {
    const float *m = matrix + 8u * (uint64_t)n * b;
    switch (blocks - b) {
    case 1: multiply_blocks(1, n, m, x, out + 8 * b); break;
    case 2: multiply_blocks(2, n, m, x, out + 8 * b); break;
    case 3: multiply_blocks(3, n, m, x, out + 8 * b); break;
    default: multiply_blocks(4, n, m, x, out + 8 * b); break;
    }
  }
}

static void comply(const TbSingleBed *bed, const float *grid, float *out) {
  for (uint32_t c = 0; c < bed->classes; c++) {
    const uint32_t first = bed->first[c];
    multiply(bed->first[c + 1] - first, bed->matrix[c], grid + first, out + first);
  }
}

/* ---- contacts ------------------------------------------------------------------------------- */

static void laws(uint32_t wires, uint32_t lanes, const TbLaw *laws_of, const float *y,
                 const float *s, float *force, float *slope, float *mean) {
  for (uint32_t w = 0, at = 0; w < wires; w++, at += lanes) {
    law_of_power(&laws_of[w], tb_law_power(&laws_of[w]), lanes,
                 (LawArrays){y + at, s + at, force + at, slope + at, mean + at});
  }
}

static float largest(uint32_t n, const float *x) {
  Lanes most = zero();
  for (uint32_t i = 0; i < n; i += 8) most = larger(size_of(load(x + i)), most);
  return largest_of(most);
}

static float difference(uint32_t n, const float *x, const float *y) {
  Lanes most = zero();
  for (uint32_t i = 0; i < n; i += 8) {
    most = larger(size_of(subtract(load(x + i), load(y + i))), most);
  }
  return largest_of(most);
}

static uint32_t count(uint32_t n, const float *x) {
  Lanes sum = zero();
  for (uint32_t i = 0; i < n; i += 8) {
    sum = add(sum, pick(greater(load(x + i), zero()), all(1.0f), zero()));
  }
  return (uint32_t)join(sum);
}

static void subtract_arrays(uint32_t n, const float *x, const float *y, float *out) {
  for (uint32_t i = 0; i < n; i += 8) store(out + i, subtract(load(x + i), load(y + i)));
}

static void add_scaled(uint32_t n, float *out, float f, const float *x) {
  for (uint32_t i = 0; i < n; i += 8) store(out + i, add(load(out + i), scale(load(x + i), f)));
}

static void add_product(uint32_t n, float *out, const float *x, const float *y) {
  for (uint32_t i = 0; i < n; i += 8) {
    store(out + i, add(load(out + i), multiply_lanes(load(x + i), load(y + i))));
  }
}

static void product(uint32_t n, float *out, const float *x, const float *y) {
  for (uint32_t i = 0; i < n; i += 8) store(out + i, multiply_lanes(load(x + i), load(y + i)));
}

static float weigh(uint32_t n, const float *slope, const float *p, const float *p_last,
                   float *weight, float *d) {
  Lanes sum = zero();
  for (uint32_t i = 0; i < n; i += 8) {
    const Lanes w = root(load(slope + i));
    const Lanes down = multiply_lanes(w, subtract(load(p_last + i), load(p + i)));
    store(weight + i, w);
    store(d + i, down);
    sum = add(sum, multiply_lanes(down, down));
  }
  return join(sum);
}

static float turn(uint32_t n, float *out, const float *d, const float *w, const float *m) {
  Lanes sum = zero();
  for (uint32_t i = 0; i < n; i += 8) {
    const Lanes direction = load(d + i);
    const Lanes turned = add(direction, multiply_lanes(load(w + i), load(m + i)));
    store(out + i, turned);
    sum = add(sum, multiply_lanes(direction, turned));
  }
  return join(sum);
}

static float advance(uint32_t n, float t, float *p, const float *d, float *r, const float *m) {
  Lanes sum = zero();
  for (uint32_t i = 0; i < n; i += 8) {
    store(p + i, add(load(p + i), scale(load(d + i), t)));
    const Lanes left = subtract(load(r + i), scale(load(m + i), t));
    store(r + i, left);
    sum = add(sum, multiply_lanes(left, left));
  }
  return join(sum);
}

static void redirect(uint32_t n, float t, float *d, const float *r) {
  for (uint32_t i = 0; i < n; i += 8) store(d + i, add(load(r + i), scale(load(d + i), t)));
}

static void balance(uint32_t n, float t, const float *s_at, const float *law, const float *slope,
                    const float *f_at, const float *f_last, const float *p, const float *p_last,
                    float sums[3]) {
  Lanes value = zero(), derivative = zero(), size = zero();
  for (uint32_t i = 0; i < n; i += 8) {
    const Lanes s = load(s_at + i), f = load(f_at + i), g = subtract(f, load(f_last + i));
    const Lanes m = subtract(load(p + i), load(p_last + i)), moved = add(f, scale(g, t));
    const Lanes left = subtract(load(law + i), moved);
    const Lanes bend = multiply_lanes(s, add(multiply_lanes(load(slope + i), m), g));
    value = add(value, multiply_lanes(s, left));
    derivative = subtract(derivative, add(multiply_lanes(m, left), bend));
    size = add(size, size_of(multiply_lanes(s, moved)));
  }
  sums[0] = join(value);
  sums[1] = join(derivative);
  sums[2] = join(size);
}

static float lost(uint32_t n, const float *s, const float *f, const float *mean) {
  Lanes sum = zero();
  for (uint32_t i = 0; i < n; i += 8) {
    sum = add(sum, multiply_lanes(load(s + i), subtract(load(f + i), load(mean + i))));
  }
  return join(sum);
}

static void extrapolate(uint32_t n, float t, const float *x, const float *before, const float *base,
                        float *out) {
  for (uint32_t i = 0; i < n; i += 8) {
    store(out + i, add(load(base + i), scale(subtract(load(x + i), load(before + i)), t)));
  }
}

const TbSingleKernels TB_SINGLE_KERNELS = {
  .narrow = narrow,
  .narrow_difference = narrow_difference,
  .widen = widen,
  .gather = gather,
  .combine = combine,
  .ring = ring,
  .two_dots = two_dots,
  .contract = contract,
  .expand = expand,
  .comply = comply,
  .laws = laws,
  .largest = largest,
  .difference = difference,
  .count = count,
  .subtract = subtract_arrays,
  .add_scaled = add_scaled,
  .add_product = add_product,
  .product = product,
  .weigh = weigh,
  .turn = turn,
  .advance = advance,
  .redirect = redirect,
  .balance = balance,
  .lost = lost,
  .extrapolate = extrapolate,
};
