/* SPDX-License-Identifier: MIT */
/* Transfer between wires and the grid under them (wire_grid.h) in the precision of simd_lanes.h. A
 * lane of the wire grid is a contact point along a wire; `Lanes` holds eight SIMD lanes. For
 * kernels_tmpl.c alone. */
#ifndef TB_SIMD_WIRE_GRID_H
#define TB_SIMD_WIRE_GRID_H

#include "kernels/kernels.h"
#include "kernels/simd_lanes.h"
#include "kernels/simd_tables.h"

typedef TYPE_OF(TbWireGrid) Bed;

/* ---- across --------------------------------------------------------------------------------- */

/* A tile of sums stays in registers: `lines` lines of `blocks` times eight lanes or columns, both
 * constants at every call. Each sum runs term by term in ascending order, whatever the tile. */
enum { MOST_LINES = 3, MOST_BLOCKS = 4 };

typedef struct Tile {
  Lanes sum[MOST_LINES][MOST_BLOCKS];
} Tile;

static INLINE uint32_t most_blocks(uint32_t lines) {
  if (lines == 1) return PARTS == 4 ? 2 : 4;
  if (PARTS == 1 || SINGLE) return 3;
  return PARTS == 2 ? 2 : 1;
}

static INLINE void clear_tile(Tile *tile) {
  for (uint32_t l = 0; l < MOST_LINES; l++) {
    for (uint32_t b = 0; b < MOST_BLOCKS; b++) tile->sum[l][b] = zero();
  }
}

/* sum[l][b] += factor[l * step] x[b] */
static INLINE void add_to_tile(uint32_t lines, uint32_t blocks, Tile *tile, const Real *factor,
                               uint32_t step, const Lanes *x) {
  UNROLL(3)
  for (uint32_t l = 0; l < lines; l++) {
    UNROLL(4)
    for (uint32_t b = 0; b < blocks; b++) {
      tile->sum[l][b] = add(tile->sum[l][b], scale(x[b], factor[l * step]));
    }
  }
}

static INLINE void store_tile(uint32_t lines, uint32_t blocks, const Tile *tile, uint32_t step,
                              Real *out) {
  UNROLL(3)
  for (uint32_t l = 0; l < lines; l++) {
    UNROLL(4)
    for (uint32_t b = 0; b < blocks; b++) store(out + l * step + 8u * b, tile->sum[l][b]);
  }
}

static INLINE void load_blocks(uint32_t blocks, const Real *at, Lanes *x) {
  UNROLL(4)
  for (uint32_t b = 0; b < blocks; b++) x[b] = load(at + 8u * b);
}

/* Calls tile(lines, blocks, ...) for the lines from `first_line` to `line_end` and `block_count`
 * blocks. Each size of tile has its own copy of the code. */
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

/* Index of a wire's mirror image, and number of pairs. */
static INLINE uint32_t image_of(const Bed *wire_grid, uint32_t wire) {
  return wire_grid->quarters == 2 ? wire_grid->wires - 1u - wire : wire;
}
static INLINE uint32_t pairs_of(const Bed *wire_grid) {
  return wire_grid->quarters == 2 ? (wire_grid->wires + 1u) / 2u : wire_grid->wires;
}

/* lines[l] = Sum across (x[v] +- x[image]) */
static INLINE void gather_tile(uint32_t lines, uint32_t blocks, uint32_t line, uint32_t at,
                               const Bed *wire_grid, bool odd, const Real *x, Real *to) {
  Tile tile;
  clear_tile(&tile);
  for (uint32_t w = 0; w < pairs_of(wire_grid); w++) {
    const uint32_t image = image_of(wire_grid, w);
    Lanes own[MOST_BLOCKS], other[MOST_BLOCKS];
    load_blocks(blocks, x + w * wire_grid->lanes + at, own);
    if (image != w) {
      load_blocks(blocks, x + image * wire_grid->lanes + at, other);
      UNROLL(3)
      for (uint32_t b = 0; b < blocks; b++) {
        own[b] = odd ? subtract(own[b], other[b]) : add(own[b], other[b]);
      }
    }
    add_to_tile(lines, blocks, &tile, wire_grid->across + w * wire_grid->lines + line, 1, own);
  }
  store_tile(lines, blocks, &tile, wire_grid->lanes, to + line * wire_grid->lanes + at);
}

static INLINE void spread_parity(uint32_t blocks, const Bed *wire_grid, uint32_t from, uint32_t end,
                                 const Real *across, const Real *lines, Lanes *sum) {
  for (uint32_t b = 0; b < blocks; b++) sum[b] = zero();
  for (uint32_t l = from; l < end; l++) {
    UNROLL(4)
    for (uint32_t b = 0; b < blocks; b++) {
      sum[b] = add(sum[b], scale(load(lines + l * wire_grid->lanes + 8u * b), across[l]));
    }
  }
}

/* For one pair: x[v], x[image] = Sum over even lines +- Sum over odd lines */
static INLINE void spread_tile(uint32_t lines, uint32_t blocks, uint32_t pair, uint32_t at,
                               const Bed *wire_grid, const Real *from, Real *x) {
  for (uint32_t w = pair; w < pair + lines; w++) {
    const Real *across = wire_grid->across + w * wire_grid->lines;
    Real *own = x + w * wire_grid->lanes + at,
         *image = x + image_of(wire_grid, w) * wire_grid->lanes + at;
    Lanes s[MOST_BLOCKS], d[MOST_BLOCKS];
    spread_parity(blocks, wire_grid, 0, wire_grid->first_line[1], across, from + at, s);
    spread_parity(blocks, wire_grid, wire_grid->first_line[1], wire_grid->lines, across, from + at,
                  d);
    UNROLL(4)
    for (uint32_t b = 0; b < blocks; b++) {
      store(image + 8u * b, subtract(s[b], d[b]));
      store(own + 8u * b, add(s[b], d[b]));
    }
  }
}

/* lines[l] = Sum over pairs of across[v][l] (x[v] +- x[image]) */
static void gather_lines(const Bed *wire_grid, const Real *x, Real *lines) {
  FOR_TILES(gather_tile, 0, wire_grid->first_line[1], wire_grid->lanes / 8u, wire_grid, false, x,
            lines)
  FOR_TILES(gather_tile, wire_grid->first_line[1], wire_grid->lines, wire_grid->lanes / 8u,
            wire_grid, true, x, lines)
}

static void spread_lines(const Bed *wire_grid, const Real *lines, Real *x) {
  FOR_TILES(spread_tile, 0, pairs_of(wire_grid), wire_grid->lanes / 8u, wire_grid, lines, x)
}

/* ---- along ---------------------------------------------------------------------------------- */

/* points[l] = contract^T values[l]. A single wire has few points in contact, so points without
 * force are skipped. */
static INLINE void columns_tile(uint32_t lines, uint32_t blocks, uint32_t line, uint32_t at,
                                const Bed *wire_grid, uint32_t along, const Real *values,
                                Real *points) {
  const uint32_t padded = wire_grid->padded[along];
  const Real *from = values + line * wire_grid->half, *shapes = wire_grid->contract[along] + at;
  Tile tile;
  clear_tile(&tile);
  for (uint32_t j = 0; j < wire_grid->half; j++) {
    Lanes shape[MOST_BLOCKS];
    if (lines == 1 && from[j] == REAL(0.0)) continue;
    load_blocks(blocks, shapes + j * padded, shape);
    add_to_tile(lines, blocks, &tile, from + j, wire_grid->half, shape);
  }
  store_tile(lines, blocks, &tile, padded, points + line * padded + at);
}

/* values[l] = expand points[l]. The points of a single line are read directly from the grid. */
static INLINE void lanes_tile(uint32_t lines, uint32_t blocks, uint32_t line, uint32_t at,
                              const Bed *wire_grid, uint32_t along, const Real *grid,
                              const Real *points, Real *values) {
  const uint32_t padded = wire_grid->padded[along], columns = wire_grid->columns[along];
  const uint32_t *place = wire_grid->place[along] + line * columns;
  const Real *from = points + line * padded, *shapes = wire_grid->expand[along] + at;
  Tile tile;
  clear_tile(&tile);
  for (uint32_t a = 0; a < columns; a++) {
    Lanes shape[MOST_BLOCKS];
    load_blocks(blocks, shapes + a * wire_grid->half, shape);
    add_to_tile(lines, blocks, &tile, lines == 1 ? grid + place[a] : from + a, padded, shape);
  }
  store_tile(lines, blocks, &tile, wire_grid->half, values + line * wire_grid->half + at);
}

/* even[j] = x[j] + x[mirror], odd[j] = x[j] - x[mirror]; the middle has no mirror image. */
static void fold(const Bed *wire_grid, const Real *x, Real *even, Real *odd) {
  const uint32_t middle = wire_grid->middle;
  for (uint32_t j = 0; j < middle; j++) {
    even[j] = x[j] + x[2 * middle - j];
    odd[j] = x[j] - x[2 * middle - j];
  }
  even[middle] = x[middle];
  odd[middle] = REAL(0.0);
  for (uint32_t j = middle + 1; j < wire_grid->half; j++) even[j] = odd[j] = REAL(0.0);
}

static void unfold(const Bed *wire_grid, const Real *even, const Real *odd, Real *x) {
  const uint32_t middle = wire_grid->middle;
  for (uint32_t j = 0; j < middle; j++) {
    x[j] = even[j] + odd[j];
    x[2 * middle - j] = even[j] - odd[j];
  }
  x[middle] = even[middle];
  for (uint32_t j = 2 * middle + 1; j < wire_grid->lanes; j++) x[j] = REAL(0.0);
}

/* ---- both ----------------------------------------------------------------------------------- */

/* Parts of the scratch. */
typedef struct Room {
  Real *lines;     /* [lines][lanes] */
  Real *folded[2]; /* [lines][half] for each class along */
  Real *points;    /* [lines][padded] */
} Room;

static Room room_in(const Bed *wire_grid, Real *scratch) {
  Real *folded = scratch + wire_grid->lines * wire_grid->lanes;
  return (Room){scratch,
                {folded, folded + wire_grid->lines * wire_grid->half},
                folded + 2u * wire_grid->lines * wire_grid->half};
}

static void contract(const Bed *wire_grid, const Real *x, Real *scratch, Real *grid) {
  const Room room = room_in(wire_grid, scratch);
  const Real *lines =
    wire_grid->wires > 1 ? room.lines : x; /* one wire is its line across itself */
  if (wire_grid->wires > 1) gather_lines(wire_grid, x, room.lines);
  for (uint32_t l = 0; wire_grid->halves == 2 && l < wire_grid->lines; l++) {
    fold(wire_grid, lines + l * wire_grid->lanes, room.folded[0] + l * wire_grid->half,
         room.folded[1] + l * wire_grid->half);
  }
  for (uint32_t i = 0; i < wire_grid->size; i++) grid[i] = REAL(0.0);
  for (uint32_t along = 0; along < wire_grid->halves; along++) {
    const Real *values = wire_grid->halves == 2 ? room.folded[along] : lines;
    const uint32_t columns = wire_grid->columns[along], *place = wire_grid->place[along];
    if (wire_grid->thinned) {
      FOR_TILES(columns_tile, 0, wire_grid->lines, wire_grid->padded[along] / 8u, wire_grid, along,
                values, room.points)
    }
    const Real *points = wire_grid->thinned ? room.points : values;
    const uint32_t step = wire_grid->thinned ? wire_grid->padded[along] : wire_grid->half;
    for (uint32_t l = 0; l < wire_grid->lines; l++, place += columns, points += step) {
      for (uint32_t a = 0; a < columns; a++) grid[place[a]] = points[a];
    }
  }
}

static void expand(const Bed *wire_grid, const Real *grid, Real *scratch, Real *x) {
  const Room room = room_in(wire_grid, scratch);
  Real *lines = wire_grid->wires > 1 ? room.lines : x;
  for (uint32_t along = 0; along < wire_grid->halves; along++) {
    Real *values = wire_grid->halves == 2 ? room.folded[along] : lines;
    const uint32_t columns = wire_grid->columns[along], *place = wire_grid->place[along];
    Real *points = wire_grid->thinned ? room.points : values;
    const uint32_t step = wire_grid->thinned ? wire_grid->padded[along] : wire_grid->half;
    const uint32_t copied = wire_grid->thinned && wire_grid->lines == 1 ? 0 : wire_grid->lines;
    for (uint32_t l = 0; l < copied; l++, place += columns, points += step) {
      for (uint32_t a = 0; a < columns; a++) points[a] = grid[place[a]];
    }
    if (wire_grid->thinned) {
      FOR_TILES(lanes_tile, 0, wire_grid->lines, wire_grid->half / 8u, wire_grid, along, grid,
                room.points, values)
    }
  }
  for (uint32_t l = 0; wire_grid->halves == 2 && l < wire_grid->lines; l++) {
    unfold(wire_grid, room.folded[0] + l * wire_grid->half, room.folded[1] + l * wire_grid->half,
           lines + l * wire_grid->lanes);
  }
  if (wire_grid->wires > 1) spread_lines(wire_grid, room.lines, x);
}

static void comply(const TYPE_OF(TbCompliance) * compliance, const Real *grid, Real *out) {
  for (uint32_t c = 0; c < compliance->classes; c++) {
    const uint32_t first = compliance->first[c], points = compliance->first[c + 1] - first;
    multiply(points / 8u, points, out + first, compliance->matrix[c], grid + first);
  }
}

#endif
