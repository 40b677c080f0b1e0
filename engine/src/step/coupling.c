/* SPDX-License-Identifier: MIT */
#include "step/coupling.h"

#include "step/stretch.h"

void tb_coupling_renew(TbView *view) {
  view->solve.slot_mask = view->state->slot_mask;
  tb_solve_product(&view->solve, view->model->rest.force, view->change, view->rest_load);
  tb_solve_product(&view->solve, view->solve.force, view->solve.grid, view->solve.product);
  tb_stretch_clear(view);
}
