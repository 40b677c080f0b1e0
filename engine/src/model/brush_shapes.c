/* SPDX-License-Identifier: MIT */
#include "model/brush_shapes.h"

#include <math.h>

#include "math/bessel_table.h"
#include "math/portable_math.h"
#include "model/model.h"

static const double OUTERMOST = 0.98; /* of the head's radius */

static size_t cosines_of(const TaborModel *model) { return model->high.cosines[TABOR_HEAD_BATTER]; }

/* The high band's part of a drive that depends on the radius alone (tb_high_band_turn()). */
static void fill_waves(const TaborModel *model, uint32_t striker, const TbBesselTable *table,
                       double radius, double *waves) {
  const TbHighBand *band = &model->high;
  const double *patch = model->high_patches[striker];
  const uint32_t begin = band->begin[TABOR_HEAD_BATTER];
  for (uint32_t i = begin; i < begin + band->cosines[TABOR_HEAD_BATTER]; i++) {
    const double j =
      tb_bessel_table_value(table, band->order[i], band->zero[i] * radius / band->radius);
    waves[i - begin] = -band->g[i] * band->scale[i] * j * patch[i];
  }
}

static bool prepare_table(const TaborModel *model, TbArena *arena, TbBesselTable *table) {
  double top = 0.0;
  for (uint32_t m = 0; m < model->body.order_count; m++) {
    const TbBodyOrder *order = &model->body.orders[m];
    top = fmax(top, order->zeros[order->zero_count - 1]);
  }
  for (uint32_t i = 0; i < model->high.padded; i++) top = fmax(top, model->high.zero[i]);
  const uint32_t orders =
    model->body.order_count > model->high.orders ? model->body.order_count : model->high.orders;
  return tb_bessel_table_prepare(table, arena, orders, top);
}

static TaborStatus prepare_rings(TaborModel *model, const TbBesselTable *table, uint32_t striker) {
  TbBrushShapes *places = &model->places[striker];
  const size_t rows = model->body.row_count, waves = cosines_of(model);
  places->apart = OUTERMOST * model->body.radius / (TB_RINGS - 1u);
  places->rows = tb_arena_doubles(&model->arena, TB_RINGS * rows);
  places->waves = tb_arena_doubles(&model->arena, TB_RINGS * waves);
  if (model->arena.failed) return TABOR_ERROR_MEMORY;
  for (uint32_t ring = 0; ring < TB_RINGS; ring++) {
    const double radius = ring * places->apart;
    tb_body_radial_tabled(&model->body, table, TABOR_HEAD_BATTER, radius, model->patches[striker],
                          places->rows + ring * rows);
    tb_body_add_lift(&model->body, TABOR_HEAD_BATTER, radius, places->rows + ring * rows);
    if (waves > 0) fill_waves(model, striker, table, radius, places->waves + ring * waves);
  }
  return TABOR_OK;
}

static bool has_brush(const TaborDrumDef *def) {
  for (uint32_t i = 0; i < def->striker_count; i++) {
    if (def->striker[i].kind == TABOR_STRIKER_BRUSH) return true;
  }
  return false;
}

TaborStatus tb_brush_shapes_prepare(TaborModel *model) {
  if (!has_brush(&model->def)) return TABOR_OK;
  TbArena scratch;
  TbBesselTable table;
  tb_arena_beside(&scratch, &model->arena);
  TaborStatus status = prepare_table(model, &scratch, &table) ? TABOR_OK : TABOR_ERROR_MEMORY;
  for (uint32_t i = 0; i < model->def.striker_count && status == TABOR_OK; i++) {
    if (model->def.striker[i].kind == TABOR_STRIKER_BRUSH) {
      status = prepare_rings(model, &table, i);
    }
  }
  tb_arena_release(&scratch);
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
  tb_sin_cos_degrees(angle - model->axis, &sine, &cosine);
  tb_modes_turn(&model->modes, &model->body, places->rows + ring * model->body.row_count, sine,
                cosine, shape);
  if (cosines_of(model) == 0) return;
  tb_high_band_turn(&model->high, TABOR_HEAD_BATTER, places->waves + ring * cosines_of(model), sine,
                    cosine, drive);
}
