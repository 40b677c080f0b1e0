/* SPDX-License-Identifier: MIT */
#include "air/incident_sound.h"

static bool is_silent(const TbIncident *sound) { return sound->now == 0.0 && sound->before == 0.0; }

bool tb_incident_pushes(const TbView *view) { return !is_silent(&view->incident); }

bool tb_incident_pushes_all(const TbView *view) {
  return tb_incident_pushes(view) && !view->incident.low;
}

/* ---- all modes ------------------------------------------------------------------------------- */

static void push_all(const TbMic *mic, const TbModes *modes, const TbIncident *sound, double *q) {
  const double *now = mic->push_now, *before = mic->push_before;
  for (uint32_t i = 0; i < modes->padded; i++) {
    q[i] += modes->g[i] * (now[i] * sound->now + before[i] * sound->before);
  }
}

static double work_of_all(const TbView *view, const TbMic *mic, const TbIncident *sound) {
  const TaborModel *model = view->model;
  const TbPair next =
    model->kernels->two_dots(model->modes.padded, mic->push_now, mic->push_before, view->next.q);
  const TbPair last =
    model->kernels->two_dots(model->modes.padded, mic->push_now, mic->push_before, view->last.q);
  return sound->now * (next.first - last.first) + sound->before * (next.second - last.second);
}

/* ---- low modes ------------------------------------------------------------------------------- */

static void push_low(const TbLowModes *low, const TbIncident *sound, double *q) {
  for (uint32_t i = 0; i < low->count; i++) {
    q[low->mode[i]] += low->g_now[i] * sound->now + low->g_before[i] * sound->before;
  }
}

static double work_of_low(const TbView *view, const TbLowModes *low, const TbIncident *sound) {
  double sum = 0.0;
  for (uint32_t i = 0; i < low->count; i++) {
    const uint32_t mode = low->mode[i];
    const double force = low->now[i] * sound->now + low->before[i] * sound->before;
    sum += force * (view->next.q[mode] - view->last.q[mode]);
  }
  return sum;
}

/* ---- either ---------------------------------------------------------------------------------- */

void tb_incident_push(TbView *view) {
  const TbIncident *sound = &view->incident;
  if (is_silent(sound)) return;
  const TbMic *mic = &view->model->mics[sound->mic];
  if (sound->low) {
    push_low(&mic->low, sound, view->next.q);
  } else {
    push_all(mic, &view->model->modes, sound, view->next.q);
  }
}

double tb_incident_work(const TbView *view) {
  const TbIncident *sound = &view->incident;
  if (is_silent(sound)) return 0.0;
  const TbMic *mic = &view->model->mics[sound->mic];
  return 0.5 * (sound->low ? work_of_low(view, &mic->low, sound) : work_of_all(view, mic, sound));
}
