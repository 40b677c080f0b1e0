/* SPDX-License-Identifier: MIT */
#include "step/sleep.h"

#include <math.h>
#include <string.h>

#include "air/high_band_step.h"
#include "air/mic_output.h"
#include "heads/coupling.h"
#include "heads/hihat_air.h"
#include "heads/moving_modes.h"
#include "heads/pedal.h"
#include "heads/stretch.h"
#include "step/energy.h"
#include "step/plate_relax.h"
#include "step/reset.h"
#include "step/wire_clearance.h"
#include "strikers/striker_pool.h"
#include "strikers/strokes.h"
#include "wires/pluck.h"
#include "wires/wire_motion.h"

/* Far below anything audible: a medium stroke brings some 1e-2 J. */
static const double SILENT_ENERGY[] = {
  [TB_IN_DOUBLE] = 1e-18, /* [J] */
  /* Rounding keeps wires that lie on a head moving: 5e-17 J for the heaviest of the presets' wires.
   */
  [TB_IN_FLOAT] = 1e-15,
};
static const double UNHEARD[] = {
  [TB_IN_DOUBLE] = 0.0,  /* of full scale, squared */
  [TB_IN_FLOAT] = 1e-11, /* -110 dB */
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
  view->state->high.push = (TbWirePush){.known = 0};
  tb_high_band_step_of(view)->begin(view); /* so that a stroke sounds alike whenever it comes */
}

static double silent_energy(const TaborModel *model) { return SILENT_ENERGY[model->contacts]; }

/* True if a striker, a hand, wires of another tension or a pedal hold the drum away from its rest.
 */
static bool is_held(const TbView *view) {
  return tb_slots_play(view) || !tb_wires_have_own_tension(view) || !tb_pedal_rests(view);
}

static void return_to_rest(TbView *view) {
  const TaborModel *model = view->model;
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
    if (tb_slot_in_play(tb_slot(view, i))) view->now.eta[tb_slot_row(&model->rows, i)] = 0.0;
  }
  tb_solve_product(&view->solve, view->solve.warm.force, view->solve.warm.grid,
                   view->solve.warm.product);
  tb_stretch_clear(view);
  view->state->plate = (TbPlateState){.part = 0.0};
}

static void stop(TbView *view) {
  tb_hihat_air_rest(view);
  const TaborModel *model = view->model;
  const uint32_t rows = tb_row_count(&model->rows);
  memcpy(view->last.q, view->now.q, model->modes.padded * sizeof(double));
  memcpy(view->last.v, view->now.v, model->wires.node_count * sizeof(double));
  memcpy(view->last.eta, view->now.eta, rows * sizeof(double));
  memcpy(view->last.z, view->now.z, TB_SLOTS * sizeof(double));
  memcpy(view->last.truncated, view->now.truncated, sizeof view->state->strikers.truncated[0]);
  memcpy(view->last.bow, view->now.bow, sizeof view->state->strikers.bow[0]);
}

static void clear_mics(TbView *view) {
  TbMicState *mics = &view->state->mics;
  for (uint32_t mic = 0; mic < view->model->def.mic_count; mic++) {
    memset(view->mics.delay[mic], 0, (view->model->mics[mic].delay + 1u) * sizeof(double));
  }
  memset(mics->treble, 0, sizeof mics->treble);
  memset(mics->halved, 0, sizeof mics->halved);
  memset(mics->response, 0, sizeof mics->response);
  mics->heard = 0;
}

static void fall_asleep(TbView *view) {
  TaborLedger *sums = &view->state->ledger.sums;
  const double stored = tb_energy_stored(view, &view->now, &view->last);
  const double wires = tb_energy_wires(view, &view->now, &view->last);
  if (fabs(stored) < 10.0 * silent_energy(view->model) || !is_held(view)) return_to_rest(view);
  stop(view);
  const double wires_lost = wires - tb_energy_wires(view, &view->now, &view->last);
  const double lost = stored - tb_energy_stored(view, &view->now, &view->last);
  sums->wire_loss += wires_lost;
  sums->head_loss += lost - wires_lost;
  clear_mics(view);
  clear_high(view);
  view->state->asleep = 1;
}

static bool striker_in_flight(const TbView *view) {
  for (uint32_t i = 0; i < TB_SLOTS; i++) {
    const TbSlot *slot = tb_slot(view, i);
    if (tb_slot_is_palm(slot) || (tb_slot_strikes(slot) && !slot->hold.held)) return true;
  }
  return false;
}

static bool parameter_moves(const TbState *state) {
  for (uint32_t i = 0; i < TB_LIVE_COUNT; i++) {
    if (state->live.values[i].left) return true;
  }
  return false;
}

static double most_gain(const TbView *view) {
  const TbLiveParam *live = view->state->live.values;
  double most = 1.0;
  for (uint32_t mic = 0; mic < view->model->def.mic_count; mic++) {
    const double gain = live[TB_LIVE_GAIN + mic].now;
    if (gain > most) most = gain;
  }
  return most * view->model->def.full_scale / live[TB_LIVE_FULL_SCALE].now;
}

static bool is_unheard(const TbView *view) {
  const double *heard = view->model->resting.heard, gain = most_gain(view);
  double sum = tb_high_band_step_of(view)->heard(view);
  for (uint32_t i = 0; i < view->model->modes.padded; i++) {
    const double step = view->now.q[i] - view->last.q[i];
    sum += heard[i] * step * step;
  }
  return view->model->resting.sounds && sum * gain * gain < UNHEARD[view->model->precision];
}

/* True if wires touch what they touch at rest; those that are thrown off, nothing. Edges lie still
 * wherever the pedal holds them. */
static bool wires_touch_as_at_rest(const TbView *view) {
  const TbWires *wires = &view->model->wires;
  if (view->state->wires.lifted || !tb_pedal_rests(view)) return true;
  for (uint32_t row = 0; row < wires->stride; row++) {
    const bool on = view->state->wires.shift[wires->row_wire[row]] == 0.0;
    const bool rests = on && view->model->rest.force[row] > 0.0;
    if ((view->solve.warm.force[row] > 0.0) != rests) return false;
  }
  return true;
}

static bool dies_away_unheard(const TbView *view) {
  return view->model->def.quality.losses && wires_touch_as_at_rest(view) && is_unheard(view);
}

static void rest(TbView *view) {
  if (!tb_moving_rest(view)) return;
  tb_mic_hear_anew(view);
  tb_pool_yield_anew(view);
  tb_coupling_renew(view);
}

void tb_sleep_check(TbView *view, uint32_t steps) {
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
  tb_plate_relax(view, steps);
  rest(view);
  tb_wire_clearance_begin(view);
  tb_pluck_calm(view);
  tb_wire_motion_of(view)->settle(view);
  const bool still = motion < silent_energy(view->model) || dies_away_unheard(view);
  const bool quiet = still && !striker_in_flight(view) && !parameter_moves(state) &&
                     !tb_hands_move(state) && !tb_pluck_acts(state);
  state->quiet_checks = quiet ? state->quiet_checks + 1 : 0;
  if (state->quiet_checks >= SILENT_CHECKS) fall_asleep(view);
}
