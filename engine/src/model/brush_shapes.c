/* SPDX-License-Identifier: MIT */
#include "model/brush_shapes.h"

#include "math/portable_math.h"
#include "model/model.h"

static const double OUTERMOST = 0.98; /* of the head's radius */

static size_t cosines_of(const TaborModel *model) { return model->high.cosines[TABOR_HEAD_BATTER]; }

static TaborStatus prepare_rings(TaborModel *model, uint32_t striker) {
  TbBrushShapes *places = &model->places[striker];
  const size_t rows = model->head.row_count, waves = cosines_of(model);
  places->apart = OUTERMOST * model->head.radius / (TB_RINGS - 1u);
  places->rows = tb_arena_doubles(&model->arena, TB_RINGS * rows);
  places->waves = tb_arena_doubles(&model->arena, TB_RINGS * waves);
  if (model->arena.failed) return TABOR_ERROR_MEMORY;
  for (uint32_t ring = 0; ring < TB_RINGS; ring++) {
    const double radius = ring * places->apart;
    tb_head_radial(&model->head, TABOR_HEAD_BATTER, radius, model->patches[striker],
                   places->rows + ring * rows);
    if (waves == 0) continue;
    tb_high_band_waves(&model->high, TABOR_HEAD_BATTER, radius, model->high_patches[striker],
                       places->waves + ring * waves);
  }
  return TABOR_OK;
}

TaborStatus tb_brush_shapes_prepare(TaborModel *model) {
  TaborStatus status = TABOR_OK;
  for (uint32_t i = 0; i < model->def.striker_count && status == TABOR_OK; i++) {
    if (model->def.striker[i].kind == TABOR_STRIKER_BRUSH) status = prepare_rings(model, i);
  }
  return status;
}

static uint32_t ring_of(const TaborModel *model, uint32_t striker, double radius) {
  const uint32_t ring = (uint32_t)(radius / model->places[striker].apart + 0.5);
  return ring < TB_RINGS ? ring : TB_RINGS - 1u;
}

double tb_brush_shapes_ring(const TaborModel *model, uint32_t striker, double radius) {
  return ring_of(model, striker, radius) * model->places[striker].apart;
}

void tb_brush_shapes_shape(const TaborModel *model, uint32_t striker, double radius, double angle,
                           double *shape, double *drive) {
  const TbBrushShapes *places = &model->places[striker];
  const size_t ring = ring_of(model, striker, radius);
  double sine, cosine;
  tb_sin_cos_degrees(angle - model->def.wires.angle, &sine, &cosine);
  tb_modes_turn(&model->modes, &model->head, places->rows + ring * model->head.row_count, sine,
                cosine, shape);
  if (cosines_of(model) == 0) return;
  tb_high_band_turn(&model->high, TABOR_HEAD_BATTER, places->waves + ring * cosines_of(model), sine,
                    cosine, drive);
}
