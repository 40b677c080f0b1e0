/* SPDX-License-Identifier: MIT */
#include "step/penetration.h"

void tb_penetrations_from_displacements(TbView *view, TbPhase *phase) {
  const TaborModel *model = view->model;
  const TbWires *wires = &model->wires;
  tb_project(&model->projection, model->kernels, phase->q, view->change);
  model->kernels->expand(&model->projection.wire_grid, view->change, view->solve.work.scratch,
                         phase->eta);
  for (uint32_t row = 0; row < wires->stride; row++) {
    const double deviation = wires->side * phase->eta[row] - phase->v[row + TB_WIRE_FRONT];
    phase->eta[row] = deviation + model->rest.eta[row] + view->state->shift[wires->row_wire[row]];
  }
}
