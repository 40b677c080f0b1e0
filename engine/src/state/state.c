/* SPDX-License-Identifier: MIT */
#include "state/state.h"

#include "model/state_layout.h"

/* Begin of the arrays, whose places the model's layout tells. */
static const size_t HEADER = TB_ALIGNED(sizeof(TbState));

size_t tb_state_head_bytes(void) { return HEADER; }

size_t tb_state_bytes(const TaborModel *model) { return HEADER + model->layout.total; }

static void *at(TbState *state, size_t offset) { return (char *)state + HEADER + offset; }

static TbPhase phase_at(TbState *state, const TbLayout *layout, uint32_t index) {
  return (TbPhase){at(state, layout->q[index]),      at(state, layout->v[index]),
                   at(state, layout->eta[index]),    state->strikers.z[index],
                   &state->plate.psi[index],         at(state, layout->high[index]),
                   state->strikers.truncated[index], state->strikers.bow[index]};
}

static void view_phases(TbView *view) {
  const TbLayout *layout = &view->model->layout;
  const uint32_t newest = view->state->newest;
  view->now = phase_at(view->state, layout, newest);
  view->last = phase_at(view->state, layout, (newest + 2) % 3);
  view->next = phase_at(view->state, layout, (newest + 1) % 3);
  view->solve.in.y = view->last.eta;
}

/* The workspace of the solve in double; the drum's own arrays join it in share_with_solve(). */
static TbSolveWork work_at(TbState *state, const TaborModel *model) {
  TbSolveWork work = {.s = NULL};
  double *next = at(state, model->layout.work[0]);
  double **const rows[TB_WORK_ROWS] = {
    &work.force_last, &work.product_last, &work.law,    &work.slope, &work.mean,    &work.weight,
    &work.residual,   &work.direction,    &work.turned, &work.moved, &work.solution};
  double **const grids[TB_WORK_GRIDS] = {&work.grid_last, &work.pushed, &work.answer};
  for (int i = 0; i < TB_WORK_ROWS; i++, next += tb_row_count(&model->rows)) *rows[i] = next;
  for (int i = 0; i < TB_WORK_GRIDS; i++, next += model->projection.wire_grid.size)
    *grids[i] = next;
  work.scratch = next;
  return work;
}

static TbSolveWorkF no_workf_at(TbState *state, const TaborModel *model,
                                float *modal[TB_COUPLINGS]) {
  (void)state, (void)model, (void)modal;
  return (TbSolveWorkF){.s = NULL};
}

static TbSolveWorkF workf_at(TbState *state, const TaborModel *model, float *modal[TB_COUPLINGS]) {
  TbSolveWorkF work = {.s = NULL};
  float *next = at(state, model->layout.workf[0]);
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
  for (int i = 0; i < TB_WORKF_ROWS; i++, next += tb_row_count(&model->rows)) *rows[i] = next;
  for (int i = 0; i < TB_WORKF_GRIDS; i++, next += model->wire_gridf.size) *grids[i] = next;
  for (int i = 0; i < 2; i++, next += model->modes.padded) modal[i] = next;
  work.scratch = next;
  return work;
}

static TbContacts contacts_of(TbState *state, const TaborModel *model) {
  return (TbContacts){.kernels = model->kernels,
                      .wire_grid = &model->projection.wire_grid,
                      .lossy = model->wires.rims,
                      .compliance = &model->compliance,
                      .kernelsf = model->kernelsf,
                      .wire_gridf = &model->wire_gridf,
                      .compliancef = &model->compliancef,
                      .yield = model->yield,
                      .rows = model->rows,
                      .slot_mask = state->strikers.mask,
                      .cap = model->newton_cap,
                      .inner_cap = model->inner_cap,
                      .tolerance = model->tolerance,
                      .inner_tolerance = model->inner_tolerance,
                      .wire_laws = model->wires.laws,
                      .slot_laws = state->strikers.laws};
}

static TbSolve solve_at(TbState *state, const TaborModel *model, float *modal[TB_COUPLINGS]) {
  static TbSolveWorkF (*const WORKF[])(TbState *, const TaborModel *, float *[TB_COUPLINGS]) = {
    [TB_IN_DOUBLE] = no_workf_at, [TB_IN_FLOAT] = workf_at};
  return (TbSolve){.in = contacts_of(state, model),
                   .work = work_at(state, model),
                   .workf = WORKF[model->contacts](state, model, modal)};
}

/* The drum's arrays that the solve reads and writes. */
static void share_with_solve(TbView *view) {
  TbSolve *solve = &view->solve;
  solve->in.coupling = view->strikers.coupling;
  solve->in.slot_coupling = view->strikers.slot_coupling;
  solve->in.contact_compliance = view->contact_compliance;
  solve->in.b = view->b;
  solve->s = solve->work.s = view->s;
  solve->work.force = solve->warm.force;
  solve->work.product = solve->warm.product;
  solve->work.grid = solve->warm.grid;
}

#define VIEW(name, kind, most, copies, count, field)                                               \
  for (uint32_t copy = 0; copy < (copies); copy++) view.field = at(state, model->layout.name[copy]);

TbView tb_view(TbState *state, const TaborModel *model) {
  TbView view = {.model = model, .state = state, .mics = {.tap = TB_NO_TAP}};
  view.solve = solve_at(state, model, view.modalf);
  TB_VIEWED_ARRAYS(VIEW)
  share_with_solve(&view);
  tb_view_lift(&view, state->wires.lifted != 0);
  view_phases(&view);
  tb_view_move(&view);
  return view;
}

void tb_view_move(TbView *view) {
  const TbParts *parts = &view->model->stretch.parts;
  view->moving = *parts;
  view->all_move = true;
  for (uint32_t i = 0; i < parts->count; i++) {
    const uint32_t all = view->state->moving[i];
    view->moving.end[i] = parts->from[i] + all;
    view->all_move = view->all_move && view->moving.end[i] == parts->end[i];
    if (view->moving.size[i] > all) view->moving.size[i] = all;
    if (view->moving.mixed[i] > all) view->moving.mixed[i] = all;
  }
}

void tb_view_rotate(TbView *view) {
  const TbPhase oldest = view->last;
  view->state->newest = (view->state->newest + 1) % 3;
  view->last = view->now;
  view->now = view->next;
  view->next = oldest;
  view->solve.in.y = view->last.eta;
}
