/* SPDX-License-Identifier: MIT */
#include "model/projection.h"

#include <string.h>

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
  if (group->runs > 0) group->along_rounded = round_table(arena, group->along, group->modes);
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

/* Modes of a run among the first `part` of its group, among which it begins. */
static uint32_t run_part(const TbProjectionRun *run, uint32_t part) {
  const uint32_t left = part - run->first;
  return run->modes < left ? run->modes : left;
}

void tb_project_runs(const TbProjectionGroup *group, const TbKernels *kernels, uint32_t part,
                     const double *q, double *grid) {
  memset(grid, 0, group->points * sizeof *grid);
  for (uint32_t r = 0; r < group->runs && group->run[r].first < part; r++) {
    const TbProjectionRun *run = &group->run[r];
    grid[run->point] +=
      kernels->dot(run_part(run, part), group->along + run->first, q + run->first);
  }
}

void tb_project_runsf(const TbProjectionGroup *group, const TbKernelsF *kernels, uint32_t part,
                      const float *q, double *grid) {
  memset(grid, 0, group->points * sizeof *grid);
  for (uint32_t r = 0; r < group->runs && group->run[r].first < part; r++) {
    const TbProjectionRun *run = &group->run[r];
    grid[run->point] +=
      (double)kernels->dot(run_part(run, part), group->along_rounded + run->first, q + run->first);
  }
}

void tb_project_run_forces(const TbProjectionGroup *group, const TbKernels *kernels,
                           const double *grid, double *modal) {
  memset(modal, 0, group->modes * sizeof *modal);
  for (uint32_t r = 0; r < group->runs; r++) {
    const TbProjectionRun *run = &group->run[r];
    kernels->axpy(run->modes, modal + run->first, grid[run->point], group->along + run->first);
  }
}

/* One class, by the tables of either precision. The audio thread calls them. */
typedef struct Tables {
  void (*project)(const TbProjectionGroup *group, const TbKernels *kernels, const double *q,
                  double *grid);
  void (*project_forces)(const TbProjectionGroup *group, const TbKernels *kernels,
                         const double *grid, double *modal);
  void (*gather)(const TbProjectionGroup *group, const TbKernels *kernels, const TbGather *gather);
} Tables;

static void project(const TbProjectionGroup *group, const TbKernels *kernels, const double *q,
                    double *grid) {
  kernels->gemv(group->points / 8, group->modes, grid, group->gather, q);
}

static void project_forces(const TbProjectionGroup *group, const TbKernels *kernels,
                           const double *grid, double *modal) {
  kernels->gemv(group->modes / 8, group->points, modal, group->scatter, grid);
}

static void gather(const TbProjectionGroup *group, const TbKernels *kernels,
                   const TbGather *gather) {
  (void)group;
  kernels->gemm(gather);
}

static void project_rounded(const TbProjectionGroup *group, const TbKernels *kernels,
                            const double *q, double *grid) {
  kernels->gemv_rounded(group->points / 8, group->modes, grid, group->gather_rounded, q);
}

static void project_forces_rounded(const TbProjectionGroup *group, const TbKernels *kernels,
                                   const double *grid, double *modal) {
  kernels->gemv_rounded(group->modes / 8, group->points, modal, group->scatter_rounded, grid);
}

static void gather_rounded(const TbProjectionGroup *group, const TbKernels *kernels,
                           const TbGather *gather) {
  (void)group;
  kernels->gemm_rounded(gather);
}

static const Tables TABLES[] = {
  [TB_IN_DOUBLE] = {project, project_forces, gather},
  [TB_IN_FLOAT] = {project_rounded, project_forces_rounded, gather_rounded},
};

static void project_all_runs(const TbProjectionGroup *group, const TbKernels *kernels,
                             const double *q, double *grid) {
  tb_project_runs(group, kernels, group->modes, q, grid);
}

static void gather_runs(const TbProjectionGroup *group, const TbKernels *kernels,
                        const TbGather *gather) {
  for (uint32_t v = 0; v < gather->vectors; v++) {
    tb_project_runs(group, kernels, gather->part, gather->x[v], gather->out[v]);
  }
}

static const Tables RUNS = {project_all_runs, tb_project_run_forces, gather_runs};

static const Tables *tables_of(const TbProjection *p, const TbProjectionGroup *group) {
  return group->runs > 0 ? &RUNS : &TABLES[p->precision];
}

void tb_project(const TbProjection *p, const TbKernels *kernels, const double *q, double *grid) {
  for (uint32_t g = 0; g < p->groups; g++) {
    const TbProjectionGroup *group = &p->group[g];
    tables_of(p, group)->project(group, kernels, q + group->first, grid + group->first_point);
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
    tables_of(p, group)->gather(group, kernels, &gather);
  }
}

void tb_project_forces(const TbProjection *p, const TbKernels *kernels, const double *grid,
                       double *modal) {
  for (uint32_t g = 0; g < p->groups; g++) {
    const TbProjectionGroup *group = &p->group[g];
    tables_of(p, group)->project_forces(group, kernels, grid + group->first_point,
                                        modal + group->first);
  }
}
