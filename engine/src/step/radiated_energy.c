/* SPDX-License-Identifier: MIT */
#include "step/radiated_energy.h"

double tb_radiated_energy(const TbView *view) {
  const TbRadiatedPower *power = &view->model->power;
  double sum = 0.0;
  if (view->state->clock % TB_FAR_STEPS != 0) return 0.0;
  for (uint32_t group = 0; group < TB_FAR_GROUPS; group++) {
    const uint32_t first = power->group[group];
    const size_t at = (size_t)first * TB_FAR_NODES;
    sum += view->model->kernels->radiate(power->group[group + 1] - first, power->mode + first,
                                         power->ahead + at, power->behind + at, view->next.q,
                                         view->now.q, view->last.q);
  }
  return sum;
}
