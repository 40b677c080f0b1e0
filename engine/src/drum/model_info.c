/* SPDX-License-Identifier: MIT */
/* Queries about a model and about the drums made from it. */
#include "state/state.h"

static uint32_t row_count(const TaborModel *model) {
  return model->lugs.count ? model->lugs.row_count : model->body.row_count;
}

void tabor_model_info(const TaborModel *model, TaborModelInfo *info) {
  *info = (TaborModelInfo){
    .sample_rate = model->sample_rate,
    .step_rate = model->step_rate,
    .quality = model->quality,
    .mode_count = model->modes.count,
    .mode_rows = row_count(model),
    .two_way_bandwidth = model->body.bandwidth,
    .bandwidth = model->high.count ? model->top : model->body.bandwidth,
    .high_mode_count = model->high.count,
    .newton_cap = model->newton_cap,
    .wire_count = model->def.wires.count,
    .contact_points = model->wires.contact_points,
    .mic_count = model->def.mic_count,
    .model_bytes = model->arena.bytes + sizeof *model,
    .drum_bytes = 2 * tb_state_bytes(model), /* with one for a silence */
  };
}

bool tabor_model_mode(const TaborModel *model, uint32_t row, TaborModeInfo *info) {
  if (row >= row_count(model)) return false;
  *info = model->lugs.count ? model->lugs.rows[row] : tb_body_mode_info(&model->body.modes[row]);
  return true;
}

bool tabor_model_mode_shape(const TaborModel *model, uint32_t row, uint32_t surface, double radius,
                            double *shape) {
  const TbBody *body = &model->body;
  *shape = 0.0;
  if (model->lugs.count > 0 || row >= body->row_count || surface >= body->surfaces) return false;
  if (!(radius >= 0.0 && radius <= body->radius)) return false;
  *shape = tb_body_shape(body, surface, &body->modes[row], radius);
  return true;
}
