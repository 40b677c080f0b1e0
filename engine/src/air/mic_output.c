/* SPDX-License-Identifier: MIT */
#include "air/mic_output.h"

#include <math.h>
#include <string.h>

#include "air/force_equalizer.h"
#include "air/high_band_step.h"
#include "kernels/profile.h"

/* True unless the wires are thrown off. */
static bool wires_lie(const TbView *view) {
  return view->model->wires.count > 0 && view->state->live.values[TB_LIVE_STRAINER].now > 0.0;
}

/* ---- the high band -------------------------------------------------------------------------- */

/* Samples after which what wires take from modes is renewed: modes decay in hundreds. */
enum { HOLD_STEPS = 16 };

/* The modes that wires push, those that they hold, and the others. */
static TbRingParts divide(const TbView *view) {
  const TbHighBand *high = &view->model->high;
  const TbWires *wires = &view->model->wires;
  TbRingParts parts = {.count = 0};
  if (wires->count > 0 && !view->state->wires.lifted) {
    const uint32_t from = high->begin[wires->head], end = high->begin[wires->head + 1];
    const bool held = view->state->high.wires_hold;
    if (from > 0) parts.part[parts.count++].end = from;
    parts.part[parts.count++] = (TbRingPart){from + high->driven, true, held};
    parts.part[parts.count++] = (TbRingPart){end, false, held};
  }
  parts.part[parts.count++].end = high->padded;
  return parts;
}

/* Push of a striker's force on the high band: see force_equalizer.h. */
static double high_push(TbView *view, TbSlot *slot, double force) {
  const double before = slot->striker.force_before;
  slot->striker.force_before = force;
  return wires_lie(view) ? 0.5 * (force + before) : force;
}

/* [N]; less is what a solve leaves over: on one machine nothing, on another, which does not flush
 * denormals, not quite. */
static const double LEAST_PUSH = 1e-9;

/* Strikers push the batter head's modes; true if any does. */
static bool strike_high(TbView *view) {
  bool struck = false;
  view->state->high.struck = 0;
  for (uint32_t i = 0; view->state->strikers.mask >> i; i++) {
    TbSlot *slot = tb_slot(view, i);
    if (!tb_slot_strikes(slot) || slot->on_hoop) continue;
    const double push =
      high_push(view, slot, view->solve.warm.force[tb_slot_row(&view->model->rows, i)]);
    if (push == 0.0) continue;
    tb_high_band_step_of(view)->strike(view, i, push);
    struck = true;
    if (!tb_slot_is_bristles(slot) && fabs(push) > LEAST_PUSH) view->state->high.struck = 1;
  }
  return struck;
}

/* Every HOLD_STEPS samples, counted from a first contact: from the wires' contacts since the last
 * time. */
static void renew_hold(TbView *view) {
  TbState *state = view->state;
  const TbWireContacts sums = state->high.contacts;
  if (sums.force == 0.0 && !state->high.wires_hold) return;
  if (++state->high.hold_steps < HOLD_STEPS) return;
  state->high.hold_steps = 0;
  state->high.contacts = (TbWireContacts){0.0, 0.0, 0.0};
  state->high.wires_hold = sums.force > 0.0 && sums.square > 0.0 && sums.motion >= 0.0;
  if (!state->high.wires_hold) return;
  const double mean = sums.force / HOLD_STEPS; /* and speeds are s/(2k) */
  const TbWireTouch touch = {mean, mean * sums.force / sums.square,
                             0.5 * view->model->step_rate * sqrt(sums.motion / sums.force)};
  double resistance[TB_HOLD_BANDS];
  tb_wire_hold_resistance(&view->model->high.wire_hold, touch, resistance);
  tb_high_band_step_of(view)->hold(view, resistance);
}

/* Push of the wires on the high band, into view->high.force. */
static void push_high(TbView *view, bool unchanged) {
  TbHighBandState *high = &view->state->high;
  if (view->model->wires.count == 0 || view->state->wires.lifted) return;
  if (unchanged) {
    tb_high_band_push_nothing(view->model, &high->push);
    return;
  }
  const TbWireContacts contacts =
    tb_high_band_push(view->model, view->solve.warm.force, view->s, &high->push,
                      view->solve.work.turned, view->high.force, view->high.steady);
  high->contacts.force += contacts.force;
  high->contacts.square += contacts.square;
  high->contacts.motion += contacts.motion;
}

/* One step; returns what microphone `mic` hears of its end. */
static TbPair step_high(TbView *view, uint32_t mic, bool unchanged) {
  if (view->model->high.count == 0) return (TbPair){0.0, 0.0};
  push_high(view, unchanged);
  renew_hold(view);
  if (!view->state->high.struck) tb_high_band_step_of(view)->scatter(view);
  const TbPair heard = tb_high_band_step_of(view)->move(view, mic, divide(view));
  return strike_high(view) ? tb_high_band_step_of(view)->sums(view, mic, &view->next) : heard;
}

/* ---- microphones ---------------------------------------------------------------------------- */

/* A line of delay + 1 samples: what goes in now comes out `delay` samples later. */
static double delayed(TbView *view, uint32_t mic, double value) {
  uint32_t *at = &view->state->mics.delay_at[mic];
  const uint32_t length = view->model->mics[mic].delay + 1u;
  view->mics.delay[mic][*at] = value;
  *at = *at + 1u == length ? 0u : *at + 1u;
  return view->mics.delay[mic][*at];
}

/* A and B of TbMic at one instant, of which the high band's part is known. */
static TbPair sums_at(const TbView *view, uint32_t mic, const TbPhase *phase, TbPair high) {
  const TbMic *m = &view->model->mics[mic];
  const TbPair sums =
    view->model->kernels->two_dots_of_parts(&view->moving, m->ahead, m->behind, phase->q);
  return (TbPair){sums.first + high.first, sums.second + high.second};
}

/* The tap's signal: other drums hear the low modes alone. */
static TbPair low_sums_at(const TbView *view, uint32_t mic, const TbPhase *phase) {
  const TbMic *m = &view->model->mics[mic];
  return view->model->kernels->two_dots_of_parts(&view->model->modes.low, m->ahead, m->behind,
                                                 phase->q);
}

/* The same at the end of the step, where end_modes() of step.c knows one microphone's. */
static TbPair sums_at_end(const TbView *view, uint32_t mic, TbPair high) {
  if (mic != view->mics.ear) return sums_at(view, mic, &view->next, high);
  return (TbPair){view->end.heard.first + high.first, view->end.heard.second + high.second};
}

/* `high` is the high band's part, if it is known. */
static TbPair heard_at_end(TbView *view, uint32_t mic, const TbPair *high) {
  if (mic == view->mics.tap) return low_sums_at(view, mic, &view->next);
  if (high) return sums_at_end(view, mic, *high);
  return sums_at_end(view, mic, tb_high_band_step_of(view)->sums(view, mic, &view->next));
}

static TbPair all_sums_at(TbView *view, uint32_t mic, const TbPhase *phase) {
  if (mic == view->mics.tap) return low_sums_at(view, mic, phase);
  return sums_at(view, mic, phase, tb_high_band_step_of(view)->sums(view, mic, phase));
}

/* Fills in the sums of a microphone that was not listened to before. */
static void begin_hearing(TbView *view, uint32_t mic) {
  const TbPair now = all_sums_at(view, mic, &view->now);
  const TbPair last = all_sums_at(view, mic, &view->last);
  view->state->mics.ears[mic] = (TbEar){now.first, now.second, last.second};
}

void tb_mic_hear_anew(TbView *view) {
  for (uint32_t mic = 0; mic < view->model->def.mic_count; mic++) {
    if (view->state->mics.heard >> mic & 1u) begin_hearing(view, mic);
  }
}

/* Pressure [Pa] from the sums of the newest instant. */
static double hear(TbEar *ear, TbPair sums) {
  const double pressure = (sums.first - ear->ahead) - (ear->behind - ear->behind_before);
  *ear = (TbEar){sums.first, sums.second, ear->behind};
  return pressure;
}

/* A plate's large deflections act in every n-th step, n times as strongly. The pressure that such a
 * kick alone adds is heard in n steps, or its images would stand beside every partial. */
static double spread_kick(TbView *view, uint32_t mic, double pressure) {
  const TaborModel *model = view->model;
  double *kick = &view->state->mics.kick[mic];
  if (model->plate.every < 2 || mic == view->mics.tap) return pressure;
  if (view->state->plate.part == 0.0) *kick = 0.0;
  if (view->stretch.count == 0) return pressure + *kick;
  const double *const pull[TB_COUPLINGS] = {view->stretch.pull[0], view->stretch.pull[0]};
  const TbPair along =
    model->kernels->stretch_dots(&model->stretch.parts, pull, model->mics[mic].ahead);
  const double whole = view->end.stretch[0] * along.first;
  *kick = whole / model->plate.every;
  return pressure - whole + *kick;
}

static double equalized(TbView *view, uint32_t mic, double pressure) {
  double *memory = view->state->mics.treble[mic];
  return wires_lie(view) ? tb_force_equalizer(memory, pressure)
                         : tb_force_equalizer_rest(memory, pressure);
}

uint32_t tb_first_heard(uint32_t heard) {
  uint32_t mic = 0;
  while (heard != 0 && !(heard >> mic & 1u)) mic++;
  return mic;
}

/* A microphone that nobody hears hears nothing: it begins from silence when it is heard again. */
void tb_mic_output(TbView *view, uint32_t heard, bool unchanged, double *pressure) {
  TbState *state = view->state;
  const TbLiveParam *live = state->live.values;
  const uint32_t first = tb_first_heard(heard);
  TB_STAGE(MICS);
  for (uint32_t mic = 0; mic < view->model->def.mic_count; mic++) {
    if (!((heard & ~state->mics.heard) >> mic & 1u)) continue;
    begin_hearing(view, mic);
    state->mics.kick[mic] = 0.0;
  }
  state->mics.heard = heard;
  TB_STAGE(HIGH);
  const TbPair high = step_high(view, first, unchanged);
  TB_STAGE(MICS);
  for (uint32_t mic = 0; mic < view->model->def.mic_count; mic++) {
    double p = 0.0;
    if (heard >> mic & 1u) {
      p = hear(&state->mics.ears[mic], heard_at_end(view, mic, mic == first ? &high : NULL));
      p = spread_kick(view, mic, p);
      if (mic == view->mics.tap) view->mics.tapped = p;
    }
    pressure[mic] = delayed(view, mic, equalized(view, mic, p)) * live[TB_LIVE_GAIN + mic].now /
                    live[TB_LIVE_FULL_SCALE].now;
  }
}
