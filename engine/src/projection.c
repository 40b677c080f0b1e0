/* SPDX-License-Identifier: MIT */
#include "projection.h"

#include <math.h>

/* Pairs of rows that mirror each other; without symmetry every row stands for itself. */
static void pair_rows(TbProjection *p, const TbWires *wires) {
  for (uint32_t w = 0; w < wires->count; w++) {
    const TbWire *wire = &wires->wires[w];
    const uint32_t rows = wires->mirrored ? (wire->row_count + 1) / 2 : wire->row_count;
    for (uint32_t i = 0; i < rows; i++) {
      p->left[p->folded] = wire->first_row + i;
      p->right[p->folded++] = wire->first_row + (wires->mirrored ? wire->row_count - 1 - i : i);
    }
  }
}

/* Shapes of all modes at one folded point into both matrices. */
static void fill_point(TbProjection *p, uint32_t point, const double *shape) {
  for (uint32_t g = 0; g < p->groups; g++) {
    TbProjectionGroup *group = &p->group[g];
    for (uint32_t i = 0; i < group->modes; i++) {
      const double value = shape[group->first + i];
      group->gather[((size_t)(point / 8) * group->modes + i) * 8 + point % 8] = value;
      group->scatter[((size_t)(i / 8) * p->folded + point) * 8 + i % 8] = value;
    }
  }
}

TaborStatus tb_projection_prepare(TbProjection *p, TbArena *arena, const TbModes *modes,
                                  const TbHead *head, const TbWires *wires) {
  TbArena scratch;
  tb_arena_prepare(&scratch, &arena->allocator);
  *p = (TbProjection){.groups = modes->groups, .stride = wires->stride};
  p->left = tb_arena_take(arena, wires->stride, sizeof *p->left);
  p->right = tb_arena_take(arena, wires->stride, sizeof *p->right);
  double *radial = tb_arena_doubles(&scratch, head->row_count);
  double *shape = tb_arena_doubles(&scratch, modes->padded);
  if (!arena->failed) pair_rows(p, wires);
  p->points = tb_pad(p->folded);
  for (uint32_t g = 0; g < p->groups; g++) {
    TbProjectionGroup *group = &p->group[g];
    group->first = modes->group[g];
    group->modes = modes->group[g + 1] - modes->group[g];
    group->gather = tb_arena_doubles(arena, (size_t)p->points * group->modes);
    group->scatter = tb_arena_doubles(arena, (size_t)p->folded * group->modes);
  }
  const bool failed = arena->failed || scratch.failed;
  for (uint32_t point = 0; !failed && point < p->folded; point++) {
    const double x = wires->row_x[p->left[point]], y = wires->row_y[p->left[point]];
    const double r = sqrt(x * x + y * y);
    tb_modes_shape(modes, head, wires->head, r, r > 0.0 ? y / r : 0.0, r > 0.0 ? x / r : 1.0, NULL,
                   radial, shape);
    fill_point(p, point, shape);
  }
  tb_arena_release(&scratch);
  return failed ? TABOR_ERROR_MEMORY : TABOR_OK;
}

void tb_project(const TbProjection *p, const TbKernels *kernels, const double *q, double *scratch,
                double *w) {
  double *even = scratch, *odd = scratch + p->points;
  for (uint32_t g = 0; g < p->groups; g++) {
    const TbProjectionGroup *group = &p->group[g];
    kernels->multiply(p->points / 8, group->modes, g ? odd : even, group->gather, q + group->first);
  }
  for (uint32_t row = 0; row < p->stride; row++) w[row] = 0.0;
  if (p->groups == 1) {
    for (uint32_t i = 0; i < p->folded; i++) w[p->left[i]] = even[i];
    return;
  }
  for (uint32_t i = 0; i < p->folded; i++) {
    w[p->right[i]] = even[i] - odd[i];
    w[p->left[i]] = even[i] + odd[i]; /* last, for a point on the mirror: odd is 0 there */
  }
}

void tb_project_forces(const TbProjection *p, const TbKernels *kernels, const double *f,
                       double *scratch, double *modal) {
  double *even = scratch, *odd = scratch + p->points;
  for (uint32_t i = 0; i < p->folded; i++) {
    const double left = f[p->left[i]];
    const double right = p->left[i] == p->right[i] ? 0.0 : f[p->right[i]];
    even[i] = left + right;
    odd[i] = left - right;
  }
  for (uint32_t g = 0; g < p->groups; g++) {
    const TbProjectionGroup *group = &p->group[g];
    kernels->multiply(group->modes / 8, p->folded, modal + group->first, group->scatter,
                      g ? odd : even);
  }
}
