/* SPDX-License-Identifier: MIT */
#include "air/incident_sound.h"

static bool is_silent(const TbIncident *sound) { return sound->now == 0.0 && sound->before == 0.0; }

bool tb_incident_pushes(const TbView *view) { return !is_silent(&view->incident); }

bool tb_incident_pushes_all(const TbView *view) {
  return tb_incident_pushes(view) && !view->incident.low;
}

/* The modes that are pushed: the low modes, or all, which move then. */
static const TbParts *pushed(const TbView *view) {
  return view->incident.low ? &view->model->modes.low : &view->model->stretch.parts;
}

void tb_incident_push(TbView *view) {
  const TaborModel *model = view->model;
  const TbIncident *sound = &view->incident;
  if (is_silent(sound)) return;
  const TbMic *mic = &model->mics[sound->mic];
  const TbPair pressure = {sound->now, sound->before};
  model->kernels->push_by_sound(pushed(view), pressure, mic->push_now, mic->push_before,
                                model->modes.g, view->next.q);
}

double tb_incident_product(const TbView *view, const double *x) {
  const TbIncident *sound = &view->incident;
  if (is_silent(sound)) return 0.0;
  const TbMic *mic = &view->model->mics[sound->mic];
  const TbPair sums =
    view->model->kernels->two_dots_of_parts(pushed(view), mic->push_now, mic->push_before, x);
  return sound->now * sums.first + sound->before * sums.second;
}

double tb_incident_work(const TbView *view) {
  return 0.5 * (tb_incident_product(view, view->next.q) - tb_incident_product(view, view->last.q));
}
