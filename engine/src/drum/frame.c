/* SPDX-License-Identifier: MIT */
#include "drum/frame.h"

#include "step/step.h"

static const uint64_t HOUSEKEEPING = 64; /* steps */

/* One step, or two and what microphones hear of both. */
static void step_frame(TbView *view, uint32_t heard, double *pressure) {
  double first[TABOR_MAX_MICS];
  if (view->model->steps == 1) {
    tb_step(view, heard, pressure);
    return;
  }
  tb_step(view, heard, first);
  tb_step(view, heard, pressure);
  for (uint32_t mic = 0; mic < view->model->def.mic_count; mic++) {
    pressure[mic] = tb_halve_rate(view->state->halved[mic], first[mic], pressure[mic]);
  }
}

/* Each microphone's frequency response. */
static void respond(TbView *view, double *pressure) {
  for (uint32_t mic = 0; mic < view->model->def.mic_count; mic++) {
    const TbMicResponse *response = &view->model->mics[mic].response;
    if (response->count == 0) continue;
    pressure[mic] = tb_mic_respond(response, view->state->response[mic], pressure[mic]);
  }
}

void tb_frame(TbView *view, uint32_t heard, double *pressure) {
  TbState *state = view->state;
  for (uint32_t mic = 0; mic < view->model->def.mic_count; mic++) pressure[mic] = 0.0;
  state->statistics.frames++;
  if (state->asleep) {
    state->statistics.slept_frames++;
    state->hushed = 0;
    return;
  }
  step_frame(view, heard, pressure);
  respond(view, pressure);
  for (uint32_t mic = 0; state->hushed && mic < view->model->def.mic_count; mic++) {
    pressure[mic] = 0.0;
  }
  if (state->clock % HOUSEKEEPING < view->model->steps) tb_step_housekeeping(view);
}
