/* SPDX-License-Identifier: MIT */
/* The public functions of a drum: events, blocks, queries. All functions here but create and
 * destroy are audio-safe. */
#include "drum/drum.h"

#include <math.h>
#include <string.h>

#include "drum/drum_create.h"
#include "drum/event_budget.h"
#include "kernels/flush_denormals.h"
#include "math/checksum.h"
#include "step/brush.h"
#include "step/energy.h"
#include "step/live_params.h"
#include "step/reset.h"
#include "step/state_check.h"
#include "step/step.h"
#include "step/stick_rigid.h"
#include "step/strokes.h"

static const uint64_t HOUSEKEEPING = 64; /* samples */

static double clamp(double value, double minimum, double maximum) {
  return value < minimum ? minimum : (value > maximum ? maximum : value);
}

static double place_radius(const TaborDrum *drum, double radius) {
  return clamp(radius, 0.0, 0.999 * drum->model->head.radius);
}

static bool fields_finite(const TaborEvent *event) {
  return isfinite(event->velocity) && isfinite(event->radius) && isfinite(event->angle) &&
         isfinite(event->value);
}

/* ---- events --------------------------------------------------------------------------------- */

static bool strike(TaborDrum *drum, TbView *view, const TaborEvent *event) {
  if (event->striker >= drum->model->def.striker_count) return false;
  if (event->technique > TABOR_TECHNIQUE_SWEEP) return false;
  const TbStroke stroke = {.id = event->id,
                           .striker = event->striker,
                           .technique = event->technique,
                           .velocity = clamp(event->velocity, 0.01, 30.0),
                           .radius = place_radius(drum, event->radius),
                           .angle = clamp(event->angle, -1e6, 1e6),
                           .pressure = clamp(event->value, 0.0, 1.0)};
  return tb_strike(view, &stroke);
}

static bool press(TbView *view, const TaborEvent *event) {
  return tb_press(view, event->id, clamp(event->value, 0.0, 1.0));
}

static bool damp(TaborDrum *drum, TbView *view, const TaborEvent *event) {
  return tb_damp(view, event->id, clamp(event->value, 0.0, 100.0),
                 place_radius(drum, event->radius), clamp(event->angle, -1e6, 1e6));
}

static bool move(TaborDrum *drum, TbView *view, const TaborEvent *event) {
  return tb_brush_move(view, event->id, place_radius(drum, event->radius),
                       clamp(event->angle, -1e6, 1e6), clamp(event->value, 0.0, 60.0));
}

static void reset(TaborDrum *drum, TbView *view) {
  const uint32_t debt = drum->state->event_debt;
  tb_swap_finish(drum);
  tb_state_reset(drum->state, drum->model);
  drum->state->event_debt = debt;
  *view = tb_view(drum->state, drum->model);
}

/* True if the event was carried out. */
static bool act(TaborDrum *drum, TbView *view, const TaborEvent *event) {
  if (!fields_finite(event) || !tb_event_affordable(drum->state, event)) return false;
  switch (event->type) {
  case TABOR_EVENT_STRIKE: return strike(drum, view, event);
  case TABOR_EVENT_PRESS: return press(view, event);
  case TABOR_EVENT_DAMP: return damp(drum, view, event);
  case TABOR_EVENT_MOVE: return move(drum, view, event);
  case TABOR_EVENT_RELEASE: tb_release(view, event->id); return true;
  case TABOR_EVENT_PARAMETER:
    return tb_live_params_set(view, event->parameter, event->index, event->value);
  case TABOR_EVENT_SWAP:
    if (!event->swap || !tb_swap_act(drum, event->swap)) return false;
    *view = tb_view(drum->state, drum->model);
    return true;
  case TABOR_EVENT_RESET: reset(drum, view); return true;
  default: return false;
  }
}

static void act_and_count(TaborDrum *drum, TbView *view, const TaborEvent *event) {
  if (act(drum, view, event)) {
    tb_event_charge(drum->state, event);
    if (event->type == TABOR_EVENT_RESET) return; /* stays asleep at rest */
    drum->state->asleep = 0;
    drum->state->quiet_checks = 0;
  } else {
    drum->state->statistics.dropped_events++;
  }
}

/* ---- blocks --------------------------------------------------------------------------------- */

static void store(float *const *outputs, uint32_t mics, uint32_t frame, const double *pressure) {
  if (!outputs) return;
  for (uint32_t mic = 0; mic < mics; mic++) {
    if (outputs[mic]) outputs[mic][frame] = (float)pressure[mic];
  }
}

static uint32_t heard_mics(float *const *outputs, uint32_t mics) {
  uint32_t heard = 0;
  for (uint32_t mic = 0; outputs && mic < mics; mic++) {
    heard |= (outputs[mic] ? 1u : 0u) << mic;
  }
  return heard;
}

static void one_frame(TaborDrum *drum, TbView *view, uint32_t heard, double *pressure) {
  TbState *state = drum->state;
  const uint32_t mics = drum->model->def.mic_count;
  for (uint32_t mic = 0; mic < mics; mic++) pressure[mic] = 0.0;
  state->statistics.frames++;
  tb_event_pay_back(state);
  if (state->asleep) {
    state->statistics.slept_frames++;
  } else {
    tb_step(view, heard, pressure);
    if (state->clock % HOUSEKEEPING == 0) tb_step_housekeeping(view);
  }
  if (drum->fading) tb_swap_fade(drum, heard, pressure);
}

/* The end of the events that act at a frame, from `next` on; late ones act at the last frame. */
static uint32_t end_of_due(const TaborEvent *events, uint32_t count, uint32_t next, uint32_t frame,
                           bool last) {
  while (next < count && (last || events[next].frame <= frame)) next++;
  return next;
}

/* The last reset among the events from .. end, which leaves nothing of those before it but their
 * swaps; `from` if there is none. */
static uint32_t last_reset(const TaborEvent *events, uint32_t from, uint32_t end) {
  for (uint32_t i = end; i > from; i--) {
    if (events[i - 1].type == TABOR_EVENT_RESET && fields_finite(&events[i - 1])) return i - 1;
  }
  return from;
}

/* Carries out the events of a frame in their order. */
static uint32_t act_due(TaborDrum *drum, TbView *view, const TaborEvent *events, uint32_t count,
                        uint32_t next, uint32_t frame, bool last) {
  const uint32_t end = end_of_due(events, count, next, frame, last);
  const uint32_t first = last_reset(events, next, end);
  for (; next < end; next++) {
    const TaborEvent *event = &events[next];
    if (next < first && event->type != TABOR_EVENT_SWAP) continue;
    TaborStatistics *statistics = &drum->state->statistics;
    statistics->late_events += event->frame > frame;
    statistics->misordered_events += next > 0 && event->frame < events[next - 1].frame;
    act_and_count(drum, view, event);
  }
  return next;
}

void tabor_drum_process(TaborDrum *drum, const TaborEvent *events, uint32_t count,
                        float *const *outputs, uint32_t frames) {
  const TbFpMode mode = tb_fp_enter();
  TbView view = tb_view(drum->state, drum->model);
  double pressure[TABOR_MAX_MICS];
  uint32_t next = 0;
  if (frames == 0) act_due(drum, &view, events, count, 0, 0, true);
  for (uint32_t frame = 0; frame < frames; frame++) {
    next = act_due(drum, &view, events, count, next, frame, frame + 1 == frames);
    one_frame(drum, &view, heard_mics(outputs, drum->model->def.mic_count), pressure);
    store(outputs, drum->model->def.mic_count, frame, pressure);
  }
  tb_fp_leave(mode);
}

bool tabor_drum_is_silent(const TaborDrum *drum) { return drum->state->asleep && !drum->fading; }

void tabor_drum_reset(TaborDrum *drum) {
  TbView view;
  reset(drum, &view);
}

/* ---- queries -------------------------------------------------------------------------------- */

void tabor_drum_statistics(const TaborDrum *drum, TaborStatistics *statistics) {
  *statistics = drum->state->statistics;
  for (uint32_t i = 0; i < TB_MUFFLERS; i++) {
    const TbSlot *slot = &drum->state->slots[i];
    const bool counted = slot->partner && slot->partner <= i; /* with the stick's other end */
    statistics->in_play += slot->kind != TB_SLOT_FREE && !counted;
  }
  for (uint32_t i = 0; i < TB_BRUSHES; i++) statistics->in_play += drum->state->brushes[i].active;
}

void tabor_drum_ledger(const TaborDrum *drum, TaborLedger *ledger) {
  const TbView view = tb_view(drum->state, drum->model);
  *ledger = drum->state->sums;
  ledger->stored = tb_energy_stored(&view, &view.now, &view.last);
  ledger->high_band = tb_energy_high(&view);
  ledger->residual = ledger->injected + ledger->control - ledger->stored - ledger->head_loss -
                     ledger->wire_loss - ledger->contact_loss - ledger->damper_loss -
                     ledger->shell_loss - ledger->radiated - ledger->removed;
}

static double wires_force(const TbView *view) {
  double sum = 0.0;
  for (uint32_t row = 0; row < view->model->wires.stride; row++) sum += view->solve.warm.force[row];
  return sum;
}

/* Height of the first wire's midpoint. */
static double wire_height(const TbView *view) {
  const TbWires *wires = &view->model->wires;
  const uint32_t node = wires->wires[0].first_node + wires->wires[0].cells / 2;
  const double ends = view->model->rest.offset[0] - view->state->shift[0];
  return wires->side * (ends + view->model->rest.v[node] + view->now.v[node]);
}

void tabor_drum_probe(const TaborDrum *drum, TaborProbe *probe) {
  const TbView view = tb_view(drum->state, drum->model);
  const TaborModel *model = drum->model;
  *probe = (TaborProbe){.head = model->rest.head +
                                model->kernels->dot(model->modes.padded, model->center, view.now.q),
                        .wire = NAN,
                        .striker = NAN,
                        .striker_force = NAN,
                        .wire_force = NAN};
  if (model->wires.count > 0) {
    probe->wire = wire_height(&view);
    probe->wire_force = wires_force(&view);
  }
  uint64_t newest = 0;
  for (uint32_t i = 0; i < TB_SLOTS; i++) {
    const TbSlot *slot = &drum->state->slots[i];
    if (slot->kind != TB_SLOT_STRIKER) continue;
    const double force = view.solve.warm.force[model->wires.stride + i];
    probe->striker_force = isnan(probe->striker_force) ? force : probe->striker_force + force;
    const bool shaft = slot->partner && slot->on_hoop; /* of a stick whose tip is meant */
    if (slot->serial > newest && !shaft) {
      newest = slot->serial;
      probe->striker = slot->rest_height + view.now.z[i];
      if (slot->bends) probe->striker += tb_rigid_stick_bow(&view, i, &view.now);
    }
  }
}

const TaborModel *tabor_drum_model(const TaborDrum *drum) { return drum->model; }

/* ---- saved states --------------------------------------------------------------------------- */

size_t tabor_drum_state_size(const TaborDrum *drum) {
  return tb_state_bytes(drum->model) + sizeof(uint64_t);
}

void tabor_drum_state_save(const TaborDrum *drum, void *bytes) {
  const size_t size = tb_state_bytes(drum->model);
  const uint64_t sum = tb_checksum(drum->state, size);
  memcpy(bytes, drum->state, size);
  memcpy((char *)bytes + size, &sum, sizeof sum);
}

TaborStatus tabor_drum_state_load(TaborDrum *drum, const void *bytes, size_t size) {
  const size_t expected = tb_state_bytes(drum->model);
  uint64_t fingerprint, sum;
  if (!bytes || size != expected + sizeof sum) return TABOR_ERROR_STATE;
  memcpy(&fingerprint, bytes, sizeof fingerprint); /* the first member of TbState */
  memcpy(&sum, (const char *)bytes + expected, sizeof sum);
  if (fingerprint != drum->model->fingerprint) return TABOR_ERROR_STATE;
  if (sum != tb_checksum(bytes, expected)) return TABOR_ERROR_STATE;
  if (!tb_state_check(drum->model, bytes)) return TABOR_ERROR_STATE;
  tb_swap_finish(drum);
  memcpy(drum->state, bytes, expected);
  return TABOR_OK;
}
