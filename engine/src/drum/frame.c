/* SPDX-License-Identifier: MIT */
#include "drum/frame.h"

#include "step/step.h"

static const uint64_t HOUSEKEEPING = 64; /* samples */

void tb_frame(TbView *view, uint32_t heard, double *pressure) {
  TbState *state = view->state;
  for (uint32_t mic = 0; mic < view->model->def.mic_count; mic++) pressure[mic] = 0.0;
  state->statistics.frames++;
  if (state->asleep) {
    state->statistics.slept_frames++;
    state->hushed = 0;
    return;
  }
  tb_step(view, heard, pressure);
  for (uint32_t mic = 0; state->hushed && mic < view->model->def.mic_count; mic++) {
    pressure[mic] = 0.0;
  }
  if (state->clock % HOUSEKEEPING == 0) tb_step_housekeeping(view);
}
