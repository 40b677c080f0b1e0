/* SPDX-License-Identifier: MIT */
#include "model/projection.h"

static float *round_table(TbArena *arena, double *table, size_t count) {
  float *rounded = tb_arena_take(arena, count, sizeof *rounded);
  if (!rounded) return NULL;
  for (size_t i = 0; i < count; i++) {
    rounded[i] = (float)table[i];
    table[i] = (double)rounded[i];
  }
  return rounded;
}

static void keep(TbProjectionGroup *group, TbArena *arena) { (void)group, (void)arena; }

static void round_both(TbProjectionGroup *group, TbArena *arena) {
  const size_t count = (size_t)group->points * group->modes;
  group->gather_rounded = round_table(arena, group->gather, count);
  group->scatter_rounded = round_table(arena, group->scatter, count);
}

/* Apart from TABLES, which the audio thread reaches. */
static void (*const ROUND[])(TbProjectionGroup *group, TbArena *arena) = {
  [TB_IN_DOUBLE] = keep,
  [TB_IN_FLOAT] = round_both,
};

bool tb_projection_round(TbProjection *p, TbArena *arena) {
  for (uint32_t g = 0; g < p->groups; g++) ROUND[p->precision](&p->group[g], arena);
  return !arena->failed;
}

/* One class, by the tables of either precision. The audio thread calls them. */
typedef struct Tables {
  void (*project)(const TbProjectionGroup *group, const TbKernels *kernels, const double *q,
                  double *grid);
  void (*project_forces)(const TbProjectionGroup *group, const TbKernels *kernels,
                         const double *grid, double *modal);
  void (*gather)(const TbKernels *kernels, const TbGather *gather);
} Tables;

static void project(const TbProjectionGroup *group, const TbKernels *kernels, const double *q,
                    double *grid) {
  kernels->gemv(group->points / 8, group->modes, grid, group->gather, q);
}

static void project_forces(const TbProjectionGroup *group, const TbKernels *kernels,
                           const double *grid, double *modal) {
  kernels->gemv(group->modes / 8, group->points, modal, group->scatter, grid);
}

static void gather(const TbKernels *kernels, const TbGather *gather) { kernels->gemm(gather); }

static void project_rounded(const TbProjectionGroup *group, const TbKernels *kernels,
                            const double *q, double *grid) {
  kernels->gemv_rounded(group->points / 8, group->modes, grid, group->gather_rounded, q);
}

static void project_forces_rounded(const TbProjectionGroup *group, const TbKernels *kernels,
                                   const double *grid, double *modal) {
  kernels->gemv_rounded(group->modes / 8, group->points, modal, group->scatter_rounded, grid);
}

static void gather_rounded(const TbKernels *kernels, const TbGather *gather) {
  kernels->gemm_rounded(gather);
}

static const Tables TABLES[] = {
  [TB_IN_DOUBLE] = {project, project_forces, gather},
  [TB_IN_FLOAT] = {project_rounded, project_forces_rounded, gather_rounded},
};

void tb_project(const TbProjection *p, const TbKernels *kernels, const double *q, double *grid) {
  for (uint32_t g = 0; g < p->groups; g++) {
    const TbProjectionGroup *group = &p->group[g];
    TABLES[p->precision].project(group, kernels, q + group->first, grid + group->first_point);
  }
}

void tb_project_parts(const TbProjection *p, const TbKernels *kernels, const TbParts *parts,
                      uint32_t vectors, double *const q[TB_COUPLINGS],
                      double *const grid[TB_COUPLINGS]) {
  for (uint32_t g = 0; g < p->groups; g++) {
    const TbProjectionGroup *group = &p->group[g];
    TbGather gather = {.vectors = vectors,
                       .blocks = group->points / 8u,
                       .n = group->modes,
                       .part = parts->size[g],
                       .matrix = group->gather,
                       .rounded = group->gather_rounded};
    for (uint32_t v = 0; v < vectors; v++) {
      gather.x[v] = q[v] + group->first;
      gather.out[v] = grid[v] + group->first_point;
    }
    TABLES[p->precision].gather(kernels, &gather);
  }
}

void tb_project_forces(const TbProjection *p, const TbKernels *kernels, const double *grid,
                       double *modal) {
  for (uint32_t g = 0; g < p->groups; g++) {
    const TbProjectionGroup *group = &p->group[g];
    TABLES[p->precision].project_forces(group, kernels, grid + group->first_point,
                                        modal + group->first);
  }
}
