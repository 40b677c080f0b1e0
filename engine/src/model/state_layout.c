/* SPDX-License-Identifier: MIT */
#include "model/state_layout.h"

static size_t place(size_t *total, size_t count) {
  const size_t at = *total;
  *total += (count * sizeof(double) + TB_ALIGNMENT - 1) / TB_ALIGNMENT * TB_ALIGNMENT;
  return at;
}

/* Floats of TbSolveWorkF, and of TbView.modalf; the grid's scratch is none where there is no such grid. */
static size_t work_floats(const TaborModel *model) {
  static const size_t ROWS[] = {[TB_IN_DOUBLE] = 0, [TB_IN_FLOAT] = TB_WORKF_ROWS},
                      GRIDS[] = {[TB_IN_DOUBLE] = 0, [TB_IN_FLOAT] = TB_WORKF_GRIDS},
                      MODES[] = {[TB_IN_DOUBLE] = 0, [TB_IN_FLOAT] = 2};
  return ROWS[model->contacts] * (model->wires.stride + TB_SLOTS) +
         GRIDS[model->contacts] * model->wire_gridf.size +
         MODES[model->contacts] * model->modes.padded +
         tb_pad(tb_wire_grid_scratchf(&model->wire_gridf));
}

void tb_layout_prepare(TbLayout *layout, const TaborModel *model) {
  const size_t modes = model->modes.padded, nodes = model->wires.node_count;
  const size_t rows = model->wires.stride + TB_SLOTS;
  const TbWireGrid *wire_grid = &model->projection.wire_grid;
  *layout = (TbLayout){0};
  size_t total = 0;
  for (int phase = 0; phase < 3; phase++) {
    layout->q[phase] = place(&total, modes);
    layout->v[phase] = place(&total, nodes);
    layout->eta[phase] = place(&total, rows);
  }
  layout->bend = place(&total, nodes);
  size_t *const row_arrays[] = {&layout->head,   &layout->rest_load, &layout->contact_compliance,
                                &layout->b,      &layout->s,         &layout->force,
                                &layout->product};
  for (size_t i = 0; i < sizeof row_arrays / sizeof *row_arrays; i++) {
    *row_arrays[i] = place(&total, rows);
  }
  layout->grid = place(&total, wire_grid->size);
  layout->change = place(&total, wire_grid->size);
  layout->work = place(&total, TB_WORK_ROWS * rows + TB_WORK_GRIDS * wire_grid->size +
                                 tb_wire_grid_scratch(wire_grid));
  layout->workf = place(&total, work_floats(model) / 2u); /* two floats each */
  for (int phase = 0; phase < 3; phase++) layout->high[phase] = place(&total, model->high.padded);
  layout->high_drive = place(&total, (size_t)TB_SLOTS * model->high.padded);
  layout->high_scratch = place(&total, model->high.padded);
  layout->high_force = place(&total, model->high.padded / 2u);
  layout->high_held = place(&total, model->high.padded);
  layout->modal = place(&total, modes);
  for (uint32_t h = 0; h < model->stretch.count; h++) {
    layout->stretch_pull[h] = place(&total, modes);
    layout->stretch_mixed[h] = place(&total, modes);
    layout->stretch_grid[h] = place(&total, wire_grid->size);
  }
  layout->stretch_carry = place(&total, wire_grid->size + TB_SLOTS);
  layout->coupling = place(&total, (size_t)TB_SLOTS * wire_grid->size);
  layout->slot_coupling = place(&total, (size_t)TB_SLOTS * TB_SLOTS);
  layout->shape = place(&total, TB_SLOTS * modes);
  layout->drive = place(&total, TB_SLOTS * modes);
  layout->radial = place(&total, model->head.row_count);
  for (uint32_t mic = 0; mic < model->def.mic_count; mic++) {
    layout->delay[mic] = place(&total, model->mics[mic].delay + 1u);
  }
  layout->total = total;
}
