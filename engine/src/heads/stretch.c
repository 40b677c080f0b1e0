/* SPDX-License-Identifier: MIT */
#include "heads/stretch.h"

#include <math.h>
#include <string.h>

#include "air/incident_sound.h"
#include "contact/slot_compliance.h"
#include "heads/hihat_air.h"
#include "heads/pedal.h"
#include "heads/stretch_law.h"
#include "wires/wire_motion.h"

/* W = P S2/2, S2 = (1 + A P/2)^-1 for symmetric A = Y^T g Y. */
static void weigh(uint32_t count, double a[TB_COUPLINGS][TB_COUPLINGS], const double *factor,
                  double weight[TB_COUPLINGS][TB_COUPLINGS]) {
  double n[TB_COUPLINGS][TB_COUPLINGS] = {{1.0, 0.0}, {0.0, 1.0}};
  for (uint32_t h = 0; h < count; h++) {
    for (uint32_t l = 0; l < count; l++) n[h][l] += 0.5 * a[h][l] * factor[l];
  }
  const double determinant = n[0][0] * n[1][1] - n[0][1] * n[1][0];
  weight[0][0] = 0.5 * factor[0] * (n[1][1] / determinant);
  weight[0][1] = -0.5 * factor[0] * (n[0][1] / determinant);
  weight[1][0] = -0.5 * factor[1] * (n[1][0] / determinant);
  weight[1][1] = 0.5 * factor[1] * (n[0][0] / determinant);
}

/* P theta of head h, where Y^T (x + q-) is `along`. */
static double tension(const TbView *view, uint32_t h, const double along[TB_COUPLINGS]) {
  const double *w = view->solve.in.stretch_weight[h];
  return w[0] * along[0] + w[1] * along[1];
}

/* side r = side Y^T g Phi at the slots: the solve needs r but for its sign, and on the grid under
 * the wires displacements of their head are the simpler. */
static void prepare_slots(TbView *view) {
  const TaborModel *model = view->model;
  const TbStretch *stretch = &model->stretch;
  const double *const pull[TB_COUPLINGS] = {view->stretch.pull[0], view->stretch.pull[1]};
  memset(view->solve.in.stretch_slots, 0, sizeof view->solve.in.stretch_slots);
  for (uint32_t slot = 0; view->state->strikers.mask >> slot; slot++) {
    if (!tb_slot_in_play(tb_slot(view, slot))) continue;
    const TbSlot *s = tb_slot(view, slot);
    const TbParts *felt = s->on_hoop ? &stretch->parts : &stretch->felt[s->head];
    const TbPair r = model->kernels->stretch_dots(felt, pull, tb_slot_shape(view, slot));
    view->solve.in.stretch_slots[0][slot] = model->wires.side * r.first;
    if (stretch->count == 2) view->solve.in.stretch_slots[1][slot] = model->wires.side * r.second;
  }
}

/* side r on the grid under the wires. */
static void prepare_grid(TbView *view) {
  const TaborModel *model = view->model;
  const uint32_t size = model->projection.wire_grid.size;
  tb_wire_motion_of(view)->stretch(view);
  for (uint32_t h = 0; h < model->stretch.count; h++) {
    view->stretch.rest[h] =
      model->wires.side *
      model->kernels->dot(size, view->solve.in.stretch_grid[h], model->rest.grid);
  }
}

static const TbStretchLaw *law_of(const TbView *view) {
  return view->model->plate.tables.pairs > 0 ? &tb_von_karman : &tb_berger;
}

/* ---- the step ------------------------------------------------------------------------------- */

static TbStretching stretching_of(const TbView *view) {
  const TbModes *modes = &view->model->modes;
  const TbStretch *stretch = &view->model->stretch;
  return (TbStretching){.a = modes->a,
                        .b = modes->b,
                        .gain = {stretch->gain[0], stretch->gain[1]},
                        .g = modes->g,
                        .q = view->now.q,
                        .last = view->last.q,
                        .mixed = {view->stretch.mixed[0], view->stretch.mixed[1]},
                        .next = view->next.q,
                        .pull = {view->stretch.pull[0], view->stretch.pull[1]}};
}

static void move_alone(const TbView *view) {
  const TbModes *modes = &view->model->modes;
  for (uint32_t part = 0; part < view->moving.count; part++) {
    const uint32_t from = view->moving.from[part];
    view->model->kernels->two_step(view->moving.end[part] - from, view->next.q + from,
                                   modes->a + from, view->now.q + from, modes->b + from,
                                   view->last.q + from);
  }
}

/* One pass moves the modes and finds the sums of tb_stretch_free(); what sound from outside adds to
 * them is known then. */
void tb_stretch_move(TbView *view) {
  const TaborModel *model = view->model;
  view->stretch.count = law_of(view)->begin(view);
  view->stretch.summed = view->stretch.count > 0 && model->lugs.count == 0;
  if (view->stretch.summed) {
    view->stretch.sums = stretching_of(view);
    model->kernels->step_and_stretch(&view->moving, &view->stretch.sums);
  } else {
    move_alone(view);
  }
}

void tb_stretch_free(TbView *view) {
  const TaborModel *model = view->model;
  const TbStretch *stretch = &model->stretch;
  view->solve.in.stretch_count = view->stretch.count;
  if (view->stretch.count == 0) return;
  if (!view->stretch.summed) {
    view->stretch.sums = stretching_of(view);
    model->kernels->stretch(&view->moving, &view->stretch.sums);
  }
  weigh(stretch->count, view->stretch.sums.own, stretch->factor, view->solve.in.stretch_weight);
  for (uint32_t h = 0; h < stretch->count; h++) {
    view->stretch.along[h] = view->stretch.sums.along[h] + law_of(view)->shift(view);
    if (view->stretch.summed) /* y g F of what has pushed the modes since */
      view->stretch.along[h] += tb_incident_product(view, view->stretch.pull[h]) +
                                tb_pedal_product(view, view->stretch.pull[h]) +
                                tb_hihat_air_product(view, view->stretch.pull[h]);
    view->stretch.rest[h] = 0.0;
  }
  prepare_slots(view);
  if (!view->state->wires.lifted) prepare_grid(view);
}

void tb_stretch_yield(TbView *view, double *slots) {
  const TaborModel *model = view->model;
  double along[TB_COUPLINGS] = {0.0};
  for (uint32_t i = 0; i < TB_SLOTS; i++) slots[i] = 0.0;
  for (uint32_t h = 0; h < view->stretch.count; h++) {
    along[h] = view->stretch.along[h] + view->stretch.rest[h];
  }
  for (uint32_t h = 0; h < view->stretch.count; h++) {
    const double pull = -tension(view, h, along);
    model->kernels->axpy(TB_SLOTS, slots, model->wires.side * pull,
                         view->solve.in.stretch_slots[h]);
    if (view->state->wires.lifted) continue;
    model->kernels->axpy(model->projection.wire_grid.size, view->change, pull,
                         view->solve.in.stretch_grid[h]);
  }
}

void tb_stretch_renew(TbView *view) {
  TbSolve *solve = &view->solve;
  if (view->model->stretch.count == 0 || view->state->airborne) return;
  if (view->stretch.count == 0 && view->state->unstretched > view->model->stretch.hold) return;
  const uint32_t size = solve->in.wire_grid->size, stride = tb_wire_rows(&solve->in.rows);
  double *carry = view->stretch.carry;
  tb_solve_stretch(&solve->in, solve->warm.grid, solve->warm.force + stride, carry, carry + size);
  if (!view->state->wires.lifted) tb_wire_motion_of(view)->renew(view, carry);
  solve->in.kernels->axpy(TB_SLOTS, solve->warm.product + stride, 1.0, carry + size);
}

/* side r f, by all contacts. */
static double pushed_along(const TbView *view, uint32_t h) {
  const TbSolve *solve = &view->solve;
  const double slots = solve->in.kernels->dot(TB_SLOTS, solve->in.stretch_slots[h],
                                              solve->warm.force + tb_slot_row(&solve->in.rows, 0));
  if (view->state->wires.lifted) return slots;
  return solve->in.kernels->dot(solve->in.wire_grid->size, solve->in.stretch_grid[h],
                                solve->warm.grid) +
         slots;
}

void tb_stretch_respond(TbView *view) {
  const TaborModel *model = view->model;
  double pushed[TB_COUPLINGS] = {0.0}, along[TB_COUPLINGS] = {0.0};
  for (uint32_t h = 0; h < view->stretch.count; h++) {
    pushed[h] = pushed_along(view, h);
    along[h] = view->stretch.along[h] - (model->wires.side * pushed[h] - view->stretch.rest[h]);
  }
  tb_stretch_clear(view);
  const uint32_t size = model->projection.wire_grid.size;
  for (uint32_t h = 0; h < view->stretch.count; h++) {
    view->end.stretch[h] = -tension(view, h, along);
    const double past = tension(view, h, pushed);
    model->kernels->axpy(size, view->stretch.carry, past, view->solve.in.stretch_grid[h]);
    model->kernels->axpy(TB_SLOTS, view->stretch.carry + size, past,
                         view->solve.in.stretch_slots[h]);
  }
  view->solve.in.stretch_count = 0; /* it belongs to this sample alone */
  law_of(view)->end(view);
}

void tb_stretch_clear(TbView *view) {
  memset(view->stretch.carry, 0,
         (view->model->projection.wire_grid.size + TB_SLOTS) * sizeof *view->stretch.carry);
}

double tb_stretch_energy(const TbView *view, const TbPhase *next, const TbPhase *now) {
  return law_of(view)->energy(view, next, now);
}
