/* SPDX-License-Identifier: MIT */
#include "projection.h"

static float *round_table(TbArena *arena, double *table, size_t count) {
  float *single = tb_arena_take(arena, count, sizeof *single);
  if (!single) return NULL;
  for (size_t i = 0; i < count; i++) {
    single[i] = (float)table[i];
    table[i] = (double)single[i];
  }
  return single;
}

bool tb_projection_round(TbProjection *p, TbArena *arena) {
  for (uint32_t g = 0; g < p->groups; g++) {
    TbProjectionGroup *group = &p->group[g];
    const size_t count = (size_t)group->points * group->modes;
    group->gather_single = round_table(arena, group->gather, count);
    group->scatter_single = round_table(arena, group->scatter, count);
  }
  return !arena->failed;
}

void tb_project(const TbProjection *p, const TbKernels *kernels, const double *q, double *grid) {
  for (uint32_t g = 0; g < p->groups; g++) {
    const TbProjectionGroup *group = &p->group[g];
    double *points = grid + group->first_point;
    if (group->gather_single) {
      kernels->multiply_single(group->points / 8, group->modes, points, group->gather_single,
                               q + group->first);
    } else {
      kernels->multiply(group->points / 8, group->modes, points, group->gather, q + group->first);
    }
  }
}

void tb_project_forces(const TbProjection *p, const TbKernels *kernels, const double *grid,
                       double *modal) {
  for (uint32_t g = 0; g < p->groups; g++) {
    const TbProjectionGroup *group = &p->group[g];
    const double *points = grid + group->first_point;
    if (group->scatter_single) {
      kernels->multiply_single(group->modes / 8, group->points, modal + group->first,
                               group->scatter_single, points);
    } else {
      kernels->multiply(group->modes / 8, group->points, modal + group->first, group->scatter,
                        points);
    }
  }
}
