/* SPDX-License-Identifier: MIT */
#include "step/pedal.h"

/* Of the foot, from its place at rest [m]. */
static double risen(const TbView *view) {
  return view->state->live.values[TB_LIVE_OPENING].now - view->model->def.hihat.opening;
}

bool tb_pedal_rests(const TbView *view) {
  return view->model->rod.count == 0 || risen(view) == 0.0;
}

void tb_pedal_push(TbView *view) {
  if (tb_pedal_rests(view)) return;
  const TbRod *rod = &view->model->rod;
  const double *g = view->model->modes.g, z = risen(view);
  for (uint32_t i = 0; i < rod->count; i++) {
    view->next.q[rod->mode[i]] += g[rod->mode[i]] * (rod->push[i] * z);
  }
}

double tb_pedal_work(const TbView *view) {
  if (tb_pedal_rests(view)) return 0.0;
  const TbRod *rod = &view->model->rod;
  double sum = 0.0;
  for (uint32_t i = 0; i < rod->count; i++) {
    const uint32_t mode = rod->mode[i];
    sum += rod->push[i] * (view->next.q[mode] - view->last.q[mode]);
  }
  return 0.5 * risen(view) * sum;
}
