/* SPDX-License-Identifier: MIT */
#include "model/bedf.h"

static void round_all(double *values, size_t count) {
  for (size_t i = 0; i < count; i++) values[i] = (double)(float)values[i];
}

static void round_bed(TbBed *bed) {
  round_all(bed->across, (size_t)bed->wires * bed->lines);
  for (uint32_t along = 0; along < bed->halves && bed->thinned; along++) {
    const size_t blocks = tb_pad(bed->columns[along]);
    round_all(bed->squeeze[along], blocks * bed->half);
    round_all(bed->spread[along], (size_t)bed->half * bed->columns[along]);
  }
}

/* Of one column of a class along, at any lane. */
static double shape_at(const TbBed *bed, uint32_t along, uint32_t column, uint32_t lane) {
  const bool folded = bed->halves == 2, image = folded && lane > bed->middle;
  if (folded && lane > 2 * bed->middle) return 0.0;
  if (along == 1 && lane == bed->middle) return 0.0;
  const uint32_t half = image ? 2 * bed->middle - lane : lane;
  const size_t at = ((size_t)(half / 8) * bed->columns[along] + column) * 8 + half % 8;
  const double value = bed->thinned ? bed->spread[along][at] : (half == column ? 1.0 : 0.0);
  return along == 1 && image ? -value : value;
}

static void fill_shapes(TbBedF *bedf, const TbBed *bed) {
  for (uint32_t lane = 0; lane < bed->lanes; lane++) {
    uint32_t c = 0;
    for (uint32_t along = 0; along < bed->halves; along++) {
      for (uint32_t a = 0; a < bed->columns[along]; a++, c++) {
        const float shape = (float)shape_at(bed, along, a, lane);
        bedf->contract[(size_t)lane * bedf->padded + c] = shape;
        bedf->expand[(size_t)c * bed->lanes + lane] = shape;
      }
    }
  }
}

static void fill_places(TbBedF *bedf, const TbBed *bed) {
  uint32_t *place = bedf->place;
  for (uint32_t line = 0; line < bed->lines; line++) {
    const uint32_t across = bed->quarters == 2 && line >= bed->first_line[1] ? 1 : 0;
    for (uint32_t along = 0; along < bed->halves; along++) {
      const uint32_t first = bed->first[tb_bed_class(bed, along, across)] +
                             (line - bed->first_line[across]) * bed->columns[along];
      for (uint32_t a = 0; a < bed->columns[along]; a++) *place++ = first + a;
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

bool tb_bedf_prepare(TbBedF *bedf, TbArena *arena, TbBed *bed) {
  round_bed(bed);
  *bedf = (TbBedF){.wires = bed->wires,
                   .lanes = bed->lanes,
                   .quarters = bed->quarters,
                   .lines = bed->lines,
                   .size = bed->size};
  for (uint32_t c = 0; c < 3; c++) bedf->first_line[c] = bed->first_line[c];
  for (uint32_t along = 0; along < bed->halves; along++) bedf->columns += bed->columns[along];
  bedf->padded = tb_pad(bedf->columns);
  const size_t across = (size_t)bed->wires * bed->lines;
  bedf->across = tb_arena_take(arena, across, sizeof *bedf->across);
  bedf->contract = tb_arena_take(arena, (size_t)bed->lanes * bedf->padded, sizeof *bedf->contract);
  bedf->expand = tb_arena_take(arena, (size_t)bed->lanes * bedf->columns, sizeof *bedf->expand);
  bedf->place = tb_arena_take(arena, (size_t)bed->lines * bedf->columns, sizeof *bedf->place);
  if (arena->failed) return false;
  for (size_t i = 0; i < across; i++) bedf->across[i] = (float)bed->across[i];
  fill_shapes(bedf, bed);
  fill_places(bedf, bed);
  return true;
}
