/* SPDX-License-Identifier: MIT */
/* Forces on some modes (model/rims.h) in a step. Audio-safe. */
#ifndef TB_MODE_FORCE_H
#define TB_MODE_FORCE_H

#include "state/state.h"

/* Adds a force of this size to the free motion in view->next. */
static inline void tb_mode_force_push(TbView *view, const TbModeForce *force, double size) {
  const double *g = view->model->modes.g;
  for (uint32_t i = 0; i < force->count; i++) {
    const uint32_t mode = force->mode[i];
    view->next.q[mode] += g[mode] * (force->along[mode] * size);
  }
}

/* Sum_i along_i x_i, x[modes padded]: how far x moves the force. */
static inline double tb_mode_force_along(const TbModeForce *force, const double *x) {
  double sum = 0.0;
  for (uint32_t i = 0; i < force->count; i++)
    sum += force->along[force->mode[i]] * x[force->mode[i]];
  return sum;
}

/* How far the step to view->next moves the force: half of its way since the last instant. */
static inline double tb_mode_force_way(const TbView *view, const TbModeForce *force) {
  return 0.5 *
         (tb_mode_force_along(force, view->next.q) - tb_mode_force_along(force, view->last.q));
}

#endif
