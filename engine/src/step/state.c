/* SPDX-License-Identifier: MIT */
#include "step/state.h"

#include "model/state_layout.h"

/* Where the arrays begin, whose places the model's layout tells. */
static const size_t HEADER = (sizeof(TbState) + TB_ALIGNMENT - 1) / TB_ALIGNMENT * TB_ALIGNMENT;

size_t tb_state_bytes(const TaborModel *model) { return HEADER + model->layout.total; }

static double *at(TbState *state, size_t offset) {
  return (double *)(void *)((char *)state + HEADER + offset);
}

static TbPhase phase_at(TbState *state, const TbLayout *layout, uint32_t index) {
  return (TbPhase){at(state, layout->q[index]),
                   at(state, layout->v[index]),
                   at(state, layout->eta[index]),
                   state->z[index],
                   at(state, layout->high[index]),
                   state->missing[index],
                   state->hoop[index],
                   state->bow[index],
                   (float *)(void *)at(state, layout->high[index])};
}

static void view_phases(TbView *view) {
  const TbLayout *layout = &view->model->layout;
  const uint32_t newest = view->state->newest;
  view->now = phase_at(view->state, layout, newest);
  view->last = phase_at(view->state, layout, (newest + 2) % 3);
  view->next = phase_at(view->state, layout, (newest + 1) % 3);
  view->solve.y = view->last.eta;
}

static TbSingle single_at(TbState *state, const TaborModel *model) {
  TbSingle single = {
    .kernels = model->single_kernels, .bed = &model->single_bed, .yield = model->yield};
  if (!single.kernels) return single;
  float *next = (float *)(void *)at(state, model->layout.single);
  float **const rows[TB_SINGLE_ROWS] = {
    &single.y,      &single.root,    &single.b,          &single.own,          &single.s,
    &single.force,  &single.product, &single.force_last, &single.product_last, &single.law,
    &single.slope,  &single.mean,    &single.weight,     &single.residual,     &single.direction,
    &single.turned, &single.moved,   &single.solution,   &single.work};
  float **const grids[TB_SINGLE_GRIDS] = {&single.grid,   &single.grid_last,  &single.pushed,
                                          &single.answer, &single.stretch[0], &single.stretch[1]};
  for (int i = 0; i < TB_SINGLE_ROWS; i++, next += model->wires.stride + TB_SLOTS) *rows[i] = next;
  for (int i = 0; i < TB_SINGLE_GRIDS; i++, next += single.bed->size) *grids[i] = next;
  single.modal[0] = next;
  single.modal[1] = next + model->modes.padded;
  single.scratch = next + 2u * (size_t)model->modes.padded;
  return single;
}

static TbSolve solve_at(TbState *state, const TaborModel *model) {
  const TbLayout *l = &model->layout;
  return (TbSolve){.kernels = model->kernels,
                   .bed = &model->projection.bed,
                   .compliance = &model->compliance,
                   .stride = model->wires.stride,
                   .slot_mask = state->slot_mask,
                   .lifted = state->lifted != 0,
                   .cap = model->newton_cap,
                   .inner_cap = model->inner_cap,
                   .tolerance = model->tolerance,
                   .inner_tolerance = model->inner_tolerance,
                   .coupling = at(state, l->coupling),
                   .slot_coupling = at(state, l->slot_coupling),
                   .own = at(state, l->own),
                   .wire_laws = model->wires.laws,
                   .slot_laws = state->slot_laws,
                   .b = at(state, l->b),
                   .s = at(state, l->s),
                   .force = at(state, l->force),
                   .product = at(state, l->product),
                   .grid = at(state, l->grid),
                   .previous = at(state, l->previous),
                   .previous_product = at(state, l->previous_product),
                   .previous_grid = at(state, l->previous_grid),
                   .law_force = at(state, l->law_force),
                   .slope = at(state, l->slope),
                   .mean = at(state, l->mean),
                   .residual = at(state, l->residual),
                   .direction = at(state, l->direction),
                   .turned = at(state, l->turned),
                   .moved = at(state, l->moved),
                   .weight = at(state, l->weight),
                   .solution = at(state, l->solution),
                   .work = at(state, l->work),
                   .pushed = at(state, l->pushed),
                   .answer = at(state, l->answer),
                   .scratch = at(state, l->scratch),
                   .single = single_at(state, model)};
}

TbView tb_view(TbState *state, const TaborModel *model) {
  const TbLayout *l = &model->layout;
  TbView view = {.model = model,
                 .state = state,
                 .bend = at(state, l->bend),
                 .head = at(state, l->head),
                 .rest_load = at(state, l->rest_load),
                 .own = at(state, l->own),
                 .b = at(state, l->b),
                 .s = at(state, l->s),
                 .change = at(state, l->change),
                 .modal = at(state, l->modal),
                 .high_drive = at(state, l->high_drive),
                 .high_scratch = at(state, l->high_scratch),
                 .high_force = (float *)(void *)at(state, l->high_force),
                 .coupling = at(state, l->coupling),
                 .slot_coupling = at(state, l->slot_coupling),
                 .shape = at(state, l->shape),
                 .drive = at(state, l->drive),
                 .radial = at(state, l->radial),
                 .solve = solve_at(state, model)};
  for (uint32_t mic = 0; mic < model->def.mic_count; mic++) {
    view.delay[mic] = at(state, l->delay[mic]);
  }
  view.stretch_carry = at(state, l->stretch_carry);
  for (uint32_t h = 0; h < model->stretch.count; h++) {
    view.stretch_pull[h] = at(state, l->stretch_pull[h]);
    view.solve.stretch_grid[h] = at(state, l->stretch_grid[h]);
  }
  view_phases(&view);
  return view;
}

void tb_view_rotate(TbView *view) {
  const TbPhase oldest = view->last;
  view->state->newest = (view->state->newest + 1) % 3;
  view->last = view->now;
  view->now = view->next;
  view->next = oldest;
  view->solve.y = view->last.eta;
}
