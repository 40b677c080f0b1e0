/* SPDX-License-Identifier: MIT */
/* The public functions of a drum: events, blocks, queries. All functions here but create and
 * destroy are audio-safe. */
#include "drum/drum.h"

#include <math.h>
#include <string.h>

#include "drum/frame.h"
#include "heads/pedal.h"
#include "kernels/flush_denormals.h"
#include "math/checksum.h"
#include "state/event_budget.h"
#include "step/energy.h"
#include "step/live_params.h"
#include "step/reset.h"
#include "step/state_check.h"
#include "step/wire_clearance.h"
#include "strikers/stick.h"
#include "strikers/strokes.h"
#include "wires/pluck.h"

static double clamp(double value, double minimum, double maximum) {
  return value < minimum ? minimum : (value > maximum ? maximum : value);
}

static double place_radius(const TbView *view, double radius) {
  return clamp(radius, 0.0, 0.999 * view->model->body.radius);
}

/* The same direction within one turn, whose sine and cosine keep all digits; exact. */
static double place_angle(double angle) {
  const double within = clamp(angle, -1e6, 1e6);
  if (fabs(within) <= 360.0) return within;
  return within - 360.0 * (double)(int32_t)(within / 360.0);
}

static bool fields_finite(const TaborEvent *event) {
  return isfinite(event->velocity) && isfinite(event->radius) && isfinite(event->angle) &&
         isfinite(event->value);
}

/* ---- events --------------------------------------------------------------------------------- */

static bool pluck(TbView *view, const TaborEvent *event) {
  const double displacement = clamp(event->value, 0.0, 0.05);
  const double time = clamp(displacement / clamp(event->velocity, 1e-6, 1e6), 1e-4, 10.0);
  if (!tb_pluck(view, event->striker, clamp(event->radius, 0.0, 1.0), displacement, time)) {
    return false;
  }
  tb_wire_clearance_end(view);
  view->state->ledger.statistics.strikes++;
  return true;
}

static bool stamp(TbView *view, const TaborEvent *event) {
  if (!tb_pedal_stamp(view, clamp(event->velocity, 0.01, 30.0))) return false;
  view->state->ledger.statistics.strikes++;
  return true;
}

static bool strike(TbView *view, const TaborEvent *event) {
  if (event->technique == TABOR_TECHNIQUE_PLUCK) return pluck(view, event);
  if (event->technique == TABOR_TECHNIQUE_PEDAL) return stamp(view, event);
  if (event->striker >= view->model->def.striker_count) return false;
  if (event->technique > TABOR_TECHNIQUE_SWEEP) return false;
  const TbStroke stroke = {.id = event->id,
                           .striker = event->striker,
                           .technique = event->technique,
                           .velocity = clamp(event->velocity, 0.01, 30.0),
                           .radius = place_radius(view, event->radius),
                           .angle = place_angle(event->angle),
                           .pressure = clamp(event->value, 0.0, 1.0)};
  return tb_strike(view, &stroke);
}

static bool press(TbView *view, const TaborEvent *event) {
  return tb_press(view, event->id, clamp(event->value, 0.0, 1.0));
}

static bool damp(TbView *view, const TaborEvent *event) {
  return tb_damp(view, event->id, clamp(event->value, 0.0, 100.0),
                 place_radius(view, event->radius), place_angle(event->angle));
}

static bool move(TbView *view, const TaborEvent *event) {
  return tb_move(view, event->id, place_radius(view, event->radius), place_angle(event->angle),
                 clamp(event->value, 0.0, 60.0));
}

/* True if the event was carried out. A drum that sleeps wakes up; one that is played is heard. */
static bool act_on(TbView *view, const TaborEvent *event) {
  bool acts = false, plays = event->type != TABOR_EVENT_PARAMETER;
  switch (event->type) {
  case TABOR_EVENT_STRIKE: acts = strike(view, event); break;
  case TABOR_EVENT_PRESS: acts = press(view, event); break;
  case TABOR_EVENT_DAMP: acts = damp(view, event); break;
  case TABOR_EVENT_MOVE: acts = move(view, event); break;
  case TABOR_EVENT_RELEASE:
    tb_release(view, event->id);
    acts = true;
    plays = false;
    break;
  case TABOR_EVENT_PARAMETER:
    acts = tb_live_params_set(view, event->parameter, event->index, event->value);
    break;
  default: break;
  }
  if (acts) view->state->asleep = view->state->quiet_checks = 0;
  if (acts && plays) view->state->hushed = 0;
  return acts;
}

/* Drums that play what the drum plays: itself, and former models until the new one's sound has
 * come. */
static uint32_t players(const TaborDrum *drum) {
  uint32_t count = 1;
  for (const TbTail *tail = drum->tails; tail && tail->crosses; tail = tail->before) count++;
  return count;
}

/* A former model plays on until the new one's sound has come, and must play the same. */
static bool play_event(TaborDrum *drum, TbView *view, const TaborEvent *event) {
  const uint32_t price = players(drum) * tb_event_price(event);
  if (drum->at_rest && event->type == TABOR_EVENT_RELEASE) return true; /* nothing is there */
  if (!tb_event_affordable(drum->state->event_debt, price)) return false;
  for (TbTail *tail = drum->tails; tail && tail->crosses; tail = tail->before) {
    TbView former = tb_view(tail->state, tail->model);
    (void)act_on(&former, event);
  }
  if (!act_on(view, event)) return false;
  drum->at_rest = false;
  tb_event_charge(&drum->state->event_debt, price);
  return true;
}

static bool set_gain(TaborDrum *drum, TbView *view, const TaborEvent *event) {
  const uint32_t price = tb_event_price(event);
  if (!tb_event_affordable(drum->state->event_debt, price)) return false;
  tb_live_params_gain(view, event->value, tabor_drum_is_silent(drum));
  tb_event_charge(&drum->state->event_debt, price);
  return true;
}

/* A drum that cannot afford to ring on is replaced. */
static bool swap(TaborDrum *drum, const TaborEvent *event) {
  const uint32_t price = tb_event_price(event);
  const bool anew =
    event->type == TABOR_EVENT_REPLACE || !tb_event_affordable(drum->state->event_debt, price);
  if (!event->swap || !tb_swap_act(drum, event->swap, anew)) return false;
  if (!drum->at_rest) drum->state->asleep = drum->state->quiet_checks = 0;
  tb_event_charge(&drum->state->event_debt, drum->at_rest ? TB_DEBT_STROKE : price);
  return true;
}

static void silence(TaborDrum *drum, const TaborEvent *event) {
  if (tb_silence(drum)) tb_event_charge(&drum->state->event_debt, tb_event_price(event));
}

static TbAirEnergy booked(const TbState *state) {
  const TbLedgerState *const ledger = &state->ledger;
  return (TbAirEnergy){.radiated = ledger->sums.radiated - ledger->radiated_beyond,
                       .work = ledger->sound_work};
}

TbAirEnergy tb_drum_air_energy(const TaborDrum *drum) {
  TbAirEnergy energy = booked(drum->state);
  energy.radiated += drum->forgotten.radiated;
  energy.work += drum->forgotten.work;
  return energy;
}

/* A drum at rest has only its counters and its gain to set back. */
static void forget(TbState *state) {
  state->ledger = (TbLedgerState){.sound_work = 0.0};
  state->live.output = (TbLiveParam){.now = 1.0, .target = 1.0};
}

static void reset(TaborDrum *drum) {
  const uint32_t debt = drum->state->event_debt;
  drum->forgotten = tb_drum_air_energy(drum);
  tb_tails_end(&drum->tails);
  if (drum->at_rest) {
    forget(drum->state);
    return;
  }
  tb_step_reset(drum->state, drum->model);
  drum->at_rest = true;
  drum->state->event_debt = debt;
  tb_event_charge(&drum->state->event_debt, TB_DEBT_REST);
}

static bool act(TaborDrum *drum, TbView *view, const TaborEvent *event) {
  bool acts = true;
  if (!fields_finite(event)) return false;
  switch (event->type) {
  case TABOR_EVENT_GAIN: return set_gain(drum, view, event);
  case TABOR_EVENT_SWAP:
  case TABOR_EVENT_REPLACE: acts = swap(drum, event); break;
  case TABOR_EVENT_SILENCE: silence(drum, event); break;
  case TABOR_EVENT_RESET: reset(drum); break;
  default: return play_event(drum, view, event);
  }
  *view = tb_view(drum->state, drum->model);
  return acts;
}

/* ---- blocks --------------------------------------------------------------------------------- */

static void store(const TaborDrum *drum, float *const *outputs, uint32_t frame,
                  const double *sound) {
  if (!outputs) return;
  for (uint32_t i = 0; i < drum->route.count; i++) {
    if (outputs[i]) outputs[i][frame] = (float)sound[i];
  }
}

static uint32_t heard_outputs(const TaborDrum *drum, float *const *outputs) {
  uint32_t heard = 0;
  for (uint32_t i = 0; outputs && i < drum->route.count; i++) {
    heard |= (outputs[i] ? 1u : 0u) << i;
  }
  return heard;
}

static uint32_t heard_mics(const TbRoute *route, uint32_t heard) {
  uint32_t mics = 0;
  for (uint32_t i = 0; i < route->count; i++) {
    if (route->mics[i] != TB_NO_MIC) mics |= (heard >> i & 1u) << route->mics[i];
  }
  return mics;
}

static void one_frame(TaborDrum *drum, TbView *view, uint32_t heard, TbFrameAir *air,
                      double *sound) {
  double pressure[TABOR_MAX_MICS];
  const TbRoute *route = &drum->route;
  const uint32_t tap = air && air->tap != TB_NO_TAP ? 1u << air->tap : 0u;
  tb_event_pay_back(&drum->state->event_debt);
  tb_frame(view, heard_mics(route, heard) | tap, air, pressure);
  if (!drum->state->asleep) drum->at_rest = false;
  for (uint32_t i = 0; i < route->count; i++) {
    sound[i] = route->mics[i] == TB_NO_MIC ? 0.0 : pressure[route->mics[i]];
  }
  if (drum->tails) tb_tails_play(drum, heard, sound);
  const double gain = tb_live_params_gain_step(drum->state);
  for (uint32_t i = 0; i < route->count; i++) sound[i] *= gain;
}

static const TaborEvent *listed(const TbEventList *list, uint32_t index) {
  return (const TaborEvent *)(const void *)((const char *)list->first + index * list->stride);
}

static const TaborEvent *addressed(const TbEventList *list, uint32_t index) {
  return list->address ? list->address(list->context, index) : listed(list, index);
}

/* The end of the events that act at a frame of the block; late ones act at its last frame. */
static uint32_t end_of_due(const TbEventList *list, uint32_t frame, bool last) {
  uint32_t end = list->next;
  while (end < list->count && (last || listed(list, end)->frame <= frame)) end++;
  return end;
}

/* The last reset among the events up to `end`, which leaves nothing of those before it but their
 * swaps; the next event if there is none. */
static uint32_t last_reset(const TbEventList *list, uint32_t end) {
  for (uint32_t i = end; i > list->next; i--) {
    const TaborEvent *const event = addressed(list, i - 1);
    if (event && event->type == TABOR_EVENT_RESET && fields_finite(event)) return i - 1;
  }
  return list->next;
}

/* Carries out the events of a frame of the block in their order. */
static void act_due(TaborDrum *drum, TbView *view, TbEventList *list, uint32_t frame, bool last) {
  const uint32_t end = end_of_due(list, frame, last);
  const uint32_t first = last_reset(list, end);
  for (; list->next < end; list->next++) {
    const uint32_t i = list->next;
    const TaborEvent *const event = addressed(list, i);
    if (!event) continue;
    const bool swaps = event->type == TABOR_EVENT_SWAP || event->type == TABOR_EVENT_REPLACE;
    if (i < first && !swaps) continue;
    TaborStatistics *statistics = &drum->state->ledger.statistics;
    statistics->late_events += listed(list, i)->frame > frame;
    statistics->misordered_events += i > 0 && listed(list, i)->frame < listed(list, i - 1)->frame;
    if (!act(drum, view, event)) drum->state->ledger.statistics.dropped_events++;
  }
}

static TbFrameAir air_of_frame(const TbDrumAir *air, uint32_t frame) {
  return (TbFrameAir){.mic = air->mic,
                      .low = air->low,
                      .incident = air->incident ? (double)air->incident[frame] : 0.0,
                      .wake = air->wake,
                      .tap = air->tapped ? air->tap : TB_NO_TAP};
}

void tb_drum_process(TaborDrum *drum, TbEventList events, const TbDrumAir *air,
                     float *const *outputs, uint32_t frames) {
  const TbFpMode mode = tb_fp_enter();
  TbView view = tb_view(drum->state, drum->model);
  double sound[TABOR_MAX_MICS];
  if (frames == 0) act_due(drum, &view, &events, events.start, events.last);
  for (uint32_t frame = 0; frame < frames; frame++) {
    act_due(drum, &view, &events, events.start + frame, events.last && frame + 1 == frames);
    TbFrameAir around = air ? air_of_frame(air, frame) : (TbFrameAir){.tap = TB_NO_TAP};
    one_frame(drum, &view, heard_outputs(drum, outputs), &around, sound);
    store(drum, outputs, frame, sound);
    if (air && air->tapped) air->tapped[frame] = (float)around.tapped;
  }
  tb_fp_leave(mode);
}

static TbEventList own_events(const TaborEvent *events, uint32_t count) {
  return (TbEventList){.first = events, .stride = sizeof *events, .count = count, .last = true};
}

void tabor_drum_process(TaborDrum *drum, const TaborEvent *events, uint32_t count,
                        float *const *outputs, uint32_t frames) {
  tb_drum_process(drum, own_events(events, count), NULL, outputs, frames);
}

void tabor_drum_process_sound(TaborDrum *drum, const TaborEvent *events, uint32_t count,
                              const TaborSound *sound, float *const *outputs, uint32_t frames) {
  TbDrumAir air = {.tap = TB_NO_TAP};
  if (sound && sound->mic < drum->model->def.mic_count) {
    air.mic = sound->mic;
    air.incident = sound->pressure;
  }
  tb_drum_process(drum, own_events(events, count), &air, outputs, frames);
}

bool tabor_drum_is_silent(const TaborDrum *drum) { return drum->state->asleep && !drum->tails; }

void tabor_drum_reset(TaborDrum *drum) {
  reset(drum);
  drum->state->event_debt = 0;
  drum->forgotten = (TbAirEnergy){.radiated = 0.0};
}

/* ---- queries -------------------------------------------------------------------------------- */

void tabor_drum_statistics(const TaborDrum *drum, TaborStatistics *statistics) {
  *statistics = drum->state->ledger.statistics;
  statistics->in_play += tb_strikers_in_play(drum->state);
}

void tabor_drum_ledger(const TaborDrum *drum, TaborLedger *ledger) {
  const TbView view = tb_view(drum->state, drum->model);
  *ledger = drum->state->ledger.sums;
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
  const double ends = view->model->rest.offset[0] - view->state->wires.shift[0];
  const double shape = wires->shape[node - TB_WIRE_FRONT];
  return wires->side * (ends + shape + view->model->rest.v[node] + view->now.v[node]);
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
  if (model->wires.count > 0) probe->wire_force = wires_force(&view);
  if (model->def.wires.count > 0) probe->wire = wire_height(&view);

  uint64_t newest = 0;
  for (uint32_t i = 0; i < TB_SLOTS; i++) {
    const TbSlot *slot = &drum->state->strikers.slots[i];
    if (!tb_slot_strikes(slot)) continue;
    const double force = view.solve.warm.force[tb_slot_row(&model->rows, i)];
    probe->striker_force = isnan(probe->striker_force) ? force : probe->striker_force + force;
    const bool shaft = tb_slot_is_end(slot) && slot->on_hoop; /* of a stick whose tip is meant */
    if (slot->serial > newest && !shaft) {
      newest = slot->serial;
      probe->striker = slot->rest_height + view.now.z[i];
      if (slot->end.bends) probe->striker += tb_stick_bow(&view, i, &view.now);
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
  tb_tails_end(&drum->tails);
  memcpy(drum->state, bytes, expected);
  drum->at_rest = false;
  return TABOR_OK;
}
