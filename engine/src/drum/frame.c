/* SPDX-License-Identifier: MIT */
#include "drum/frame.h"

#include <math.h>

#include "air/incident_sound.h"
#include "step/sleep.h"
#include "step/step.h"

static const uint64_t HOUSEKEEPING = 64; /* steps */

/* A step in which the sound from outside goes from one pressure to another. */
static void step_in_sound(TbView *view, double from, double to, uint32_t heard, double *pressure) {
  view->incident.before = from;
  view->incident.now = to;
  tb_step(view, heard, pressure);
}

/* One step, or two and what microphones hear of both. */
static void step_frame(TbView *view, double from, double to, uint32_t heard, double *pressure) {
  double first[TABOR_MAX_MICS];
  if (view->model->steps == 1) {
    step_in_sound(view, from, to, heard, pressure);
    return;
  }
  const double middle = 0.5 * (from + to);
  step_in_sound(view, from, middle, heard, first);
  const double tapped = view->mics.tapped;
  step_in_sound(view, middle, to, heard, pressure);
  view->mics.tapped = 0.5 * (tapped + view->mics.tapped);
  for (uint32_t mic = 0; mic < view->model->def.mic_count; mic++) {
    pressure[mic] = tb_halve_rate(view->state->mics.halved[mic], first[mic], pressure[mic]);
  }
}

/* Each microphone's frequency response. */
static void respond(TbView *view, double *pressure) {
  for (uint32_t mic = 0; mic < view->model->def.mic_count; mic++) {
    const TbMicResponse *response = &view->model->mics[mic].response;
    if (response->count == 0) continue;
    pressure[mic] = tb_mic_respond(response, view->state->mics.response[mic], pressure[mic]);
  }
}

/* A value that is no number counts as silence. */
static double limited(double pressure) {
  if (!(fabs(pressure) >= TB_INCIDENT_LEAST)) return 0.0;
  if (fabs(pressure) <= TB_INCIDENT_MOST) return pressure;
  return pressure < 0.0 ? -TB_INCIDENT_MOST : TB_INCIDENT_MOST;
}

/* Returns the pressure of the frame before. */
static double take_sound(TbView *view, const TbFrameAir *air) {
  TbState *state = view->state;
  const double before = state->incident;
  const double incident = air ? limited(air->incident) : 0.0;
  const bool wakes = incident != 0.0 && fabs(incident) >= air->wake;
  if (wakes) state->asleep = state->quiet_checks = 0;
  state->incident = state->asleep ? 0.0 : incident;
  view->incident.mic = air ? air->mic : 0;
  view->incident.low = air && air->low;
  view->mics.tap = air ? air->tap : TB_NO_TAP;
  view->mics.tapped = 0.0;
  return before;
}

void tb_frame(TbView *view, uint32_t heard, TbFrameAir *air, double *pressure) {
  TbState *state = view->state;
  const double before = take_sound(view, air);
  for (uint32_t mic = 0; mic < view->model->def.mic_count; mic++) pressure[mic] = 0.0;
  state->ledger.statistics.frames++;
  if (state->asleep) {
    state->ledger.statistics.slept_frames++;
    state->hushed = 0;
    if (air) air->tapped = 0.0;
    return;
  }
  step_frame(view, before, state->incident, heard, pressure);
  if (air) air->tapped = view->mics.tapped;
  respond(view, pressure);
  for (uint32_t mic = 0; state->hushed && mic < view->model->def.mic_count; mic++) {
    pressure[mic] = 0.0;
  }
  if (state->clock % HOUSEKEEPING < view->model->steps)
    tb_sleep_check(view, (uint32_t)HOUSEKEEPING);
}
