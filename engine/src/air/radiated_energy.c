/* SPDX-License-Identifier: MIT */
#include "air/radiated_energy.h"

#include "air/incident_sound.h"

/* Energy that one group of modes radiates in a step beyond the losses of its modes. */
static double beyond(const TbView *view, uint32_t group) {
  const TbRadiatedPower *power = &view->model->power;
  const uint32_t first = power->group[group], count = power->group[group + 1] - first;
  const size_t at = (size_t)first * TB_FAR_NODES;
  double lost = 0.0;
  for (uint32_t entry = first; entry < first + count; entry++) {
    const double moved = view->next.q[power->mode[entry]] - view->last.q[power->mode[entry]];
    lost += power->loss[entry] * moved * moved;
  }
  return view->model->kernels->radiated_power(count, power->mode + first, power->ahead + at,
                                              power->behind + at, view->next.q, view->now.q,
                                              view->last.q) -
         lost;
}

double tb_radiated_beyond(const TbView *view) {
  double sum = 0.0;
  if (view->state->clock % TB_FAR_STEPS != 0 || tb_incident_pushes(view)) return 0.0;
  for (uint32_t group = 0; group < TB_FAR_GROUPS; group++) sum += beyond(view, group);
  return sum;
}
