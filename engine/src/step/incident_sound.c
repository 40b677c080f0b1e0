/* SPDX-License-Identifier: MIT */
#include "step/incident_sound.h"

static bool is_silent(const TbIncident *sound) { return sound->now == 0.0 && sound->before == 0.0; }

bool tb_incident_pushes(const TbView *view) { return !is_silent(&view->incident); }

void tb_incident_push(TbView *view) {
  const TbIncident *sound = &view->incident;
  const TbModes *modes = &view->model->modes;
  if (is_silent(sound)) return;
  const double *now = view->model->mics[sound->mic].push_now;
  const double *before = view->model->mics[sound->mic].push_before;
  double *q = view->next.q;
  for (uint32_t i = 0; i < modes->padded; i++) {
    q[i] += modes->g[i] * (now[i] * sound->now + before[i] * sound->before);
  }
}

double tb_incident_work(const TbView *view) {
  const TbIncident *sound = &view->incident;
  const TaborModel *model = view->model;
  if (is_silent(sound)) return 0.0;
  const TbMic *mic = &model->mics[sound->mic];
  const TbPair next =
    model->kernels->two_dots(model->modes.padded, mic->push_now, mic->push_before, view->next.q);
  const TbPair last =
    model->kernels->two_dots(model->modes.padded, mic->push_now, mic->push_before, view->last.q);
  return 0.5 *
         (sound->now * (next.first - last.first) + sound->before * (next.second - last.second));
}
