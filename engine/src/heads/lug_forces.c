/* SPDX-License-Identifier: MIT */
#include "heads/lug_forces.h"

/* dK q, of the coupled modes one after another. */
static void pull_of(const TaborModel *model, const double *q, double *pull) {
  const TbLugs *lugs = &model->lugs;
  _Alignas(64) double gathered[TB_LUG_MODES];
  uint32_t next = 0;
  for (uint32_t group = 0; group <= model->modes.groups; group++) {
    const double *from = q + lugs->from[group];
    for (uint32_t i = 0; i < lugs->size[group]; i++) gathered[next++] = from[i];
  }
  model->kernels->gemv_rounded(lugs->count / 8, lugs->count, pull, lugs->pull, gathered);
}

void tb_lug_forces_pull(TbView *view) {
  const TaborModel *model = view->model;
  const TbLugs *lugs = &model->lugs;
  if (lugs->count == 0) return;
  _Alignas(64) double pull[TB_LUG_MODES];
  pull_of(model, view->now.q, pull);
  uint32_t next = 0;
  for (uint32_t group = 0; group <= model->modes.groups; group++) {
    const uint32_t from = lugs->from[group];
    for (uint32_t i = from; i < from + lugs->size[group]; i++) {
      view->next.q[i] -= model->modes.g[i] * pull[next++];
    }
  }
}

double tb_lug_forces_energy(const TbView *view, const double *next, const double *now) {
  const TaborModel *model = view->model;
  const TbLugs *lugs = &model->lugs;
  if (lugs->count == 0) return 0.0;
  _Alignas(64) double pull[TB_LUG_MODES];
  pull_of(model, now, pull);
  double sum = 0.0;
  uint32_t place = 0;
  for (uint32_t group = 0; group <= model->modes.groups; group++) {
    const uint32_t from = lugs->from[group];
    for (uint32_t i = from; i < from + lugs->size[group]; i++) sum += next[i] * pull[place++];
  }
  return 0.5 * sum;
}
