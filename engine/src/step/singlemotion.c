/* SPDX-License-Identifier: MIT */
#include "step/singlemotion.h"

#include "step/penetration.h"
#include "step/singlesolve.h"

/* So few points that a block of eight is not worth while for them. */
static const uint32_t FEW = 2;

/* A group's table from modes to points, of which the first `part` modes count. */
static TbSingleGather from_modes(const TbProjectionGroup *group, uint32_t part) {
  const uint32_t left = group->used % 8u, rest = left <= FEW ? left : 0u;
  const uint32_t blocks = rest ? group->used / 8u : group->points / 8u;
  return (TbSingleGather){.blocks = blocks,
                          .n = group->modes,
                          .part = part,
                          .rest = rest,
                          .stride = group->points,
                          .matrix = group->gather_single,
                          .transposed = group->scatter_single + 64u * blocks};
}

void tb_single_project(TbView *view) {
  const TbProjection *projection = &view->model->projection;
  const TbSingle *single = &view->solve.single;
  for (uint32_t g = 0; g < projection->groups; g++) {
    const TbProjectionGroup *group = &projection->group[g];
    TbSingleGather gather = from_modes(group, group->modes);
    gather.vectors = 1;
    gather.x[0] = single->modal[0];
    gather.out[0] = view->change + group->first_point;
    single->kernels->narrow_change(group->modes, view->next.q + group->first,
                                   view->last.q + group->first, single->modal[0]);
    single->kernels->gather(&gather);
  }
}

void tb_single_stretch(TbView *view) {
  const TaborModel *model = view->model;
  const TbSingle *single = &view->solve.single;
  for (uint32_t g = 0; g < model->projection.groups; g++) {
    const TbProjectionGroup *group = &model->projection.group[g];
    TbSingleGather gather = from_modes(group, model->stretch.parts.size[g]);
    gather.vectors = model->stretch.count;
    for (uint32_t h = 0; h < model->stretch.count; h++) {
      single->kernels->narrow(gather.part, view->stretch_pull[h] + group->first, single->modal[h]);
      gather.x[h] = single->modal[h];
      gather.out[h] = view->solve.stretch_grid[h] + group->first_point;
    }
    single->kernels->gather(&gather);
  }
}

void tb_single_project_forces(TbView *view) {
  const TbProjection *projection = &view->model->projection;
  const TbSingle *single = &view->solve.single;
  single->kernels->narrow(projection->bed.size, view->change, single->answer);
  for (uint32_t g = 0; g < projection->groups; g++) {
    const TbProjectionGroup *group = &projection->group[g];
    const TbSingleGather scatter = {.vectors = 1,
                                    .blocks = group->modes / 8u,
                                    .n = group->points,
                                    .part = (group->used + 3u) & ~3u,
                                    .matrix = group->scatter_single,
                                    .x = {single->answer + group->first_point},
                                    .out = {view->modal + group->first}};
    single->kernels->gather(&scatter);
  }
}

void tb_single_penetrate(TbView *view) {
  const TbWires *wires = &view->model->wires;
  const TbSingle *single = &view->solve.single;
  single->kernels->narrow(single->bed->size, view->change, single->answer);
  single->kernels->expand(single->bed, single->answer, single->scratch, single->moved);
  view->solve.near = single->kernels->penetrate(
    wires->stride, (float)wires->side, single->moved, view->next.v + TB_WIRE_FRONT,
    view->last.v + TB_WIRE_FRONT, view->rest_load, view->last.eta, view->b);
}

void tb_single_renew(TbView *view, const double *motion) {
  const TbSingle *single = &view->solve.single;
  single->kernels->narrow(single->bed->size, motion, single->answer);
  single->kernels->expand(single->bed, single->answer, single->scratch, single->moved);
  single->kernels->add_widened(view->solve.stride, single->moved, view->solve.product);
}

void tb_single_settle(TbView *view) {
  if (!tb_solves_in_single(&view->solve)) return;
  tb_penetrations_from_displacements(view, &view->now);
  tb_penetrations_from_displacements(view, &view->last);
}
