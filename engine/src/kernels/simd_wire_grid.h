/* SPDX-License-Identifier: MIT */
/* Transfer between wires and the grid under them (wire_grid.h) in the precision of simd_lanes.h. A
 * lane of the wire grid is a contact point along a wire; `Lanes` holds eight SIMD lanes. For
 * kernels_tmpl.c alone. */
#ifndef TB_SIMD_WIRE_GRID_H
#define TB_SIMD_WIRE_GRID_H

#include <stddef.h>

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

/* sum[b] = Sum over `count` lines of across[l] lines[l] */
static INLINE void spread_parity(uint32_t blocks, uint32_t count, size_t step, const Real *across,
                                 const Real *lines, Lanes *sum) {
  UNROLL(4)
  for (uint32_t b = 0; b < blocks; b++) sum[b] = zero();
  for (const Real *end = across + count; across < end; across++, lines += step) {
    UNROLL(4)
    for (uint32_t b = 0; b < blocks; b++) {
      sum[b] = add(sum[b], scale(load(lines + 8u * b), *across));
    }
  }
}

/* For one pair: x[v], x[image] = Sum over even lines +- Sum over odd lines */
static INLINE void spread_tile(uint32_t lines, uint32_t blocks, uint32_t pair, uint32_t at,
                               const Bed *wire_grid, const Real *from, Real *x) {
  const size_t step = wire_grid->lanes;
  const uint32_t even = wire_grid->first_line[1], odd = wire_grid->lines - even;
  for (uint32_t w = pair; w < pair + lines; w++) {
    const Real *across = wire_grid->across + w * wire_grid->lines;
    Real *own = x + w * wire_grid->lanes + at,
         *image = x + image_of(wire_grid, w) * wire_grid->lanes + at;
    Lanes s[MOST_BLOCKS], d[MOST_BLOCKS];
    spread_parity(blocks, even, step, across, from + at, s);
    spread_parity(blocks, odd, step, across + even, from + even * step + at, d);
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

/* even[j] = x[j] + x[mirror], odd[j] = x[j] - x[mirror]; the middle has no mirror image. The
 * numbers after the middle are noise. Reads up to 7 elements before x. */
static void fold(const Bed *wire_grid, const Real *x, Real *even, Real *odd) {
  const uint32_t middle = wire_grid->middle;
  const Real *mirror = x + 2u * (size_t)middle;
  for (uint32_t j = 0; j <= middle; j += 8) {
    const Lanes own = load(x + j), other = reverse(load_unaligned(mirror - j - 7));
    store_unaligned(even + j, add(own, other));
    store_unaligned(odd + j, subtract(own, other));
  }
  even[middle] = x[middle];
  odd[middle] = REAL(0.0);
}

/* Writes up to 7 elements after the lanes. */
static void unfold(const Bed *wire_grid, const Real *even, const Real *odd, Real *x) {
  const uint32_t middle = wire_grid->middle, real = 2u * middle + 1u;
  for (uint32_t j = 0; j <= middle; j += 8) {
    store(x + j, add(load_unaligned(even + j), load_unaligned(odd + j)));
  }
  x[middle] = even[middle];
  for (uint32_t j = middle + 1; j < real; j += 8) {
    const size_t mirror = 2u * middle - j; /* and the 7 before it */
    const Lanes e = load_unaligned(even + mirror - 7), o = load_unaligned(odd + mirror - 7);
    store_unaligned(x + j, reverse(subtract(e, o)));
  }
  for (uint32_t j = real; j < wire_grid->lanes; j++) x[j] = REAL(0.0);
}

/* ---- both ----------------------------------------------------------------------------------- */

/* Parts of the scratch, after TB_WIRE_GRID_SLACK. */
typedef struct Room {
  Real *lines;     /* [lines][lanes] */
  Real *folded[2]; /* [lines][half] for each class along, or [lines][columns] */
  Real *points;    /* [lines][padded] */
} Room;

static Room room_in(const Bed *wire_grid, Real *scratch) {
  Real *lines = scratch + TB_WIRE_GRID_SLACK, *folded = lines + wire_grid->lines * wire_grid->lanes;
  return (Room){lines,
                {folded, folded + wire_grid->lines * wire_grid->half},
                folded + 2u * wire_grid->lines * wire_grid->half};
}

static void copy_lanes(uint32_t n, const Real *from, Real *to) {
  for (uint32_t i = 0; i < n; i += 8) store_unaligned(to + i, load_unaligned(from + i));
}

/* A single wire is its line across itself. */
static void rows_to_lines(const Bed *wire_grid, const Real *x, Real *lines) {
  if (wire_grid->wires > 1) {
    gather_lines(wire_grid, x, lines);
  } else {
    copy_lanes(wire_grid->lanes, x, lines);
  }
}

static void lines_to_rows(const Bed *wire_grid, const Real *lines, Real *x) {
  if (wire_grid->wires > 1) {
    spread_lines(wire_grid, lines, x);
  } else {
    copy_lanes(wire_grid->lanes, lines, x);
  }
}

/* Folds all lines, or unfolds them; `step` is from one line's values to the next. Lines go upwards,
 * so that each overwrites what the one before has left beyond its end. */
static void fold_lines(const Bed *wire_grid, uint32_t step, const Room *room) {
  for (uint32_t l = 0; l < wire_grid->lines; l++) {
    fold(wire_grid, room->lines + l * wire_grid->lanes, room->folded[0] + l * step,
         room->folded[1] + l * step);
  }
}

static void unfold_lines(const Bed *wire_grid, uint32_t step, const Room *room) {
  for (uint32_t l = 0; l < wire_grid->lines; l++) {
    unfold(wire_grid, room->folded[0] + l * step, room->folded[1] + l * step,
           room->lines + l * wire_grid->lanes);
  }
}

/* A class without thinning is a run of its lines' values, without a gap, and padding. */
typedef struct Run {
  uint32_t first, count; /* in the grid */
  uint32_t from;         /* in the lines' values */
} Run;

static Run run_of(const Bed *wire_grid, uint32_t along, uint32_t across) {
  const uint32_t *line = wire_grid->first_line + across, columns = wire_grid->columns[along];
  return (Run){wire_grid->first[along * wire_grid->quarters + across],
               (line[1] - line[0]) * columns, line[0] * columns};
}

static void values_to_grid(const Bed *wire_grid, uint32_t along, const Real *values, Real *grid) {
  for (uint32_t across = 0; across < wire_grid->quarters; across++) {
    const Run run = run_of(wire_grid, along, across);
    copy_lanes(run.count, values + run.from, grid + run.first);
    for (uint32_t i = run.count; i % 8u; i++) grid[run.first + i] = REAL(0.0);
  }
}

static void grid_to_values(const Bed *wire_grid, uint32_t along, const Real *grid, Real *values) {
  for (uint32_t across = 0; across < wire_grid->quarters; across++) {
    const Run run = run_of(wire_grid, along, across);
    copy_lanes(run.count, grid + run.first, values + run.from);
  }
}

/* Without thinning each point is a sum or a difference of two lanes, or a lane. */
static void contract_lanes(const Bed *wire_grid, const Room *room, Real *grid) {
  if (wire_grid->halves == 1) {
    values_to_grid(wire_grid, 0, room->lines, grid);
    return;
  }
  fold_lines(wire_grid, wire_grid->columns[0], room);
  for (uint32_t along = 0; along < 2; along++) {
    values_to_grid(wire_grid, along, room->folded[along], grid);
  }
}

static void expand_lanes(const Bed *wire_grid, const Real *grid, const Room *room) {
  if (wire_grid->halves == 1) {
    grid_to_values(wire_grid, 0, grid, room->lines);
    return;
  }
  for (uint32_t along = 0; along < 2; along++) {
    grid_to_values(wire_grid, along, grid, room->folded[along]);
  }
  unfold_lines(wire_grid, wire_grid->columns[0], room);
}

static void fold_with_padding(const Bed *wire_grid, const Room *room) {
  fold_lines(wire_grid, wire_grid->half, room);
  for (uint32_t l = 0; l < wire_grid->lines; l++) {
    for (uint32_t j = wire_grid->middle + 1; j < wire_grid->half; j++) {
      room->folded[0][l * wire_grid->half + j] = REAL(0.0);
      room->folded[1][l * wire_grid->half + j] = REAL(0.0);
    }
  }
}

static void contract_thinned(const Bed *wire_grid, const Room *room, Real *grid) {
  if (wire_grid->halves == 2) fold_with_padding(wire_grid, room);
  for (uint32_t i = 0; i < wire_grid->size; i++) grid[i] = REAL(0.0);
  for (uint32_t along = 0; along < wire_grid->halves; along++) {
    const Real *values = wire_grid->halves == 2 ? room->folded[along] : room->lines;
    const uint32_t columns = wire_grid->columns[along], *place = wire_grid->place[along];
    FOR_TILES(columns_tile, 0, wire_grid->lines, wire_grid->padded[along] / 8u, wire_grid, along,
              values, room->points)
    const Real *points = room->points;
    for (uint32_t l = 0; l < wire_grid->lines; l++, place += columns) {
      for (uint32_t a = 0; a < columns; a++) grid[place[a]] = points[a];
      points += wire_grid->padded[along];
    }
  }
}

static void expand_thinned(const Bed *wire_grid, const Real *grid, const Room *room) {
  for (uint32_t along = 0; along < wire_grid->halves; along++) {
    Real *values = wire_grid->halves == 2 ? room->folded[along] : room->lines;
    const uint32_t columns = wire_grid->columns[along], *place = wire_grid->place[along];
    const uint32_t copied = wire_grid->lines == 1 ? 0 : wire_grid->lines;
    Real *points = room->points;
    for (uint32_t l = 0; l < copied; l++, place += columns) {
      for (uint32_t a = 0; a < columns; a++) points[a] = grid[place[a]];
      points += wire_grid->padded[along];
    }
    FOR_TILES(lanes_tile, 0, wire_grid->lines, wire_grid->half / 8u, wire_grid, along, grid,
              room->points, values)
  }
  if (wire_grid->halves == 2) unfold_lines(wire_grid, wire_grid->half, room);
}

static void rows_to_grid(const Bed *wire_grid, const Real *x, Real *scratch, Real *grid) {
  const Room room = room_in(wire_grid, scratch);
  rows_to_lines(wire_grid, x, room.lines);
  if (wire_grid->thinned) {
    contract_thinned(wire_grid, &room, grid);
  } else {
    contract_lanes(wire_grid, &room, grid);
  }
}

static void grid_to_rows(const Bed *wire_grid, const Real *grid, Real *scratch, Real *x) {
  const Room room = room_in(wire_grid, scratch);
  if (wire_grid->thinned) {
    expand_thinned(wire_grid, grid, &room);
  } else {
    expand_lanes(wire_grid, grid, &room);
  }
  lines_to_rows(wire_grid, room.lines, x);
}

static void apply_compliance(const TYPE_OF(TbCompliance) * compliance, const Real *grid,
                             Real *out) {
  for (uint32_t c = 0; c < compliance->classes; c++) {
    const uint32_t first = compliance->first[c], points = compliance->first[c + 1] - first;
    gemv(points / 8u, points, out + first, compliance->matrix[c], grid + first);
  }
}

#endif
