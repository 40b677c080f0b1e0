/* SPDX-License-Identifier: MIT */
#include "model/wire_reach.h"

#include <math.h>
#include <string.h>

static void largest_shapes(TaborModel *model, const TbProjectionGroup *group, double *grid,
                           double *fold, double *rows, double *reach) {
  const TbWireGrid *wire_grid = &model->projection.wire_grid;
  for (uint32_t i = 0; i < group->modes && tb_arena_go_on(&model->arena); i++) {
    for (uint32_t p = 0; p < group->points; p++) {
      grid[group->first_point + p] = group->gather[((p / 8) * group->modes + i) * 8 + p % 8];
    }
    model->kernels->grid_to_rows(wire_grid, grid, fold, rows);
    for (uint32_t row = 0; row < model->wires.stride; row++) {
      reach[group->first + i] = fmax(reach[group->first + i], fabs(rows[row]));
    }
  }
  memset(grid + group->first_point, 0, group->points * sizeof *grid);
}

TaborStatus tb_wire_reach_prepare(TaborModel *model, TbArena *scratch) {
  const TbProjection *p = &model->projection;
  double *grid = tb_arena_doubles(scratch, p->wire_grid.size);
  double *fold = tb_arena_doubles(scratch, tb_wire_grid_scratch(&p->wire_grid));
  double *rows = tb_arena_doubles(scratch, model->wires.stride);
  model->reach = tb_arena_doubles(&model->arena, model->modes.padded);
  if (model->arena.failed || scratch->failed) return TABOR_ERROR_MEMORY;
  if (model->wires.count == 0) return TABOR_OK;
  for (uint32_t g = 0; g < p->groups; g++) {
    largest_shapes(model, &p->group[g], grid, fold, rows, model->reach);
  }
  return model->arena.failed ? TABOR_ERROR_MEMORY : TABOR_OK;
}
