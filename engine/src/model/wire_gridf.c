/* SPDX-License-Identifier: MIT */
#include "model/wire_gridf.h"

#include <string.h>

static void round_all(double *values, size_t count) {
  for (size_t i = 0; i < count; i++) values[i] = (double)(float)values[i];
}

static void round_bed(TbWireGrid *bed) {
  round_all(bed->across, (size_t)bed->wires * bed->lines);
  for (uint32_t along = 0; along < bed->halves && bed->thinned; along++) {
    round_all(bed->contract[along], (size_t)bed->half * bed->padded[along]);
    round_all(bed->expand[along], (size_t)bed->half * bed->columns[along]);
  }
}

/* Of one column of a class along, at any lane. */
static double shape_at(const TbWireGrid *bed, uint32_t along, uint32_t column, uint32_t lane) {
  const bool folded = bed->halves == 2, image = folded && lane > bed->middle;
  if (folded && lane > 2 * bed->middle) return 0.0;
  if (along == 1 && lane == bed->middle) return 0.0;
  const uint32_t half = image ? 2 * bed->middle - lane : lane;
  const size_t at = (size_t)column * bed->half + half;
  const double value = bed->thinned ? bed->expand[along][at] : (half == column ? 1.0 : 0.0);
  return along == 1 && image ? -value : value;
}

static void fill_shapes(TbWireGridF *bedf, const TbWireGrid *bed) {
  for (uint32_t lane = 0; lane < bed->lanes; lane++) {
    uint32_t c = 0;
    for (uint32_t along = 0; along < bed->halves; along++) {
      for (uint32_t a = 0; a < bed->columns[along]; a++, c++) {
        const float shape = (float)shape_at(bed, along, a, lane);
        bedf->contract[0][(size_t)lane * bedf->padded[0] + c] = shape;
        bedf->expand[0][(size_t)c * bed->lanes + lane] = shape;
      }
    }
  }
}

/* The classes of symmetry along stand side by side. */
static void fill_places(TbWireGridF *bedf, const TbWireGrid *bed) {
  uint32_t *place = bedf->place[0];
  for (uint32_t line = 0; line < bed->lines; line++) {
    for (uint32_t along = 0; along < bed->halves; along++) {
      const uint32_t columns = bed->columns[along];
      memcpy(place, bed->place[along] + (size_t)line * columns, columns * sizeof *place);
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

bool tb_wire_gridf_prepare(TbWireGridF *bedf, TbArena *arena, TbWireGrid *bed) {
  round_bed(bed);
  *bedf = (TbWireGridF){.wires = bed->wires,
                        .lanes = bed->lanes,
                        .halves = 1,
                        .quarters = bed->quarters,
                        .middle = bed->middle,
                        .half = bed->lanes,
                        .lines = bed->lines,
                        .thinned = true,
                        .size = bed->size};
  memcpy(bedf->first_line, bed->first_line, sizeof bedf->first_line);
  memcpy(bedf->first, bed->first, sizeof bedf->first);
  for (uint32_t along = 0; along < bed->halves; along++) bedf->columns[0] += bed->columns[along];
  bedf->padded[0] = tb_pad(bedf->columns[0]);
  const size_t across = (size_t)bed->wires * bed->lines, lanes = bed->lanes;
  const size_t columns = bedf->columns[0];
  bedf->across = tb_arena_take(arena, across, sizeof(float));
  bedf->contract[0] = tb_arena_take(arena, lanes * bedf->padded[0], sizeof(float));
  bedf->expand[0] = tb_arena_take(arena, lanes * columns, sizeof(float));
  bedf->place[0] = tb_arena_take(arena, bed->lines * columns, sizeof(uint32_t));
  if (arena->failed) return false;
  for (size_t i = 0; i < across; i++) bedf->across[i] = (float)bed->across[i];
  fill_shapes(bedf, bed);
  fill_places(bedf, bed);
  return true;
}
