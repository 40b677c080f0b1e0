/* SPDX-License-Identifier: MIT */
/* The wires' motion (wire_motion.h) in single precision. */
#include "wires/wire_motion.h"

/* So few points that a block of eight is not worth while for them. */
static const uint32_t FEW = 2;

/* A group's table from modes to points, of which the first `part` modes count. */
static TbGatherF from_modes(const TbProjectionGroup *group, uint32_t part) {
  const uint32_t left = group->used % 8u, rest = left <= FEW ? left : 0u;
  const uint32_t blocks = rest ? group->used / 8u : group->points / 8u;
  return (TbGatherF){.blocks = blocks,
                     .n = group->modes,
                     .part = part,
                     .rest = rest,
                     .stride = group->points,
                     .matrix = group->gather_rounded,
                     .transposed = group->scatter_rounded + 64u * blocks};
}

static void project(TbView *view) {
  const TbProjection *projection = &view->model->projection;
  for (uint32_t g = 0; g < projection->groups; g++) {
    const TbProjectionGroup *group = &projection->group[g];
    TbGatherF gather = from_modes(group, group->modes);
    gather.vectors = 1;
    gather.x[0] = view->modalf[0];
    gather.out[0] = view->change + group->first_point;
    view->model->kernelsf->narrow_change(group->modes, view->next.q + group->first,
                                         view->last.q + group->first, view->modalf[0]);
    if (group->runs > 0) {
      tb_project_runsf(group, view->model->kernelsf, group->modes, view->modalf[0],
                       view->change + group->first_point);
      continue;
    }
    view->model->kernelsf->gemm(&gather);
  }
}

static void stretch(TbView *view) {
  const TaborModel *model = view->model;
  for (uint32_t g = 0; g < model->projection.groups; g++) {
    const TbProjectionGroup *group = &model->projection.group[g];
    TbGatherF gather = from_modes(group, model->stretch.parts.size[g]);
    gather.vectors = model->stretch.count;
    for (uint32_t h = 0; h < model->stretch.count; h++) {
      view->model->kernelsf->narrow(gather.part, view->stretch.pull[h] + group->first,
                                    view->modalf[h]);
      gather.x[h] = view->modalf[h];
      gather.out[h] = view->solve.in.stretch_grid[h] + group->first_point;
    }
    if (group->runs > 0) {
      tb_project_runsf(group, model->kernelsf, gather.part, view->modalf[0], gather.out[0]);
      continue;
    }
    view->model->kernelsf->gemm(&gather);
  }
}

static void project_forces(TbView *view) {
  const TbProjection *projection = &view->model->projection;
  const TbSolveWorkF *work = &view->solve.workf;
  view->model->kernelsf->narrow(projection->wire_grid.size, view->change, work->answer);
  for (uint32_t g = 0; g < projection->groups; g++) {
    const TbProjectionGroup *group = &projection->group[g];
    if (group->runs > 0) {
      tb_project_run_forces(group, view->model->kernels, view->change + group->first_point,
                            view->modal + group->first);
      continue;
    }
    const TbGatherF scatter = {.vectors = 1,
                               .blocks = group->modes / 8u,
                               .n = group->points,
                               .part = (group->used + 3u) & ~3u,
                               .matrix = group->scatter_rounded,
                               .x = {work->answer + group->first_point},
                               .out = {view->modal + group->first}};
    view->model->kernelsf->gemm(&scatter);
  }
}

static void penetrate(TbView *view) {
  const TbWires *wires = &view->model->wires;
  const TbSolveWorkF *work = &view->solve.workf;
  view->model->kernelsf->narrow(view->model->wire_gridf.size, view->change, work->answer);
  view->model->kernelsf->grid_to_rows(&view->model->wire_gridf, work->answer, work->scratch,
                                      work->moved);
  view->solve.in.near = view->model->kernelsf->penetrate(
    wires->stride, (float)wires->side, work->moved, view->next.v + TB_WIRE_FRONT,
    view->last.v + TB_WIRE_FRONT, view->rest_load, view->last.eta, view->b);
}

static void renew(TbView *view, const double *motion) {
  const TbSolveWorkF *work = &view->solve.workf;
  view->model->kernelsf->narrow(view->model->wire_gridf.size, motion, work->answer);
  view->model->kernelsf->grid_to_rows(&view->model->wire_gridf, work->answer, work->scratch,
                                      work->moved);
  view->model->kernelsf->add_widened(tb_wire_rows(&view->solve.in.rows), work->moved,
                                     view->solve.warm.product);
}

static void settle(TbView *view) {
  tb_penetrations_from_displacements(view, &view->now);
  tb_penetrations_from_displacements(view, &view->last);
}

const TbWireMotion tb_wire_motionf = {project, stretch, penetrate, renew, project_forces, settle};
