/* SPDX-License-Identifier: MIT */
#include "model/state_layout.h"

static size_t place(size_t *total, size_t count) {
  const size_t at = *total;
  *total += (count * sizeof(double) + TB_ALIGNMENT - 1) / TB_ALIGNMENT * TB_ALIGNMENT;
  return at;
}

static size_t single_floats(const TaborModel *model) {
  if (!model->single_kernels) return 0;
  return TB_SINGLE_ROWS * (size_t)(model->wires.stride + TB_SLOTS) +
         TB_SINGLE_GRIDS * (size_t)model->single_bed.size +
         tb_pad(tb_single_bed_scratch(&model->single_bed)) + 2u * (size_t)model->modes.padded;
}

void tb_layout_prepare(TbLayout *layout, const TaborModel *model) {
  const size_t modes = model->modes.padded, nodes = model->wires.node_count;
  const size_t rows = model->wires.stride + TB_SLOTS;
  const TbBed *bed = &model->projection.bed;
  *layout = (TbLayout){0};
  size_t total = 0;
  for (int phase = 0; phase < 3; phase++) {
    layout->q[phase] = place(&total, modes);
    layout->v[phase] = place(&total, nodes);
    layout->eta[phase] = place(&total, rows);
  }
  layout->bend = place(&total, nodes);
  size_t *const row_arrays[] = {&layout->head,      &layout->rest_load, &layout->own,
                                &layout->b,         &layout->s,         &layout->force,
                                &layout->product,   &layout->previous,  &layout->previous_product,
                                &layout->law_force, &layout->slope,     &layout->mean,
                                &layout->residual,  &layout->direction, &layout->turned,
                                &layout->moved,     &layout->weight,    &layout->solution,
                                &layout->work};
  for (size_t i = 0; i < sizeof row_arrays / sizeof *row_arrays; i++) {
    *row_arrays[i] = place(&total, rows);
  }
  size_t *const grid_arrays[] = {&layout->grid, &layout->previous_grid, &layout->change,
                                 &layout->pushed, &layout->answer};
  for (size_t i = 0; i < sizeof grid_arrays / sizeof *grid_arrays; i++) {
    *grid_arrays[i] = place(&total, bed->size);
  }
  layout->scratch = place(&total, tb_bed_scratch(bed));
  layout->single = place(&total, single_floats(model) / 2);
  for (int phase = 0; phase < 3; phase++) layout->high[phase] = place(&total, model->high.padded);
  layout->high_drive = place(&total, (size_t)TB_SLOTS * model->high.padded);
  layout->high_scratch = place(&total, model->high.padded);
  layout->high_force = place(&total, model->high.padded / 2u); /* two floats each */
  layout->modal = place(&total, modes);
  for (uint32_t h = 0; h < model->stretch.count; h++) {
    layout->stretch_pull[h] = place(&total, modes);
    layout->stretch_grid[h] = place(&total, bed->size);
  }
  layout->stretch_carry = place(&total, bed->size + TB_SLOTS);
  layout->coupling = place(&total, (size_t)TB_SLOTS * bed->size);
  layout->slot_coupling = place(&total, (size_t)TB_SLOTS * TB_SLOTS);
  layout->shape = place(&total, TB_SLOTS * modes);
  layout->drive = place(&total, TB_SLOTS * modes);
  layout->radial = place(&total, model->head.row_count);
  for (uint32_t mic = 0; mic < model->def.mic_count; mic++) {
    layout->delay[mic] = place(&total, model->mics[mic].delay + 1u);
  }
  layout->total = total;
}
