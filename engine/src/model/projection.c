/* SPDX-License-Identifier: MIT */
#include "model/projection.h"

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

/* out[8 blocks] = table x[n], by whichever of the two tables there is. */
static void apply(const TbKernels *kernels, const double *table, const float *single,
                  uint32_t blocks, uint32_t n, double *out, const double *x) {
  if (single) {
    kernels->multiply_single(blocks, n, out, single, x);
  } else {
    kernels->multiply(blocks, n, out, table, x);
  }
}

void tb_project(const TbProjection *p, const TbKernels *kernels, const double *q, double *grid) {
  for (uint32_t g = 0; g < p->groups; g++) {
    const TbProjectionGroup *group = &p->group[g];
    apply(kernels, group->gather, group->gather_single, group->points / 8, group->modes,
          grid + group->first_point, q + group->first);
  }
}

void tb_project_forces(const TbProjection *p, const TbKernels *kernels, const double *grid,
                       double *modal) {
  for (uint32_t g = 0; g < p->groups; g++) {
    const TbProjectionGroup *group = &p->group[g];
    apply(kernels, group->scatter, group->scatter_single, group->modes / 8, group->points,
          modal + group->first, grid + group->first_point);
  }
}
