/* SPDX-License-Identifier: MIT */
#include "singlemotion.h"

#include "lift.h"
#include "singlesolve.h"

void tb_single_project(TbView *view) {
  const TbProjection *projection = &view->model->projection;
  const TbSingle *single = &view->solve.single;
  for (uint32_t g = 0; g < projection->groups; g++) {
    const TbProjectionGroup *group = &projection->group[g];
    const TbSingleGather gather = {.vectors = 1,
                                   .blocks = group->points / 8u,
                                   .n = group->modes,
                                   .part = group->modes,
                                   .matrix = group->gather_single,
                                   .x = {single->modal},
                                   .out = {view->change + group->first_point}};
    single->kernels->narrow_change(group->modes, view->next.q + group->first,
                                   view->last.q + group->first, single->modal);
    single->kernels->gather(&gather);
  }
}

void tb_single_penetrate(TbView *view) {
  const TbWires *wires = &view->model->wires;
  const TbSingle *single = &view->solve.single;
  single->kernels->narrow(single->bed->size, view->change, single->answer);
  single->kernels->expand(single->bed, single->answer, single->scratch, single->moved);
  single->kernels->penetrate(wires->stride, (float)wires->side, single->moved,
                             view->next.v + TB_WIRE_FRONT, view->last.v + TB_WIRE_FRONT,
                             view->rest_load, view->b);
}

void tb_single_renew(TbView *view, const double *motion) {
  const TbSingle *single = &view->solve.single;
  single->kernels->narrow(single->bed->size, motion, single->answer);
  single->kernels->expand(single->bed, single->answer, single->scratch, single->moved);
  single->kernels->add_widened(view->solve.stride, single->moved, view->solve.product);
}

void tb_single_settle(TbView *view) {
  if (!tb_solves_in_single(&view->solve)) return;
  tb_lift_penetrations(view, &view->now);
  tb_lift_penetrations(view, &view->last);
}
