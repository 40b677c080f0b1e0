/* SPDX-License-Identifier: MIT */
#include "heads/coupling.h"

#include "heads/stretch.h"

void tb_coupling_renew(TbView *view) {
  view->solve.in.slot_mask = view->state->strikers.mask;
  tb_solve_product(&view->solve, view->model->rest.force, view->change, view->rest_load);
  tb_solve_product(&view->solve, view->solve.warm.force, view->solve.warm.grid,
                   view->solve.warm.product);
  tb_stretch_clear(view);
}
