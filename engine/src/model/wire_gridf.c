/* SPDX-License-Identifier: MIT */
#include "model/wire_gridf.h"

#include <string.h>

static void round_all(double *values, size_t count) {
  for (size_t i = 0; i < count; i++) values[i] = (double)(float)values[i];
}

static void round_bed(TbWireGrid *wire_grid) {
  round_all(wire_grid->across, (size_t)wire_grid->wires * wire_grid->lines);
  for (uint32_t along = 0; along < wire_grid->halves && wire_grid->thinned; along++) {
    round_all(wire_grid->contract[along], (size_t)wire_grid->half * wire_grid->padded[along]);
    round_all(wire_grid->expand[along], (size_t)wire_grid->half * wire_grid->columns[along]);
  }
}

/* Value of one column of a class along, at any lane. */
static double shape_at(const TbWireGrid *wire_grid, uint32_t along, uint32_t column,
                       uint32_t lane) {
  const bool folded = wire_grid->halves == 2, image = folded && lane > wire_grid->middle;
  if (folded && lane > 2 * wire_grid->middle) return 0.0;
  if (along == 1 && lane == wire_grid->middle) return 0.0;
  const uint32_t half = image ? 2 * wire_grid->middle - lane : lane;
  const size_t at = (size_t)column * wire_grid->half + half;
  const double value = wire_grid->expand[along][at];
  return along == 1 && image ? -value : value;
}

static void fill_shapes(TbWireGridF *wire_gridf, const TbWireGrid *wire_grid) {
  for (uint32_t lane = 0; lane < wire_grid->lanes; lane++) {
    uint32_t c = 0;
    for (uint32_t along = 0; along < wire_grid->halves; along++) {
      for (uint32_t a = 0; a < wire_grid->columns[along]; a++, c++) {
        const float shape = (float)shape_at(wire_grid, along, a, lane);
        wire_gridf->contract[0][(size_t)lane * wire_gridf->padded[0] + c] = shape;
        wire_gridf->expand[0][(size_t)c * wire_grid->lanes + lane] = shape;
      }
    }
  }
}

/* The classes of symmetry along stand side by side. */
static void fill_places(TbWireGridF *wire_gridf, const TbWireGrid *wire_grid) {
  uint32_t *place = wire_gridf->place[0];
  for (uint32_t line = 0; line < wire_grid->lines; line++) {
    for (uint32_t along = 0; along < wire_grid->halves; along++) {
      const uint32_t columns = wire_grid->columns[along];
      memcpy(place, wire_grid->place[along] + (size_t)line * columns, columns * sizeof *place);
      place += columns;
    }
  }
}

bool tb_compliancef_prepare(TbComplianceF *compliancef, TbArena *arena,
                            const TbCompliance *compliance) {
  *compliancef = (TbComplianceF){.classes = compliance->classes};
  for (uint32_t c = 0; c <= compliance->classes; c++) compliancef->first[c] = compliance->first[c];
  for (uint32_t c = 0; c < compliance->classes; c++) {
    const size_t points = compliance->first[c + 1] - compliance->first[c];
    float *matrix = tb_arena_take(arena, points * points, sizeof *matrix);
    if (!matrix) return false;
    for (size_t i = 0; i < points * points; i++) matrix[i] = (float)compliance->matrix[c][i];
    compliancef->matrix[c] = matrix;
  }
  return true;
}

/* The classes along as one, with shapes over all lanes. */
static bool fill_along(TbWireGridF *wire_gridf, TbArena *arena, const TbWireGrid *wire_grid) {
  wire_gridf->halves = 1;
  wire_gridf->half = wire_grid->lanes;
  for (uint32_t along = 0; along < wire_grid->halves; along++)
    wire_gridf->columns[0] += wire_grid->columns[along];
  wire_gridf->padded[0] = tb_pad(wire_gridf->columns[0]);
  const size_t lanes = wire_grid->lanes, columns = wire_gridf->columns[0];
  wire_gridf->contract[0] = tb_arena_take(arena, lanes * wire_gridf->padded[0], sizeof(float));
  wire_gridf->expand[0] = tb_arena_take(arena, lanes * columns, sizeof(float));
  wire_gridf->place[0] = tb_arena_take(arena, wire_grid->lines * columns, sizeof(uint32_t));
  if (arena->failed) return false;
  fill_shapes(wire_gridf, wire_grid);
  fill_places(wire_gridf, wire_grid);
  return true;
}

static bool fill_across(TbWireGridF *wire_gridf, TbArena *arena, const TbWireGrid *wire_grid) {
  const size_t across = (size_t)wire_grid->wires * wire_grid->lines;
  wire_gridf->across = tb_arena_take(arena, across, sizeof(float));
  if (arena->failed) return false;
  for (size_t i = 0; i < across; i++) wire_gridf->across[i] = (float)wire_grid->across[i];
  return true;
}

bool tb_wire_gridf_prepare(TbWireGridF *wire_gridf, TbArena *arena, TbWireGrid *wire_grid) {
  round_bed(wire_grid);
  *wire_gridf = (TbWireGridF){.wires = wire_grid->wires,
                              .lanes = wire_grid->lanes,
                              .quarters = wire_grid->quarters,
                              .middle = wire_grid->middle,
                              .lines = wire_grid->lines,
                              .thinned = wire_grid->thinned,
                              .size = wire_grid->size};
  memcpy(wire_gridf->first_line, wire_grid->first_line, sizeof wire_gridf->first_line);
  memcpy(wire_gridf->first, wire_grid->first, sizeof wire_gridf->first);
  if (!fill_across(wire_gridf, arena, wire_grid)) return false;
  if (wire_grid->thinned) return fill_along(wire_gridf, arena, wire_grid);
  wire_gridf->halves = wire_grid->halves;
  wire_gridf->half = wire_grid->half;
  memcpy(wire_gridf->columns, wire_grid->columns, sizeof wire_gridf->columns);
  return true;
}
