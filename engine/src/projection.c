/* SPDX-License-Identifier: MIT */
#include "projection.h"

void tb_project(const TbProjection *p, const TbKernels *kernels, const double *q, double *grid) {
  for (uint32_t g = 0; g < p->groups; g++) {
    const TbProjectionGroup *group = &p->group[g];
    kernels->multiply(group->points / 8, group->modes, grid + group->first_point, group->gather,
                      q + group->first);
  }
}

void tb_project_forces(const TbProjection *p, const TbKernels *kernels, const double *grid,
                       double *modal) {
  for (uint32_t g = 0; g < p->groups; g++) {
    const TbProjectionGroup *group = &p->group[g];
    kernels->multiply(group->modes / 8, group->points, modal + group->first, group->scatter,
                      grid + group->first_point);
  }
}
