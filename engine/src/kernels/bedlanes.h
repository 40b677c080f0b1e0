/* SPDX-License-Identifier: MIT */
/* Between wires and the grid under them (bed.h) in the precision of simd_lanes.h. For kernels_tmpl.c alone. */
#ifndef TB_BEDLANES_H
#define TB_BEDLANES_H

#include "kernels/kernels.h"
#include "kernels/simd_lanes.h"
#include "kernels/tablelanes.h"

typedef TYPE_OF(TbBed) Bed;

/* ---- across --------------------------------------------------------------------------------- */

/* Tiles of sums that stay in registers: `lines` lines of `blocks` times eight lanes or columns, both constants
 * where they are called. Each sum runs term by term in ascending order, whatever the tile. */
enum { MOST_TILE = 3, TILE_LINES = 3, TILE_BLOCKS = PARTS == 1 || SINGLE ? 3 : 1 };

typedef struct Tile {
  Lanes sum[MOST_TILE][MOST_TILE];
} Tile;

static INLINE void clear_tile(Tile *tile) {
  for (uint32_t l = 0; l < MOST_TILE; l++) {
    for (uint32_t b = 0; b < MOST_TILE; b++) tile->sum[l][b] = zero();
  }
}

/* sum[l][b] += factor[l * step] x[b] */
static INLINE void add_to_tile(uint32_t lines, uint32_t blocks, Tile *tile, const Real *factor,
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
                              Real *out) {
#pragma GCC unroll 3
  for (uint32_t l = 0; l < lines; l++) {
#pragma GCC unroll 3
    for (uint32_t b = 0; b < blocks; b++) store(out + l * step + 8u * b, tile->sum[l][b]);
  }
}

static INLINE void load_blocks(uint32_t blocks, const Real *at, Lanes *x) {
#pragma GCC unroll 3
  for (uint32_t b = 0; b < blocks; b++) x[b] = load(at + 8u * b);
}

/* Calls tile(lines, blocks, ...) for the lines from `first_line` to `line_end` and `block_count` blocks, each tile a
 * copy of the code of its own size. */
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
static INLINE uint32_t image_of(const Bed *bed, uint32_t wire) {
  return bed->quarters == 2 ? bed->wires - 1u - wire : wire;
}
static INLINE uint32_t pairs_of(const Bed *bed) {
  return bed->quarters == 2 ? (bed->wires + 1u) / 2u : bed->wires;
}

/* lines[l] = Sum across (x[v] +- x[image]) */
static INLINE void gather_tile(uint32_t lines, uint32_t blocks, uint32_t line, uint32_t at,
                               const Bed *bed, bool odd, const Real *x, Real *to) {
  Tile tile;
  clear_tile(&tile);
  for (uint32_t w = 0; w < pairs_of(bed); w++) {
    const uint32_t image = image_of(bed, w);
    Lanes own[MOST_TILE], other[MOST_TILE];
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

static INLINE void spread_parity(uint32_t blocks, const Bed *bed, uint32_t from, uint32_t end,
                                 const Real *across, const Real *lines, Lanes *sum) {
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
                               const Bed *bed, const Real *from, Real *x) {
  for (uint32_t w = pair; w < pair + lines; w++) {
    const Real *across = bed->across + w * bed->lines;
    Real *own = x + w * bed->lanes + at, *image = x + image_of(bed, w) * bed->lanes + at;
    Lanes s[MOST_TILE], d[MOST_TILE];
    spread_parity(blocks, bed, 0, bed->first_line[1], across, from + at, s);
    spread_parity(blocks, bed, bed->first_line[1], bed->lines, across, from + at, d);
#pragma GCC unroll 3
    for (uint32_t b = 0; b < blocks; b++) {
      store(image + 8u * b, subtract(s[b], d[b]));
      store(own + 8u * b, add(s[b], d[b]));
    }
  }
}

/* lines[l] = Sum over pairs of across[v][l] (x[v] +- x[image]) */
static void gather_lines(const Bed *bed, const Real *x, Real *lines) {
  FOR_TILES(gather_tile, 0, bed->first_line[1], bed->lanes / 8u, bed, false, x, lines)
  FOR_TILES(gather_tile, bed->first_line[1], bed->lines, bed->lanes / 8u, bed, true, x, lines)
}

static void spread_lines(const Bed *bed, const Real *lines, Real *x) {
  FOR_TILES(spread_tile, 0, pairs_of(bed), bed->lanes / 8u, bed, lines, x)
}

#ifdef TB_FLOAT
/* ---- along, unfolded ------------------------------------------------------------------------ */

/* points[l] = contract^T lines[l] */
static INLINE void columns_tile(uint32_t lines, uint32_t blocks, uint32_t line, uint32_t at,
                                const Bed *bed, const float *x, float *out) {
  Tile tile;
  clear_tile(&tile);
  for (uint32_t j = 0; j < bed->lanes; j++) {
    Lanes shape[MOST_TILE];
    load_blocks(blocks, bed->contract + j * bed->padded + at, shape);
    add_to_tile(lines, blocks, &tile, x + line * bed->lanes + j, bed->lanes, shape);
  }
  store_tile(lines, blocks, &tile, bed->padded, out + line * bed->padded + at);
}

/* One wire is its line across itself, and few of its points touch. `blocks` blocks of columns from `at` on, a
 * constant where it is called. */
static INLINE void contract_blocks(uint32_t blocks, const Bed *bed, const float *x, uint32_t at,
                                   float *points) {
  const float *shape = bed->contract + at;
  Lanes sum[4];
  for (uint32_t b = 0; b < blocks; b++) sum[b] = zero();
  for (uint32_t j = 0; j < bed->lanes; j++, shape += bed->padded) {
    if (x[j] == 0.0f) continue;
#  pragma GCC unroll 4 /* or the sums would live in memory */
    for (uint32_t b = 0; b < blocks; b++) sum[b] = add(sum[b], scale(load(shape + 8 * b), x[j]));
  }
  for (uint32_t b = 0; b < blocks; b++) store(points + at + 8 * b, sum[b]);
}

static void contract_wire(const Bed *bed, const float *x, float *points) {
  for (uint32_t at = 0; at < bed->padded; at += 32) {
    switch ((bed->padded - at) / 8u) { /* one copy of the code for each */
    case 1: contract_blocks(1, bed, x, at, points); break;
    case 2: contract_blocks(2, bed, x, at, points); break;
    case 3: contract_blocks(3, bed, x, at, points); break;
    default: contract_blocks(4, bed, x, at, points); break;
    }
  }
}

/* lines[l] = expand points[l] */
static INLINE void lanes_tile(uint32_t lines, uint32_t blocks, uint32_t line, uint32_t at,
                              const Bed *bed, const float *points, float *out) {
  Tile tile;
  clear_tile(&tile);
  for (uint32_t a = 0; a < bed->columns; a++) {
    Lanes shape[MOST_TILE];
    load_blocks(blocks, bed->expand + a * bed->lanes + at, shape);
    add_to_tile(lines, blocks, &tile, points + line * bed->padded + a, bed->padded, shape);
  }
  store_tile(lines, blocks, &tile, bed->lanes, out + line * bed->lanes + at);
}

/* `blocks` blocks of a wire's lanes from `at` on, a constant where it is called. */
static INLINE void expand_blocks(uint32_t blocks, const Bed *bed, const float *grid, uint32_t at,
                                 float *x) {
  Lanes sum[4];
  for (uint32_t b = 0; b < blocks; b++) sum[b] = zero();
  for (uint32_t a = 0; a < bed->columns; a++) {
    const float *shape = bed->expand + a * bed->lanes + at, point = grid[bed->place[a]];
#  pragma GCC unroll 4 /* or the sums would live in memory */
    for (uint32_t b = 0; b < blocks; b++) sum[b] = add(sum[b], scale(load(shape + 8 * b), point));
  }
  for (uint32_t b = 0; b < blocks; b++) store(x + at + 8 * b, sum[b]);
}

static void expand_wire(const Bed *bed, const float *grid, float *x) {
  for (uint32_t at = 0; at < bed->lanes; at += 32) {
    switch ((bed->lanes - at) / 8u) { /* one copy of the code for each */
    case 1: expand_blocks(1, bed, grid, at, x); break;
    case 2: expand_blocks(2, bed, grid, at, x); break;
    case 3: expand_blocks(3, bed, grid, at, x); break;
    default: expand_blocks(4, bed, grid, at, x); break;
    }
  }
}

static void contract(const Bed *bed, const float *x, float *scratch, float *grid) {
  float *lines = scratch, *points = scratch + bed->lines * bed->lanes;
  if (bed->wires == 1) {
    contract_wire(bed, x, points);
  } else {
    gather_lines(bed, x, lines);
    FOR_TILES(columns_tile, 0, bed->lines, bed->padded / 8u, bed, lines, points)
  }
  for (uint32_t i = 0; i < bed->size; i++) grid[i] = 0.0f;
  for (uint32_t l = 0; l < bed->lines; l++) {
    const uint32_t *place = bed->place + l * bed->columns;
    for (uint32_t a = 0; a < bed->columns; a++) grid[place[a]] = points[l * bed->padded + a];
  }
}

static void expand(const Bed *bed, const float *grid, float *scratch, float *x) {
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
  spread_lines(bed, lines, x);
}
#else
/* ---- along, folded -------------------------------------------------------------------------- */

/* even[j] = x[j] + x[mirror], odd[j] = x[j] - x[mirror]; the middle stands alone. */
static void fold(const TbBed *bed, const double *x, double *even, double *odd) {
  const uint32_t middle = bed->middle;
  for (uint32_t j = 0; j < middle; j++) {
    even[j] = x[j] + x[2 * middle - j];
    odd[j] = x[j] - x[2 * middle - j];
  }
  even[middle] = x[middle];
  odd[middle] = 0.0;
  for (uint32_t j = middle + 1; j < bed->half; j++) even[j] = odd[j] = 0.0;
}

static void unfold(const TbBed *bed, const double *even, const double *odd, double *x) {
  const uint32_t middle = bed->middle;
  for (uint32_t j = 0; j < middle; j++) {
    x[j] = even[j] + odd[j];
    x[2 * middle - j] = even[j] - odd[j];
  }
  x[middle] = even[middle];
}

static uint32_t class_across(const TbBed *bed, uint32_t line) {
  return line >= bed->first_line[1] && bed->quarters == 2 ? 1 : 0;
}

/* The points of one line in a grid vector. */
static uint32_t line_points(const TbBed *bed, uint32_t along, uint32_t line) {
  const uint32_t across = class_across(bed, line);
  return bed->first[tb_bed_class(bed, along, across)] +
         (line - bed->first_line[across]) * bed->columns[along];
}

static void contract_line(const TbBed *bed, uint32_t line, const double *x, double *scratch,
                          double *grid) {
  const double *folded[2] = {scratch, scratch + bed->half};
  double *squeezed = scratch + 2 * bed->half;
  if (bed->halves == 2) {
    fold(bed, x, scratch, scratch + bed->half);
  } else {
    folded[0] = x;
  }
  for (uint32_t along = 0; along < bed->halves; along++) {
    const uint32_t columns = bed->columns[along];
    const double *values = folded[along];
    if (bed->thinned) {
      multiply((columns + 7) / 8, bed->half, squeezed, bed->squeeze[along], values);
      values = squeezed;
    }
    double *points = grid + line_points(bed, along, line);
    for (uint32_t a = 0; a < columns; a++) points[a] = values[a];
  }
}

static void expand_line(const TbBed *bed, uint32_t line, const double *grid, double *scratch,
                        double *x) {
  const double *values[2] = {grid, grid};
  for (uint32_t along = 0; along < bed->halves; along++) {
    values[along] = grid + line_points(bed, along, line);
    if (!bed->thinned) continue;
    double *spread = scratch + along * bed->half;
    multiply(bed->half / 8, bed->columns[along], spread, bed->spread[along], values[along]);
    values[along] = spread;
  }
  if (bed->halves == 2) {
    unfold(bed, values[0], values[1], x);
  } else {
    for (uint32_t j = 0; j < bed->lanes; j++) x[j] = values[0][j];
  }
}

static void contract(const Bed *bed, const double *x, double *scratch, double *grid) {
  double *lines = scratch + 3 * bed->half + 8;
  gather_lines(bed, x, lines);
  for (uint32_t line = 0; line < bed->lines; line++) {
    contract_line(bed, line, lines + line * bed->lanes, scratch, grid);
  }
}

static void expand(const Bed *bed, const double *grid, double *scratch, double *x) {
  double *lines = scratch + 3 * bed->half + 8;
  for (uint32_t line = 0; line < bed->lines; line++) {
    double *own = lines + line * bed->lanes;
    for (uint32_t j = bed->lanes - 8; j < bed->lanes; j++) own[j] = 0.0;
    expand_line(bed, line, grid, scratch, own);
  }
  spread_lines(bed, lines, x);
}
#endif

static void comply(const TYPE_OF(TbCompliance) * compliance, const Real *grid, Real *out) {
  for (uint32_t c = 0; c < compliance->classes; c++) {
    const uint32_t first = compliance->first[c], points = compliance->first[c + 1] - first;
    multiply(points / 8u, points, out + first, compliance->matrix[c], grid + first);
  }
}

#endif
