/* SPDX-License-Identifier: MIT */
/* The wires' motion (wire_motion.h) in double. */
#include "wires/wire_motion.h"

#include "kernels/profile.h"

static void project(TbView *view) {
  tb_project(&view->model->projection, view->model->kernels, view->next.q, view->change);
}

static void stretch(TbView *view) {
  const TaborModel *model = view->model;
  tb_project_parts(&model->projection, model->kernels, &model->stretch.parts, model->stretch.count,
                   view->stretch.pull, view->solve.in.stretch_grid);
}

static void penetrate(TbView *view) {
  const TaborModel *model = view->model;
  const TbWires *wires = &model->wires;
  model->kernels->grid_to_rows(&model->projection.wire_grid, view->change, view->solve.work.scratch,
                               view->head);
  TB_STAGE(WIRES);
  model->kernels->penetrate(wires->count, wires->lanes, wires->side, view->state->wires.shift,
                            view->head, view->next.v + TB_WIRE_FRONT, model->rest.eta,
                            view->last.eta, view->rest_load, view->b);
}

static void renew(TbView *view, const double *motion) {
  const TbKernels *kernels = view->model->kernels;
  const TbSolve *solve = &view->solve;
  kernels->grid_to_rows(solve->in.wire_grid, motion, solve->work.scratch, solve->work.turned);
  kernels->axpy(tb_wire_rows(&solve->in.rows), solve->warm.product, 1.0, solve->work.turned);
}

static void project_forces(TbView *view) {
  tb_project_forces(&view->model->projection, view->model->kernels, view->change, view->modal);
}

static void settle(TbView *view) { (void)view; }

const TbWireMotion tb_wire_motion = {project, stretch, penetrate, renew, project_forces, settle};

void tb_penetrations_from_displacements(TbView *view, TbPhase *phase) {
  const TaborModel *model = view->model;
  const TbWires *wires = &model->wires;
  tb_project(&model->projection, model->kernels, phase->q, view->change);
  model->kernels->grid_to_rows(&model->projection.wire_grid, view->change, view->solve.work.scratch,
                               phase->eta);
  for (uint32_t row = 0; row < wires->stride; row++) {
    const double deviation = wires->side * phase->eta[row] - phase->v[row + TB_WIRE_FRONT];
    phase->eta[row] =
      deviation + model->rest.eta[row] + view->state->wires.shift[wires->row_wire[row]];
  }
}
