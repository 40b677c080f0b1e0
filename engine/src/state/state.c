/* SPDX-License-Identifier: MIT */
#include "state/state.h"

#include "model/state_layout.h"

/* Where the arrays begin, whose places the model's layout tells. */
static const size_t HEADER = (sizeof(TbState) + TB_ALIGNMENT - 1) / TB_ALIGNMENT * TB_ALIGNMENT;

size_t tb_state_head_bytes(void) { return HEADER; }

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
                   state->truncated[index],
                   state->bow[index]};
}

static void view_phases(TbView *view) {
  const TbLayout *layout = &view->model->layout;
  const uint32_t newest = view->state->newest;
  view->now = phase_at(view->state, layout, newest);
  view->last = phase_at(view->state, layout, (newest + 2) % 3);
  view->next = phase_at(view->state, layout, (newest + 1) % 3);
  view->solve.in.y = view->last.eta;
}

/* The workspace of the solve in double, which has the drum's own arrays beside. */
static TbSolveWork work_at(TbState *state, const TaborModel *model) {
  const TbLayout *l = &model->layout;
  TbSolveWork work = {.s = at(state, l->s),
                      .force = at(state, l->force),
                      .product = at(state, l->product),
                      .grid = at(state, l->grid)};
  double *next = at(state, l->work);
  double **const rows[TB_WORK_ROWS] = {
    &work.force_last, &work.product_last, &work.law,    &work.slope, &work.mean,    &work.weight,
    &work.residual,   &work.direction,    &work.turned, &work.moved, &work.solution};
  double **const grids[TB_WORK_GRIDS] = {&work.grid_last, &work.pushed, &work.answer};
  for (int i = 0; i < TB_WORK_ROWS; i++, next += model->wires.stride + TB_SLOTS) *rows[i] = next;
  for (int i = 0; i < TB_WORK_GRIDS; i++, next += model->projection.wire_grid.size)
    *grids[i] = next;
  work.scratch = next;
  return work;
}

static TbSolveWorkF no_workf_at(TbState *state, const TaborModel *model, float *modal[2]) {
  (void)state, (void)model, (void)modal;
  return (TbSolveWorkF){.s = NULL};
}

static TbSolveWorkF workf_at(TbState *state, const TaborModel *model, float *modal[2]) {
  TbSolveWorkF work = {.s = NULL};
  float *next = (float *)(void *)at(state, model->layout.workf);
  float **const rows[TB_WORKF_ROWS] = {
    &work.s,          &work.force,        &work.product,
    &work.force_last, &work.product_last, &work.law,
    &work.slope,      &work.mean,         &work.weight,
    &work.residual,   &work.direction,    &work.turned,
    &work.moved,      &work.solution,     &work.b,
    &work.y,          &work.root,         &work.contact_compliance,
    &work.yield,      &work.before};
  float **const grids[TB_WORKF_GRIDS] = {&work.grid,   &work.grid_last,  &work.pushed,
                                         &work.answer, &work.stretch[0], &work.stretch[1]};
  for (int i = 0; i < TB_WORKF_ROWS; i++, next += model->wires.stride + TB_SLOTS) *rows[i] = next;
  for (int i = 0; i < TB_WORKF_GRIDS; i++, next += model->wire_gridf.size) *grids[i] = next;
  for (int i = 0; i < 2; i++, next += model->modes.padded) modal[i] = next;
  work.scratch = next;
  return work;
}

static TbContacts contacts_at(TbState *state, const TaborModel *model) {
  const TbLayout *l = &model->layout;
  return (TbContacts){.kernels = model->kernels,
                      .wire_grid = &model->projection.wire_grid,
                      .compliance = &model->compliance,
                      .kernelsf = model->kernelsf,
                      .wire_gridf = &model->wire_gridf,
                      .compliancef = &model->compliancef,
                      .yield = model->yield,
                      .stride = model->wires.stride,
                      .slot_mask = state->slot_mask,
                      .cap = model->newton_cap,
                      .inner_cap = model->inner_cap,
                      .tolerance = model->tolerance,
                      .inner_tolerance = model->inner_tolerance,
                      .coupling = at(state, l->coupling),
                      .slot_coupling = at(state, l->slot_coupling),
                      .contact_compliance = at(state, l->contact_compliance),
                      .wire_laws = model->wires.laws,
                      .slot_laws = state->slot_laws,
                      .b = at(state, l->b)};
}

static TbSolve solve_at(TbState *state, const TaborModel *model, float *modal[2]) {
  static TbSolveWorkF (*const WORKF[])(TbState *, const TaborModel *, float *[2]) = {
    [TB_IN_DOUBLE] = no_workf_at, [TB_IN_FLOAT] = workf_at};
  const TbLayout *l = &model->layout;
  return (TbSolve){
    .in = contacts_at(state, model),
    .warm = {at(state, l->force), at(state, l->product), at(state, l->grid)},
    .s = at(state, l->s),
    .work = work_at(state, model),
    .workf = WORKF[model->contacts](state, model, modal),
  };
}

TbView tb_view(TbState *state, const TaborModel *model) {
  const TbLayout *l = &model->layout;
  TbView view = {.model = model,
                 .state = state,
                 .tap = TB_NO_TAP,
                 .bend = at(state, l->bend),
                 .head = at(state, l->head),
                 .rest_load = at(state, l->rest_load),
                 .contact_compliance = at(state, l->contact_compliance),
                 .b = at(state, l->b),
                 .s = at(state, l->s),
                 .change = at(state, l->change),
                 .modal = at(state, l->modal),
                 .high_drive = at(state, l->high_drive),
                 .high_scratch = at(state, l->high_scratch),
                 .high_force = (float *)(void *)at(state, l->high_force),
                 .high_held = at(state, l->high_held),
                 .coupling = at(state, l->coupling),
                 .slot_coupling = at(state, l->slot_coupling),
                 .shape = at(state, l->shape),
                 .drive = at(state, l->drive),
                 .radial = at(state, l->radial)};
  view.solve = solve_at(state, model, view.modalf);
  tb_view_lift(&view, state->lifted != 0);
  for (uint32_t mic = 0; mic < model->def.mic_count; mic++) {
    view.delay[mic] = at(state, l->delay[mic]);
  }
  view.stretch_carry = at(state, l->stretch_carry);
  for (uint32_t h = 0; h < model->stretch.count; h++) {
    view.stretch_pull[h] = at(state, l->stretch_pull[h]);
    view.stretch_mixed[h] = at(state, l->stretch_mixed[h]);
    view.solve.in.stretch_grid[h] = at(state, l->stretch_grid[h]);
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
  view->solve.in.y = view->last.eta;
}
