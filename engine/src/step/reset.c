/* SPDX-License-Identifier: MIT */
#include "step/reset.h"

#include <string.h>

#include "air/high_band_step.h"
#include "step/live_params.h"

void tb_step_reset(TbState *state, const TaborModel *model) {
  memset(state, 0, tb_state_bytes(model));
  state->fingerprint = model->fingerprint;
  state->asleep = 1;
  memcpy(state->moving, model->resting.floor, sizeof state->moving);
  TbView view = tb_view(state, model);
  const TbWires *wires = &model->wires;
  for (uint32_t row = 0; row < tb_row_count(&model->rows); row++) {
    const bool real = row < wires->stride;
    const double eta = real ? model->rest.eta[row] : TB_NOTHING;
    view.now.eta[row] = view.last.eta[row] = view.next.eta[row] = eta;
    view.solve.warm.force[row] = real ? model->rest.force[row] : 0.0;
  }
  tb_high_band_step_of(&view)->begin(&view);
  tb_live_params_reset(&view);
}
