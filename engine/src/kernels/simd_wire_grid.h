/* SPDX-License-Identifier: MIT */
/* Between wires and the grid under them (wire_grid.h) in the precision of simd_lanes.h. For kernels_tmpl.c alone. */
#ifndef TB_SIMD_WIRE_GRID_H
#define TB_SIMD_WIRE_GRID_H

#include "kernels/kernels.h"
#include "kernels/simd_lanes.h"
#include "kernels/simd_tables.h"

typedef TYPE_OF(TbWireGrid) Bed;

/* ---- across --------------------------------------------------------------------------------- */

/* Tiles of sums that stay in registers: `lines` lines of `blocks` times eight lanes or columns, both constants
 * where they are called. Each sum runs term by term in ascending order, whatever the tile. */
enum { MOST_LINES = 3, MOST_BLOCKS = 4 };

typedef struct Tile {
  Lanes sum[MOST_LINES][MOST_BLOCKS];
} Tile;

static INLINE uint32_t most_blocks(uint32_t lines) {
  if (lines == 1) return PARTS == 4 ? 2 : 4;
  return PARTS == 1 || SINGLE ? 3 : 1;
}

static INLINE void clear_tile(Tile *tile) {
  for (uint32_t l = 0; l < MOST_LINES; l++) {
    for (uint32_t b = 0; b < MOST_BLOCKS; b++) tile->sum[l][b] = zero();
  }
}

/* sum[l][b] += factor[l * step] x[b] */
static INLINE void add_to_tile(uint32_t lines, uint32_t blocks, Tile *tile, const Real *factor,
                               uint32_t step, const Lanes *x) {
#pragma GCC unroll 3
  for (uint32_t l = 0; l < lines; l++) {
#pragma GCC unroll 4
    for (uint32_t b = 0; b < blocks; b++) {
      tile->sum[l][b] = add(tile->sum[l][b], scale(x[b], factor[l * step]));
    }
  }
}

static INLINE void store_tile(uint32_t lines, uint32_t blocks, const Tile *tile, uint32_t step,
                              Real *out) {
#pragma GCC unroll 3
  for (uint32_t l = 0; l < lines; l++) {
#pragma GCC unroll 4
    for (uint32_t b = 0; b < blocks; b++) store(out + l * step + 8u * b, tile->sum[l][b]);
  }
}

static INLINE void load_blocks(uint32_t blocks, const Real *at, Lanes *x) {
#pragma GCC unroll 4
  for (uint32_t b = 0; b < blocks; b++) x[b] = load(at + 8u * b);
}

/* Calls tile(lines, blocks, ...) for the lines from `first_line` to `line_end` and `block_count` blocks, each tile a
 * copy of the code of its own size. */
#define FOR_TILES(tile, first_line, line_end, block_count, ...)                                    \
  for (uint32_t line_ = (first_line); line_ < (line_end); line_ += MOST_LINES) {                   \
    const uint32_t lines_ = (line_end)-line_ < MOST_LINES ? (line_end)-line_ : MOST_LINES;         \
    const uint32_t most_ = most_blocks(lines_);                                                    \
    for (uint32_t block_ = 0; block_ < (block_count); block_ += most_) {                           \
      const uint32_t left_ = (block_count)-block_;                                                 \
      switch (8u * lines_ + (left_ < most_ ? left_ : most_)) {                                     \
      case 9: tile(1, 1, line_, 8u * block_, __VA_ARGS__); break;                                  \
      case 10: tile(1, 2, line_, 8u * block_, __VA_ARGS__); break;                                 \
      case 11: tile(1, 3, line_, 8u * block_, __VA_ARGS__); break;                                 \
      case 12: tile(1, 4, line_, 8u * block_, __VA_ARGS__); break;                                 \
      case 17: tile(2, 1, line_, 8u * block_, __VA_ARGS__); break;                                 \
      case 18: tile(2, 2, line_, 8u * block_, __VA_ARGS__); break;                                 \
      case 19: tile(2, 3, line_, 8u * block_, __VA_ARGS__); break;                                 \
      case 25: tile(3, 1, line_, 8u * block_, __VA_ARGS__); break;                                 \
      case 26: tile(3, 2, line_, 8u * block_, __VA_ARGS__); break;                                 \
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
    Lanes own[MOST_BLOCKS], other[MOST_BLOCKS];
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
#pragma GCC unroll 4
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
    Lanes s[MOST_BLOCKS], d[MOST_BLOCKS];
    spread_parity(blocks, bed, 0, bed->first_line[1], across, from + at, s);
    spread_parity(blocks, bed, bed->first_line[1], bed->lines, across, from + at, d);
#pragma GCC unroll 4
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

/* ---- along ---------------------------------------------------------------------------------- */

/* points[l] = contract^T values[l]. Few points of a single wire touch: those without force are passed over. */
static INLINE void columns_tile(uint32_t lines, uint32_t blocks, uint32_t line, uint32_t at,
                                const Bed *bed, uint32_t along, const Real *values, Real *points) {
  const uint32_t padded = bed->padded[along];
  const Real *from = values + line * bed->half, *shapes = bed->contract[along] + at;
  Tile tile;
  clear_tile(&tile);
  for (uint32_t j = 0; j < bed->half; j++) {
    Lanes shape[MOST_BLOCKS];
    if (lines == 1 && from[j] == REAL(0.0)) continue;
    load_blocks(blocks, shapes + j * padded, shape);
    add_to_tile(lines, blocks, &tile, from + j, bed->half, shape);
  }
  store_tile(lines, blocks, &tile, padded, points + line * padded + at);
}

/* values[l] = expand points[l]; a single line's points are read off the grid. */
static INLINE void lanes_tile(uint32_t lines, uint32_t blocks, uint32_t line, uint32_t at,
                              const Bed *bed, uint32_t along, const Real *grid, const Real *points,
                              Real *values) {
  const uint32_t padded = bed->padded[along], columns = bed->columns[along];
  const uint32_t *place = bed->place[along] + line * columns;
  const Real *from = points + line * padded, *shapes = bed->expand[along] + at;
  Tile tile;
  clear_tile(&tile);
  for (uint32_t a = 0; a < columns; a++) {
    Lanes shape[MOST_BLOCKS];
    load_blocks(blocks, shapes + a * bed->half, shape);
    add_to_tile(lines, blocks, &tile, lines == 1 ? grid + place[a] : from + a, padded, shape);
  }
  store_tile(lines, blocks, &tile, bed->half, values + line * bed->half + at);
}

/* even[j] = x[j] + x[mirror], odd[j] = x[j] - x[mirror]; the middle stands alone. */
static void fold(const Bed *bed, const Real *x, Real *even, Real *odd) {
  const uint32_t middle = bed->middle;
  for (uint32_t j = 0; j < middle; j++) {
    even[j] = x[j] + x[2 * middle - j];
    odd[j] = x[j] - x[2 * middle - j];
  }
  even[middle] = x[middle];
  odd[middle] = REAL(0.0);
  for (uint32_t j = middle + 1; j < bed->half; j++) even[j] = odd[j] = REAL(0.0);
}

static void unfold(const Bed *bed, const Real *even, const Real *odd, Real *x) {
  const uint32_t middle = bed->middle;
  for (uint32_t j = 0; j < middle; j++) {
    x[j] = even[j] + odd[j];
    x[2 * middle - j] = even[j] - odd[j];
  }
  x[middle] = even[middle];
  for (uint32_t j = 2 * middle + 1; j < bed->lanes; j++) x[j] = REAL(0.0);
}

/* ---- both ----------------------------------------------------------------------------------- */

/* Parts of the scratch. */
typedef struct Room {
  Real *lines;     /* [lines][lanes] */
  Real *folded[2]; /* [lines][half], each class along by itself */
  Real *points;    /* [lines][padded] */
} Room;

static Room room_in(const Bed *bed, Real *scratch) {
  Real *folded = scratch + bed->lines * bed->lanes;
  return (Room){
    scratch, {folded, folded + bed->lines * bed->half}, folded + 2u * bed->lines * bed->half};
}

static void contract(const Bed *bed, const Real *x, Real *scratch, Real *grid) {
  const Room room = room_in(bed, scratch);
  const Real *lines = bed->wires > 1 ? room.lines : x; /* one wire is its line across itself */
  if (bed->wires > 1) gather_lines(bed, x, room.lines);
  for (uint32_t l = 0; bed->halves == 2 && l < bed->lines; l++) {
    fold(bed, lines + l * bed->lanes, room.folded[0] + l * bed->half,
         room.folded[1] + l * bed->half);
  }
  for (uint32_t i = 0; i < bed->size; i++) grid[i] = REAL(0.0);
  for (uint32_t along = 0; along < bed->halves; along++) {
    const Real *values = bed->halves == 2 ? room.folded[along] : lines;
    const uint32_t columns = bed->columns[along], *place = bed->place[along];
    if (bed->thinned) {
      FOR_TILES(columns_tile, 0, bed->lines, bed->padded[along] / 8u, bed, along, values,
                room.points)
    }
    const Real *points = bed->thinned ? room.points : values;
    const uint32_t step = bed->thinned ? bed->padded[along] : bed->half;
    for (uint32_t l = 0; l < bed->lines; l++, place += columns, points += step) {
      for (uint32_t a = 0; a < columns; a++) grid[place[a]] = points[a];
    }
  }
}

static void expand(const Bed *bed, const Real *grid, Real *scratch, Real *x) {
  const Room room = room_in(bed, scratch);
  Real *lines = bed->wires > 1 ? room.lines : x;
  for (uint32_t along = 0; along < bed->halves; along++) {
    Real *values = bed->halves == 2 ? room.folded[along] : lines;
    const uint32_t columns = bed->columns[along], *place = bed->place[along];
    Real *points = bed->thinned ? room.points : values;
    const uint32_t step = bed->thinned ? bed->padded[along] : bed->half;
    const uint32_t copied = bed->thinned && bed->lines == 1 ? 0 : bed->lines;
    for (uint32_t l = 0; l < copied; l++, place += columns, points += step) {
      for (uint32_t a = 0; a < columns; a++) points[a] = grid[place[a]];
    }
    if (bed->thinned) {
      FOR_TILES(lanes_tile, 0, bed->lines, bed->half / 8u, bed, along, grid, room.points, values)
    }
  }
  for (uint32_t l = 0; bed->halves == 2 && l < bed->lines; l++) {
    unfold(bed, room.folded[0] + l * bed->half, room.folded[1] + l * bed->half,
           lines + l * bed->lanes);
  }
  if (bed->wires > 1) spread_lines(bed, room.lines, x);
}

static void comply(const TYPE_OF(TbCompliance) * compliance, const Real *grid, Real *out) {
  for (uint32_t c = 0; c < compliance->classes; c++) {
    const uint32_t first = compliance->first[c], points = compliance->first[c + 1] - first;
    multiply(points / 8u, points, out + first, compliance->matrix[c], grid + first);
  }
}

#endif
