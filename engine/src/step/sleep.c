/* SPDX-License-Identifier: MIT */
#include "step/sleep.h"

#include <math.h>
#include <string.h>

#include "air/high_band_step.h"
#include "air/mic_output.h"
#include "heads/coupling.h"
#include "heads/moving_modes.h"
#include "heads/stretch.h"
#include "step/energy.h"
#include "step/reset.h"
#include "step/wire_clearance.h"
#include "strikers/brush.h"
#include "strikers/striker_pool.h"
#include "wires/pluck.h"
#include "wires/wire_motion.h"

/* Far below anything audible: a medium stroke brings some 1e-2 J. */
static const double SILENT_ENERGY[] = {
  [TB_IN_DOUBLE] = 1e-18, /* [J] */
  /* Rounding keeps wires that lie on a head moving: 5e-17 J for the heaviest of the presets' wires. */
  [TB_IN_FLOAT] = 1e-15,
};
static const uint32_t SILENT_CHECKS = 16;
static const double VANISHED = 1e-150; /* [m kg^1/2]; denormals begin at 1e-308 */

/* Without branches: the compiler takes several at once. */
static void clear_small(uint32_t n, double *now, double *last) {
  for (uint32_t i = 0; i < n; i++) {
    const bool gone = (fabs(now[i]) < VANISHED) & (fabs(last[i]) < VANISHED);
    now[i] = gone ? 0.0 : now[i];
    last[i] = gone ? 0.0 : last[i];
  }
}

static void clear_vanished(TbView *view) {
  tb_high_band_step_of(view)->clear_small(view);
  clear_small(view->model->modes.padded, view->now.q, view->last.q);
  clear_small(TB_SLOTS * TB_TRUNCATED, view->now.truncated[0], view->last.truncated[0]);
  clear_small(TB_SLOTS * TB_BENDS, view->now.bow[0], view->last.bow[0]);
}

static void clear_high(TbView *view) {
  const size_t bytes = view->model->high.padded * sizeof(double);
  memset(view->now.high, 0, bytes);
  memset(view->last.high, 0, bytes);
  view->state->high.wires_hold = view->state->high.hold_steps = view->state->high.struck = 0;
  view->state->high.contacts = (TbWireContacts){0.0, 0.0, 0.0};
  tb_high_band_step_of(view)->begin(view); /* so that a stroke sounds alike whenever it comes */
}

static double silent_energy(const TaborModel *model) { return SILENT_ENERGY[model->contacts]; }

/* Stops all motion; a drum within rounding of its rest returns to it exactly. */
static void fall_asleep(TbView *view) {
  const TaborModel *model = view->model;
  const bool at_rest =
    fabs(tb_energy_stored(view, &view->now, &view->last)) < 10.0 * silent_energy(model);
  const uint32_t rows = model->wires.stride + TB_SLOTS;
  if (at_rest) {
    memset(view->now.q, 0, model->modes.padded * sizeof(double));
    memset(view->now.truncated, 0, sizeof view->state->strikers.truncated[0]);
    memset(view->state->strikers.bow, 0, sizeof view->state->strikers.bow);
    memset(view->now.v, 0, model->wires.node_count * sizeof(double));
    for (uint32_t row = 0; row < model->wires.stride; row++) {
      view->now.eta[row] =
        model->rest.eta[row] + view->state->wires.shift[model->wires.row_wire[row]];
      view->solve.warm.force[row] = model->rest.force[row];
    }
    for (uint32_t i = 0; i < TB_SLOTS; i++) {
      if (tb_slot(view, i)->kind != TB_SLOT_FREE) view->now.eta[model->wires.stride + i] = 0.0;
    }
    tb_solve_product(&view->solve, view->solve.warm.force, view->solve.warm.grid,
                     view->solve.warm.product);
    tb_stretch_clear(view);
  }
  memcpy(view->last.q, view->now.q, model->modes.padded * sizeof(double));
  memcpy(view->last.v, view->now.v, model->wires.node_count * sizeof(double));
  memcpy(view->last.eta, view->now.eta, rows * sizeof(double));
  memcpy(view->last.z, view->now.z, TB_SLOTS * sizeof(double));
  memcpy(view->last.truncated, view->now.truncated, sizeof view->state->strikers.truncated[0]);
  memcpy(view->last.bow, view->now.bow, sizeof view->state->strikers.bow[0]);
  for (uint32_t mic = 0; mic < model->def.mic_count; mic++) {
    memset(view->mics.delay[mic], 0, (model->mics[mic].delay + 1u) * sizeof(double));
  }
  memset(view->state->mics.treble, 0, sizeof view->state->mics.treble);
  memset(view->state->mics.halved, 0, sizeof view->state->mics.halved);
  memset(view->state->mics.response, 0, sizeof view->state->mics.response);
  clear_high(view);
  view->state->mics.heard = 0;
  view->state->asleep = 1;
}

static bool striker_in_flight(const TbView *view) {
  for (uint32_t i = 0; i < TB_SLOTS; i++) {
    const TbSlot *slot = tb_slot(view, i);
    if (slot->kind == TB_SLOT_PALM || (tb_slot_strikes(slot) && !slot->hold.held)) return true;
  }
  return false;
}

static bool parameter_moves(const TbState *state) {
  for (uint32_t i = 0; i < TB_LIVE_COUNT; i++) {
    if (state->live.values[i].left) return true;
  }
  return false;
}

static void rest(TbView *view) {
  if (!tb_moving_rest(view)) return;
  tb_mic_hear_anew(view);
  tb_pool_yield_anew(view);
  tb_coupling_renew(view);
}

void tb_sleep_check(TbView *view) {
  TbState *state = view->state;
  const double motion = tb_energy_motion(view, &view->now, &view->last);
  if (!isfinite(motion)) {
    const TaborStatistics statistics = state->ledger.statistics;
    const TbLiveParam output = state->live.output;
    tb_step_reset(state, view->model);
    state->ledger.statistics = statistics;
    state->live.output = output;
    state->ledger.statistics.recovered++;
    *view = tb_view(state, view->model);
    return;
  }
  clear_vanished(view);
  rest(view);
  tb_wire_clearance_begin(view);
  tb_pluck_calm(view);
  tb_wire_motion_of(view)->settle(view);
  const bool quiet = motion < silent_energy(view->model) && !striker_in_flight(view) &&
                     !parameter_moves(state) && !tb_brush_moves(state) && !tb_pluck_acts(state);
  state->quiet_checks = quiet ? state->quiet_checks + 1 : 0;
  if (state->quiet_checks >= SILENT_CHECKS) fall_asleep(view);
}
