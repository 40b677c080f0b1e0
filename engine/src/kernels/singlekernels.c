/* SPDX-License-Identifier: MIT */
/* Compiled once per instruction set, with TB_SINGLE_KERNELS naming the table it fills. */
#define TB_SINGLE
#include "kernels/singlekernels.h"

#include "kernels/lanes.h"
#include "kernels/lawlanes.h"
#include "kernels/ringlanes.h"
#include "kernels/rowlanes.h"
#include "model/singlebed.h"

/* ---- precision ------------------------------------------------------------------------------ */

static void narrow(uint32_t n, const double *x, float *out) {
  for (uint32_t i = 0; i < n; i += 8) store(out + i, load_double(x + i));
}

static void narrow_change(uint32_t n, const double *x, const double *y, float *out) {
  for (uint32_t i = 0; i < n; i += 8) store(out + i, load_change(x + i, y + i));
}

static void widen(uint32_t n, const float *x, double *out) {
  for (uint32_t i = 0; i < n; i += 8) store_double(out + i, load(x + i));
}

static void add_widened(uint32_t n, const float *x, double *out) {
  for (uint32_t i = 0; i < n; i += 8) add_double(out + i, load(x + i));
}

static void start(uint32_t n, TbSingleStart *whole) {
  const TbSingleStart copy = *whole, *at = &copy; /* which no store can change */
  Lanes change = zero(), deepest = zero();
  for (uint32_t i = 0; i < n; i += 8) {
    const Lanes b = load_double(at->from_b + i), y = load_double(at->from_y + i);
    const Lanes f = load_double(at->from_f + i);
    store(at->s + i, load_change(at->from_b + i, at->from_p + i));
    store(at->b + i, b);
    store(at->y + i, y);
    store(at->root + i, root(larger(y, zero())));
    store(at->f + i, f);
    store(at->p + i, load_double(at->from_p + i));
    store(at->own + i, load_double(at->from_own + i));
    change = larger(size_of(b), change);
    deepest = larger(y, deepest);
  }
  whole->change = largest_of(change);
  whole->depth = largest_of(deepest);
}

static void end(uint32_t n, TbSingleEnd *whole) {
  const TbSingleEnd copy = *whole, *at = &copy;
  Lanes sum = zero(), touching = zero();
  for (uint32_t i = 0; i < n; i += 8) {
    const Lanes f = load(at->f + i), p = load(at->p + i);
    const Lanes moved = add(p, scale(subtract(p, load(at->p_last + i)), at->t));
    const Lanes s = subtract(load(at->b + i), moved);
    store_double(at->to_f + i, add(f, scale(subtract(f, load(at->f_last + i)), at->t)));
    store_double(at->to_p + i, moved);
    store_double(at->to_s + i, s);
    sum = add(sum, multiply_lanes(s, subtract(load(at->law + i), load(at->mean + i))));
    touching = add(touching, pick(greater(load(at->slope + i), zero()), all(1.0f), zero()));
  }
  whole->lost = join(sum);
  whole->touching = (uint32_t)join(touching);
}

/* ---- modes and grid -------------------------------------------------------------------------- */

/* `count` blocks side by side of each of the vectors, as `ways` sums of every so many terms, so that an addition
 * seldom waits for the one before; all constants where it is called. */
static INLINE void gather_blocks(uint32_t vectors, uint32_t count, uint32_t ways,
                                 const TbSingleGather *g, uint32_t block) {
  const uint64_t stride = 8u * (uint64_t)g->n;
  const float *matrix = g->matrix + stride * block;
  Lanes sum[4][8];
  for (uint32_t w = 0; w < ways; w++) {
    for (uint32_t s = 0; s < vectors * count; s++) sum[w][s] = zero();
  }
  for (uint64_t i = 0; i < g->part; i += ways) {
#pragma GCC unroll 4 /* or the sums would live in memory */
    for (uint32_t w = 0; w < ways; w++) {
#pragma GCC unroll 4
      for (uint32_t b = 0; b < count; b++) {
        const Lanes m = load(matrix + b * stride + 8u * (i + w));
#pragma GCC unroll 2
        for (uint32_t v = 0; v < vectors; v++) {
          sum[w][v * count + b] = add(sum[w][v * count + b], scale(m, g->x[v][i + w]));
        }
      }
    }
  }
#pragma GCC unroll 8
  for (uint32_t s = 0; s < vectors * count; s++) {
    if (ways == 4) sum[1][s] = add(sum[1][s], sum[3][s]);
    if (ways == 4) sum[0][s] = add(sum[0][s], sum[2][s]);
    if (ways >= 2) sum[0][s] = add(sum[0][s], sum[1][s]);
    store_double(g->out[s / count] + 8 * (block + s % count), sum[0][s]);
  }
}

static INLINE void gather_all(uint32_t vectors, const TbSingleGather *g) {
  for (uint32_t b = 0; b < g->blocks; b += 4) {
    switch (g->blocks - b) { /* one copy of the code for each */
    case 1: gather_blocks(vectors, 1, 4 / vectors, g, b); break;
    case 2: gather_blocks(vectors, 2, 2 / vectors, g, b); break;
    case 3: gather_blocks(vectors, 3, 2 / vectors, g, b); break;
    default: gather_blocks(vectors, 4, 1, g, b); break;
    }
  }
}

static float rest_of(const TbSingleGather *g, uint32_t row, const float *x) {
  const float *column = g->transposed + 8u * row;
  Lanes sum = zero();
  for (uint64_t i = 0; i < g->part; i += 8, column += 8u * g->stride) {
    sum = add(sum, multiply_lanes(load(column), load(x + i)));
  }
  return join(sum);
}

static void gather(const TbSingleGather *g) {
  if (g->vectors == 2) {
    gather_all(2, g);
  } else {
    gather_all(1, g);
  }
  for (uint32_t row = 0; row < g->rest; row++) {
    for (uint32_t v = 0; v < g->vectors; v++) {
      g->out[v][8u * g->blocks + row] = (double)rest_of(g, row, g->x[v]);
    }
  }
}

/* ---- the high band -------------------------------------------------------------------------- */

/* `count` blocks of eight side by side, a constant where it is called. */
static INLINE void combine_blocks(uint32_t blocks, uint32_t count, const float *f,
                                  const float *const *x, const float *base, uint32_t at,
                                  float *out) {
  Lanes sum[4];
  for (uint32_t b = 0; b < blocks; b++) sum[b] = zero();
  for (uint32_t row = 0; row < count; row++) {
#pragma GCC unroll 4 /* or the sums would live in memory */
    for (uint32_t b = 0; b < blocks; b++) {
      sum[b] = add(sum[b], scale(load(x[row] + at + 8 * b), f[row]));
    }
  }
  for (uint32_t b = 0; b < blocks; b++) {
    store(out + at + 8 * b, subtract(sum[b], load(base + at + 8 * b)));
  }
}

static void combine(uint32_t n, uint32_t count, const float *f, const float *const *x,
                    const float *base, float *out) {
  uint32_t at = 0;
  for (; at + 32 <= n; at += 32) combine_blocks(4, count, f, x, base, at, out);
  for (; at < n; at += 8) combine_blocks(1, count, f, x, base, at, out);
}

/* ---- the bed -------------------------------------------------------------------------------- */

/* Tiles of sums that stay in registers: `lines` lines of `blocks` times eight lanes or columns, both constants
 * where they are called. Each sum still runs term by term in ascending order. */
enum { TILE_LINES = 3, TILE_BLOCKS = 3 };

typedef struct Tile {
  Lanes sum[TILE_LINES][TILE_BLOCKS];
} Tile;

static INLINE void clear_tile(Tile *tile) {
  for (uint32_t l = 0; l < TILE_LINES; l++) {
    for (uint32_t b = 0; b < TILE_BLOCKS; b++) tile->sum[l][b] = zero();
  }
}

/* sum[l][b] += factor[l * step] x[b] */
static INLINE void add_to_tile(uint32_t lines, uint32_t blocks, Tile *tile, const float *factor,
                               uint32_t step, const Lanes *x) {
#pragma GCC unroll 3
  for (uint32_t l = 0; l < lines; l++) {
#pragma GCC unroll 3
    for (uint32_t b = 0; b < blocks; b++) {
      tile->sum[l][b] = add(tile->sum[l][b], scale(x[b], factor[l * step]));
    }
  }
}

static INLINE void store_tile(uint32_t lines, uint32_t blocks, const Tile *tile, uint32_t step,
                              float *out) {
#pragma GCC unroll 3
  for (uint32_t l = 0; l < lines; l++) {
#pragma GCC unroll 3
    for (uint32_t b = 0; b < blocks; b++) store(out + l * step + 8u * b, tile->sum[l][b]);
  }
}

static INLINE void load_blocks(uint32_t blocks, const float *at, Lanes *x) {
#pragma GCC unroll 3
  for (uint32_t b = 0; b < blocks; b++) x[b] = load(at + 8u * b);
}

/* Calls tile(lines, blocks, ...) for all of `line_count` lines from `line` on and `block_count` blocks, each tile
 * a copy of the code of its own size. */
#define FOR_TILES(tile, first_line, line_end, block_count, ...)                                    \
  for (uint32_t line_ = (first_line); line_ < (line_end); line_ += TILE_LINES) {                   \
    for (uint32_t block_ = 0; block_ < (block_count); block_ += TILE_BLOCKS) {                     \
      const uint32_t lines_ = (line_end)-line_ < TILE_LINES ? (line_end)-line_ : TILE_LINES;       \
      const uint32_t left_ = (block_count)-block_;                                                 \
      const uint32_t blocks_ = left_ < TILE_BLOCKS ? left_ : TILE_BLOCKS;                          \
      switch (4u * lines_ + blocks_) {                                                             \
      case 5: tile(1, 1, line_, 8u * block_, __VA_ARGS__); break;                                  \
      case 6: tile(1, 2, line_, 8u * block_, __VA_ARGS__); break;                                  \
      case 7: tile(1, 3, line_, 8u * block_, __VA_ARGS__); break;                                  \
      case 9: tile(2, 1, line_, 8u * block_, __VA_ARGS__); break;                                  \
      case 10: tile(2, 2, line_, 8u * block_, __VA_ARGS__); break;                                 \
      case 11: tile(2, 3, line_, 8u * block_, __VA_ARGS__); break;                                 \
      case 13: tile(3, 1, line_, 8u * block_, __VA_ARGS__); break;                                 \
      case 14: tile(3, 2, line_, 8u * block_, __VA_ARGS__); break;                                 \
      default: tile(3, 3, line_, 8u * block_, __VA_ARGS__); break;                                 \
      }                                                                                            \
    }                                                                                              \
  }

/* Where the mirror image of a wire stands, and one of each pair. */
static INLINE uint32_t image_of(const TbSingleBed *bed, uint32_t wire) {
  return bed->quarters == 2 ? bed->wires - 1u - wire : wire;
}
static INLINE uint32_t pairs_of(const TbSingleBed *bed) {
  return bed->quarters == 2 ? (bed->wires + 1u) / 2u : bed->wires;
}

/* lines[l] = Sum across (x[v] +- x[image]) */
static INLINE void gather_tile(uint32_t lines, uint32_t blocks, uint32_t line, uint32_t at,
                               const TbSingleBed *bed, bool odd, const float *x, float *to) {
  Tile tile;
  clear_tile(&tile);
  for (uint32_t w = 0; w < pairs_of(bed); w++) {
    const uint32_t image = image_of(bed, w);
    Lanes own[TILE_BLOCKS], other[TILE_BLOCKS];
    load_blocks(blocks, x + w * bed->lanes + at, own);
    if (image != w) {
      load_blocks(blocks, x + image * bed->lanes + at, other);
#pragma GCC unroll 3
      for (uint32_t b = 0; b < blocks; b++) {
        own[b] = odd ? subtract(own[b], other[b]) : add(own[b], other[b]);
      }
    }
    add_to_tile(lines, blocks, &tile, bed->across + w * bed->lines + line, 1, own);
  }
  store_tile(lines, blocks, &tile, bed->lanes, to + line * bed->lanes + at);
}

/* points[l] = contract^T lines[l] */
static INLINE void columns_tile(uint32_t lines, uint32_t blocks, uint32_t line, uint32_t at,
                                const TbSingleBed *bed, const float *x, float *out) {
  Tile tile;
  clear_tile(&tile);
  for (uint32_t j = 0; j < bed->lanes; j++) {
    Lanes shape[TILE_BLOCKS];
    load_blocks(blocks, bed->contract + j * bed->padded + at, shape);
    add_to_tile(lines, blocks, &tile, x + line * bed->lanes + j, bed->lanes, shape);
  }
  store_tile(lines, blocks, &tile, bed->padded, out + line * bed->padded + at);
}

/* One wire is its line across itself, and few of its points touch. `blocks` blocks of columns from `at` on, a
 * constant where it is called. */
static INLINE void contract_blocks(uint32_t blocks, const TbSingleBed *bed, const float *x,
                                   uint32_t at, float *points) {
  const float *shape = bed->contract + at;
  Lanes sum[4];
  for (uint32_t b = 0; b < blocks; b++) sum[b] = zero();
  for (uint32_t j = 0; j < bed->lanes; j++, shape += bed->padded) {
    if (x[j] == 0.0f) continue;
#pragma GCC unroll 4 /* or the sums would live in memory */
    for (uint32_t b = 0; b < blocks; b++) sum[b] = add(sum[b], scale(load(shape + 8 * b), x[j]));
  }
  for (uint32_t b = 0; b < blocks; b++) store(points + at + 8 * b, sum[b]);
}

static void contract_wire(const TbSingleBed *bed, const float *x, float *points) {
  for (uint32_t at = 0; at < bed->padded; at += 32) {
    switch ((bed->padded - at) / 8u) { /* one copy of the code for each */
    case 1: contract_blocks(1, bed, x, at, points); break;
    case 2: contract_blocks(2, bed, x, at, points); break;
    case 3: contract_blocks(3, bed, x, at, points); break;
    default: contract_blocks(4, bed, x, at, points); break;
    }
  }
}

static void contract_wires(const TbSingleBed *bed, const float *x, float *lines, float *points) {
  FOR_TILES(gather_tile, 0, bed->even_lines, bed->lanes / 8u, bed, false, x, lines)
  FOR_TILES(gather_tile, bed->even_lines, bed->lines, bed->lanes / 8u, bed, true, x, lines)
  FOR_TILES(columns_tile, 0, bed->lines, bed->padded / 8u, bed, lines, points)
}

static void contract(const TbSingleBed *bed, const float *x, float *scratch, float *grid) {
  float *points = scratch + bed->lines * bed->lanes;
  if (bed->wires == 1) {
    contract_wire(bed, x, points);
  } else {
    contract_wires(bed, x, scratch, points);
  }
  for (uint32_t i = 0; i < bed->size; i++) grid[i] = 0.0f;
  for (uint32_t l = 0; l < bed->lines; l++) {
    const uint32_t *place = bed->place + l * bed->columns;
    for (uint32_t a = 0; a < bed->columns; a++) grid[place[a]] = points[l * bed->padded + a];
  }
}

/* lines[l] = expand points[l] */
static INLINE void lanes_tile(uint32_t lines, uint32_t blocks, uint32_t line, uint32_t at,
                              const TbSingleBed *bed, const float *points, float *out) {
  Tile tile;
  clear_tile(&tile);
  for (uint32_t a = 0; a < bed->columns; a++) {
    Lanes shape[TILE_BLOCKS];
    load_blocks(blocks, bed->expand + a * bed->lanes + at, shape);
    add_to_tile(lines, blocks, &tile, points + line * bed->padded + a, bed->padded, shape);
  }
  store_tile(lines, blocks, &tile, bed->lanes, out + line * bed->lanes + at);
}

static INLINE void spread_lines(uint32_t blocks, const TbSingleBed *bed, uint32_t from,
                                uint32_t end, const float *across, const float *lines, Lanes *sum) {
  for (uint32_t b = 0; b < blocks; b++) sum[b] = zero();
  for (uint32_t l = from; l < end; l++) {
#pragma GCC unroll 3
    for (uint32_t b = 0; b < blocks; b++) {
      sum[b] = add(sum[b], scale(load(lines + l * bed->lanes + 8u * b), across[l]));
    }
  }
}

/* x[v], x[image] = Sum over even lines +- Sum over odd ones, of one pair. */
static INLINE void spread_tile(uint32_t lines, uint32_t blocks, uint32_t pair, uint32_t at,
                               const TbSingleBed *bed, const float *from, float *x) {
  for (uint32_t w = pair; w < pair + lines; w++) {
    const float *across = bed->across + w * bed->lines;
    float *own = x + w * bed->lanes + at, *image = x + image_of(bed, w) * bed->lanes + at;
    Lanes s[TILE_BLOCKS], d[TILE_BLOCKS];
    spread_lines(blocks, bed, 0, bed->even_lines, across, from + at, s);
    spread_lines(blocks, bed, bed->even_lines, bed->lines, across, from + at, d);
#pragma GCC unroll 3
    for (uint32_t b = 0; b < blocks; b++) {
      store(image + 8u * b, subtract(s[b], d[b]));
      store(own + 8u * b, add(s[b], d[b]));
    }
  }
}

/* `blocks` blocks of a wire's lanes from `at` on, a constant where it is called. */
static INLINE void expand_blocks(uint32_t blocks, const TbSingleBed *bed, const float *grid,
                                 uint32_t at, float *x) {
  Lanes sum[4];
  for (uint32_t b = 0; b < blocks; b++) sum[b] = zero();
  for (uint32_t a = 0; a < bed->columns; a++) {
    const float *shape = bed->expand + a * bed->lanes + at, point = grid[bed->place[a]];
#pragma GCC unroll 4 /* or the sums would live in memory */
    for (uint32_t b = 0; b < blocks; b++) sum[b] = add(sum[b], scale(load(shape + 8 * b), point));
  }
  for (uint32_t b = 0; b < blocks; b++) store(x + at + 8 * b, sum[b]);
}

static void expand_wire(const TbSingleBed *bed, const float *grid, float *x) {
  for (uint32_t at = 0; at < bed->lanes; at += 32) {
    switch ((bed->lanes - at) / 8u) { /* one copy of the code for each */
    case 1: expand_blocks(1, bed, grid, at, x); break;
    case 2: expand_blocks(2, bed, grid, at, x); break;
    case 3: expand_blocks(3, bed, grid, at, x); break;
    default: expand_blocks(4, bed, grid, at, x); break;
    }
  }
}

static void expand(const TbSingleBed *bed, const float *grid, float *scratch, float *x) {
  if (bed->wires == 1) {
    expand_wire(bed, grid, x);
    return;
  }
  float *lines = scratch, *points = scratch + bed->lines * bed->lanes;
  for (uint32_t l = 0; l < bed->lines; l++) {
    const uint32_t *place = bed->place + l * bed->columns;
    for (uint32_t a = 0; a < bed->columns; a++) points[l * bed->padded + a] = grid[place[a]];
  }
  FOR_TILES(lanes_tile, 0, bed->lines, bed->lanes / 8u, bed, points, lines)
  FOR_TILES(spread_tile, 0, pairs_of(bed), bed->lanes / 8u, bed, lines, x)
}

/* ---- matrices ------------------------------------------------------------------------------- */

/* `count` blocks of rows side by side, a constant where it is called. */
static INLINE void multiply_blocks(uint32_t count, uint32_t n, uint64_t block, const float *matrix,
                                   const float *x, float *out) {
  Lanes sum[6];
#pragma GCC unroll 6
  for (uint32_t b = 0; b < count; b++) sum[b] = zero();
  for (uint32_t i = 0; i < n; i++) {
    const float *m = matrix + 8u * (uint64_t)i;
#pragma GCC unroll 6 /* or the sums would live in memory */
    for (uint32_t b = 0; b < count; b++) sum[b] = add(sum[b], scale(load(m + b * block), x[i]));
  }
#pragma GCC unroll 6
  for (uint32_t b = 0; b < count; b++) store(out + 8 * b, sum[b]);
}

static void multiply(uint32_t blocks, uint32_t n, const float *matrix, const float *x, float *out) {
  const uint64_t block = 8u * (uint64_t)n;
  for (uint32_t b = 0, take; b < blocks; b += take) {
    const float *m = matrix + block * b;
    take = blocks - b == 7 ? 4 : blocks - b < 6 ? blocks - b : 6;
    switch (take) { /* one copy of the code for each */
    case 1: multiply_blocks(1, n, block, m, x, out + 8 * b); break;
    case 2: multiply_blocks(2, n, block, m, x, out + 8 * b); break;
    case 3: multiply_blocks(3, n, block, m, x, out + 8 * b); break;
    case 4: multiply_blocks(4, n, block, m, x, out + 8 * b); break;
    case 5: multiply_blocks(5, n, block, m, x, out + 8 * b); break;
    default: multiply_blocks(6, n, block, m, x, out + 8 * b); break;
    }
  }
}

static void comply(const TbSingleBed *bed, const float *grid, float *out) {
  for (uint32_t c = 0; c < bed->classes; c++) {
    const uint32_t first = bed->first[c], points = bed->first[c + 1] - first;
    multiply(points / 8u, points, bed->matrix[c], grid + first, out + first);
  }
}

/* ---- contacts ------------------------------------------------------------------------------- */

static bool penetrate(uint32_t n, float side, const float *w, const double *v, const double *v_last,
                      const double *rest_load, const double *y, double *b) {
  Lanes deepest = all(-1.0f);
  for (uint32_t i = 0; i < n; i += 8) {
    const Lanes moved = subtract(scale(load(w + i), side), load_change(v + i, v_last + i));
    const Lanes change = add(moved, load_double(rest_load + i)), before = load_double(y + i);
    store_double(b + i, change);
    deepest = larger(larger(before, add(before, change)), deepest);
  }
  return any(greater(deepest, all(-TB_NEAR)));
}

static void laws(uint32_t wires, uint32_t lanes, const TbLaw *laws_of, const float *y,
                 const float *sqrt_y, const float *s, float *force, float *slope, float *mean) {
  for (uint32_t w = 0, at = 0; w < wires; w++, at += lanes) {
    law_of_power(&laws_of[w], tb_law_power(&laws_of[w]), lanes,
                 (LawArrays){y + at, sqrt_y + at, s + at, force + at, slope + at, mean + at});
  }
}

static void relax(uint32_t n, const float *law, const float *slope, const float *own,
                  const float *head, const float *f_last, float *f) {
  for (uint32_t i = 0; i < n; i += 8) {
    const Lanes before = load(f_last + i), yield = add(load(own + i), load(head + i));
    const Lanes firm = add(all(1.0f), multiply_lanes(load(slope + i), yield));
    store(f + i, add(before, divide(subtract(load(law + i), before), firm)));
  }
}

static float change(uint32_t n, const float *b, const float *p, float *s) {
  Lanes most = zero();
  for (uint32_t i = 0; i < n; i += 8) {
    const Lanes left = subtract(load(b + i), load(p + i));
    store(s + i, left);
    most = larger(size_of(left), most);
  }
  return largest_of(most);
}

static float follow(uint32_t n, const float *law, const float *weight, const float *x,
                    const float *b, const float *p, float *f, float *s) {
  Lanes most = zero();
  for (uint32_t i = 0; i < n; i += 8) {
    const Lanes change = subtract(load(b + i), load(p + i));
    store(f + i, add(load(law + i), multiply_lanes(load(weight + i), load(x + i))));
    store(s + i, change);
    most = larger(size_of(change), most);
  }
  return largest_of(most);
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

static TbSingleSums balance(uint32_t n, float t, const float *s_at, const float *law,
                            const float *slope, const float *f_at, const float *f_last,
                            const float *p, const float *p_last) {
  Lanes value = zero(), derivative = zero(), size = zero();
  Lanes miss = zero(), most = zero();
  for (uint32_t i = 0; i < n; i += 8) {
    const Lanes s = load(s_at + i), f = load(f_at + i), g = subtract(f, load(f_last + i));
    const Lanes m = subtract(load(p + i), load(p_last + i)), moved = add(f, scale(g, t));
    const Lanes left = subtract(load(law + i), moved);
    const Lanes bend = multiply_lanes(s, add(multiply_lanes(load(slope + i), m), g));
    value = add(value, multiply_lanes(s, left));
    derivative = subtract(derivative, add(multiply_lanes(m, left), bend));
    size = add(size, size_of(multiply_lanes(s, moved)));
    miss = larger(size_of(left), miss);
    most = larger(size_of(moved), most);
  }
  return (TbSingleSums){join(value), join(derivative), join(size), largest_of(miss),
                        largest_of(most)};
}

const TbSingleKernels TB_SINGLE_KERNELS = {
  .narrow = narrow,
  .narrow_change = narrow_change,
  .penetrate = penetrate,
  .widen = widen,
  .gather = gather,
  .combine = combine,
  .ring = ring,
  .two_dots = two_dots,
  .add_widened = add_widened,
  .start = start,
  .end = end,
  .contract = contract,
  .expand = expand,
  .comply = comply,
  .laws = laws,
  .difference = difference,
  .relax = relax,
  .change = change,
  .follow = follow,
  .dot = dot,
  .add_scaled = add_scaled,
  .add_product = add_product,
  .product = product,
  .weigh = weigh,
  .turn = turn,
  .advance = advance,
  .redirect = redirect,
  .balance = balance,
  .extrapolate = extrapolate,
};
