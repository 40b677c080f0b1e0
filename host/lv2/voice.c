/* SPDX-License-Identifier: MIT */
#include "voice.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "live_headroom.h"

#define HUMANIZE_SEED 1

static const char *const mic_names[VOICE_MICS] = {"top", "bottom", "near", "far", "left", "right"};

/* ---- beginning and end ---------------------------------------------------------------------- */

static bool bind_presets(Voice *voice) {
  const uint32_t count = tabor_preset_count();
  voice->bindings = calloc(count, sizeof *voice->bindings);
  for (uint32_t i = 0; voice->bindings && i < count; i++) {
    TaborDrumDef def;
    if (tabor_drum_def_preset(&def, tabor_preset(i)->name, NULL) != TABOR_OK) return false;
    midi_binding_make(&voice->map, &def, &voice->bindings[i]);
  }
  return voice->bindings != NULL;
}

static void forget_turns(Wish *wish) {
  for (uint32_t i = 0; i < KNOB_KEYS; i++) wish->values[i] = NAN;
  wish->strainer = wish->grip = NAN;
}

static void prepare_knobs(Voice *voice) {
  for (uint32_t i = 0; i < KNOB_COUNT; i++) {
    const KnobId id = (KnobId)i;
    voice->seen[i] = NAN;
    voice->levels[i] = fader_at(0, voice->rate);
    if (i >= KNOB_KEYS) continue;
    voice->seen[i] = knob_range(id, &voice->workshop->base).fallback;
    voice->built[i] = NAN;
    if (knobs[i].kind == KNOB_LIVE) voice->ids[i] = tabor_parameter_find(knobs[i].key)->id;
  }
}

static void start_over(Voice *voice, const MidiBinding *binding) {
  midi_drum_begin(&voice->midi, &voice->map, binding);
  voice->humanizer.state = HUMANIZE_SEED;
  voice->silencer = silencer_begin(voice->rate);
  voice->expression = fader_at(1, voice->rate);
  voice->event_count = voice->action_count = 0;
}

bool voice_begin(Voice *voice, Workshop *workshop, double rate, bool stereo) {
  MidiBinding binding;
  voice->workshop = workshop;
  voice->rate = rate;
  voice->stereo = stereo;
  voice->map = workshop->map;
  voice->grip_id = tabor_parameter_find("hand.grip")->id;
  voice->head_radius = workshop->base.shell.radius;
  voice->gain = fader_at(1, rate);
  voice->chosen = WORKSHOP_NO_PROGRAM;
  voice->wish = (Wish){.number = 1, .program = WORKSHOP_NO_PROGRAM, .quality = TABOR_QUALITY_LIVE};
  forget_turns(&voice->wish);
  prepare_knobs(voice);
  midi_binding_make(&voice->map, &workshop->base, &binding);
  start_over(voice, &binding);
  return bind_presets(voice);
}

void voice_end(Voice *voice) {
  tabor_drum_destroy(voice->drum);
  free(voice->bindings);
}

/* ---- events --------------------------------------------------------------------------------- */

static void push_event(Voice *voice, const TaborEvent *event) {
  if (voice->event_count == VOICE_EVENTS) return;
  voice->events[voice->event_count] = *event;
  voice->events[voice->event_count++].frame = 0;
}

static void push_parameter(Voice *voice, uint32_t id, double value) {
  push_event(voice, &(TaborEvent){.type = TABOR_EVENT_PARAMETER, .parameter = id, .value = value});
}

/* ---- knobs ---------------------------------------------------------------------------------- */

static void fade_to(const Voice *voice, Fader *fader, double factor, bool at_once) {
  if (at_once) {
    *fader = fader_at(factor, voice->rate);
  } else {
    fader_set(fader, factor);
  }
}

static void turn_setting(Voice *voice, KnobId id, float value, bool at_once) {
  switch (id) {
  case KNOB_VELOCITY_CURVE: voice->map.curve = (MidiCurve)lroundf(value); break;
  case KNOB_HUMANIZE: voice->humanizer.amount = knob_decimal(value); break;
  case KNOB_QUALITY:
    voice->wish.quality = TABOR_QUALITY_DRAFT + (uint32_t)lroundf(value);
    voice->wish.number++;
    break;
  case KNOB_GAIN: fade_to(voice, &voice->gain, knob_factor(id, value), at_once); break;
  default: fade_to(voice, &voice->levels[id], knob_factor(id, value), at_once); break;
  }
}

/* The wires' grid is made for values not far above those of its model. */
static bool outgrows(const Voice *voice, KnobId id, double value) {
  return id == KNOB_WIRE_TENSION && value > LIVE_HEADROOM * voice->built[id];
}

static void turn_live(Voice *voice, KnobId id, double value) {
  if (id == KNOB_STRAINER) voice->wish.strainer = NAN;
  if (outgrows(voice, id, value)) voice->wish.number++;
  if (isnan(voice->built[id])) return; /* the drum has no such part, or there is none yet */
  voice->moved[id] = true;
  push_parameter(voice, voice->ids[id], value);
}

/* Where strokes fall, until controllers say. */
static void place_strokes(Voice *voice) {
  MidiBinding *const binding = &voice->midi.binding;
  const double *const values = voice->wish.values;
  if (!isnan(values[KNOB_STRIKE_RADIUS])) {
    binding->radius = fmin(values[KNOB_STRIKE_RADIUS], binding->head_radius);
  }
  if (!isnan(values[KNOB_STRIKE_ANGLE])) binding->angle = values[KNOB_STRIKE_ANGLE];
}

static void turn_key(Voice *voice, KnobId id, double value) {
  voice->wish.values[id] = value;
  voice->chosen = WORKSHOP_NO_PROGRAM;
  switch (knobs[id].kind) {
  case KNOB_LIVE: turn_live(voice, id, value); break;
  case KNOB_REBUILD: voice->wish.number++; break;
  default: place_strokes(voice); break;
  }
}

void voice_turn(Voice *voice, KnobId id, float value) {
  const float before = voice->seen[id];
  if (value == before) return;
  voice->seen[id] = value;
  if (id < KNOB_KEYS) {
    turn_key(voice, id, knob_decimal(value));
  } else {
    turn_setting(voice, id, value, isnan(before));
  }
}

/* ---- MIDI ----------------------------------------------------------------------------------- */

/* What MIDI moves stays so on the next model, unless that is another drum. */
static void note_parameter(Voice *voice, const TaborEvent *event) {
  if (event->type != TABOR_EVENT_PARAMETER) return;
  if (event->parameter == voice->ids[KNOB_STRAINER]) {
    voice->wish.strainer = event->value;
    voice->moved[KNOB_STRAINER] = true;
  }
  if (event->parameter == voice->grip_id) {
    voice->wish.grip = event->value;
    voice->grip_moved = true;
  }
}

static void take_event(Voice *voice, TaborEvent *event) {
  humanize(&voice->humanizer, voice->head_radius, event);
  note_parameter(voice, event);
  push_event(voice, event);
}

/* The messages that follow are meant for the preset. */
static void take_action(Voice *voice, const MidiAction *action) {
  if (voice->action_count == VOICE_ACTIONS) return;
  if (action->type == MIDI_ACTION_PRESET) {
    if (voice->chosen == (int32_t)action->preset) return;
    voice->chosen = (int32_t)action->preset;
    voice->midi.binding = voice->bindings[action->preset];
  }
  voice->actions[voice->action_count++] = *action;
}

void voice_take(Voice *voice, const MidiMessage *message) {
  MidiAction action;
  if (!midi_drum_take(&voice->midi, message, &action)) return;
  if (action.type == MIDI_ACTION_EVENT) {
    take_event(voice, &action.event);
  } else {
    take_action(voice, &action);
  }
}

static void choose_preset(Voice *voice, uint32_t preset) {
  voice->wish.program = (int32_t)preset;
  voice->wish.number++;
  forget_turns(&voice->wish);
  atomic_store(&voice->workshop->program, (int)preset);
}

static void act(Voice *voice, const MidiAction *action) {
  switch (action->type) {
  case MIDI_ACTION_EVENT: break; /* these wait elsewhere */
  case MIDI_ACTION_GAIN: fader_set(&voice->expression, action->value); break;
  case MIDI_ACTION_SILENCE:
    if (voice->drum) silencer_wish(&voice->silencer);
    break;
  case MIDI_ACTION_PRESET: choose_preset(voice, action->preset); break;
  }
}

/* Until a silence that the others have to wait for. */
static void act_due(Voice *voice) {
  uint32_t done = 0;
  while (done < voice->action_count && !silencer_waits(&voice->silencer)) {
    act(voice, &voice->actions[done++]);
  }
  voice->action_count -= done;
  memmove(voice->actions, voice->actions + done, voice->action_count * sizeof *voice->actions);
}

/* ---- another model -------------------------------------------------------------------------- */

static void take_restoration(Voice *voice, const Offer *offer) {
  voice->wish.restoration = offer->restoration;
  voice->wish.program = voice->chosen = WORKSHOP_NO_PROGRAM;
  atomic_store(&voice->workshop->program, WORKSHOP_NO_PROGRAM);
  forget_turns(&voice->wish);
  for (uint32_t i = 0; i < KNOB_KEYS; i++) {
    if (!isnan(offer->seen[i])) voice->seen[i] = offer->seen[i];
  }
}

static void attend(Voice *voice, const TaborDrumDef *def) {
  for (uint32_t i = 0; i < VOICE_MICS; i++) {
    const int mic = tabor_drum_def_find_mic(def, mic_names[i]);
    const bool may_replace = voice->stereo && i >= VOICE_LEFT;
    voice->mics[i] = mic >= 0 ? (uint32_t)mic : VOICE_NO_MIC;
    if (mic < 0 && may_replace) voice->mics[i] = 0;
  }
}

static void read_model(Voice *voice, TaborDrumDef *def) {
  attend(voice, def);
  voice->striker_count = def->striker_count;
  voice->head_radius = def->shell.radius;
  voice->built_grip = def->hand.grip;
  for (uint32_t i = 0; i < KNOB_KEYS; i++) {
    const double *const field = knob_field(def, (KnobId)i);
    voice->built[i] = field ? *field : NAN;
  }
}

/* The value that a live knob is to have: as MIDI says, else the knob, else the drum. */
static double live_value(const Voice *voice, KnobId id) {
  if (id == KNOB_STRAINER && !isnan(voice->wish.strainer)) return voice->wish.strainer;
  if (!isnan(voice->wish.values[id])) return voice->wish.values[id];
  return id == KNOB_STRAINER ? voice->midi.binding.strainer : voice->built[id];
}

/* The engine carries what was moved over to the new model; there it is put right. */
static void move_live(Voice *voice) {
  for (uint32_t i = 0; i < KNOB_KEYS; i++) {
    if (knobs[i].kind != KNOB_LIVE || isnan(voice->built[i])) continue;
    const double value = live_value(voice, (KnobId)i);
    const bool differs = value != voice->built[i];
    if (differs || voice->moved[i]) push_parameter(voice, voice->ids[i], value);
    voice->moved[i] = differs;
  }
  const double grip = isnan(voice->wish.grip) ? voice->built_grip : voice->wish.grip;
  if (voice->grip_moved) push_parameter(voice, voice->grip_id, grip);
  voice->grip_moved = grip != voice->built_grip;
}

static void swap(Voice *voice, TaborSwap *swap) {
  const TaborEvent event = {.type = TABOR_EVENT_SWAP, .swap = swap};
  tabor_drum_process(voice->drum, &event, 1, NULL, 0);
  voice->swap = swap;
}

/* Messages may be meant for a still newer preset already. */
static bool speaks_of(const Voice *voice, const Offer *offer) {
  return voice->chosen == WORKSHOP_NO_PROGRAM || voice->chosen == offer->program;
}

static void land(Voice *voice, Offer *offer) {
  if (!offer->is_news) return;
  if (offer->restoration != voice->wish.restoration) take_restoration(voice, offer);
  if (offer->failed) return;
  if (offer->drum) voice->drum = offer->drum;
  if (offer->swap) swap(voice, offer->swap);
  if (offer->begins_anew) silencer_forget(&voice->silencer);
  read_model(voice, &offer->def);
  if (speaks_of(voice, offer)) voice->midi.binding = offer->binding;
  place_strokes(voice);
  move_live(voice);
}

static bool wants(const Voice *voice) {
  return voice->wish.number != voice->asked ||
         atomic_load(&voice->workshop->restoration) != voice->asked_restoration;
}

void voice_receive(Voice *voice) {
  Offer *const offer = workshop_offer(voice->workshop);
  if (!offer) return;
  land(voice, offer);
  workshop_accept(voice->workshop);
}

bool voice_ask(Voice *voice) {
  const bool is_littered = voice->swap && tabor_swap_done(voice->swap);
  if (!workshop_is_idle(voice->workshop) || !(wants(voice) || is_littered)) return false;
  voice->asked = voice->wish.number;
  voice->asked_restoration = atomic_load(&voice->workshop->restoration);
  voice->swap = NULL; /* the worker may clear it up now */
  memcpy(voice->wish.seen, voice->seen, sizeof voice->wish.seen);
  workshop_ask(voice->workshop, &voice->wish);
  return true;
}

bool voice_is_settled(const Voice *voice) {
  return workshop_is_idle(voice->workshop) && !wants(voice);
}

/* ---- sound ---------------------------------------------------------------------------------- */

static bool is_audible(const Fader *fader) { return fader->now != 0 || fader->left > 0; }

/* The knob of a microphone's level. */
static KnobId level_of(VoiceMic mic) {
  static const KnobId levels[VOICE_MICS] = {KNOB_LEVEL_TOP, KNOB_LEVEL_BOTTOM, KNOB_LEVEL_NEAR,
                                            KNOB_LEVEL_FAR, KNOB_LEVEL_PAIR,   KNOB_LEVEL_PAIR};
  return levels[mic];
}

static bool hears(const Voice *voice, const VoiceOutputs *outputs, VoiceMic mic) {
  if (!voice->drum || voice->mics[mic] == VOICE_NO_MIC) return false;
  return voice->stereo ? is_audible(&voice->levels[level_of(mic)]) : outputs->channels[mic] != NULL;
}

/* Strokes that wait for the end of a silence stay. */
static uint32_t take_events(Voice *voice) {
  const uint32_t count = silencer_waits(&voice->silencer) ? 0 : voice->event_count;
  for (uint32_t i = 0; i < count; i++) {
    TaborEvent *const event = &voice->events[i];
    /* meant for another preset, which had more of them */
    if (event->type == TABOR_EVENT_STRIKE && event->striker >= voice->striker_count)
      event->striker = 0;
    silencer_remember(&voice->silencer, event);
  }
  voice->event_count -= count;
  return count;
}

static void compute(Voice *voice, const VoiceOutputs *outputs, uint32_t frames) {
  float *planar[TABOR_MAX_MICS] = {NULL}; /* for microphones that nobody hears */
  for (uint32_t mic = 0; mic < VOICE_MICS; mic++) {
    const uint32_t index = voice->mics[mic];
    if (hears(voice, outputs, (VoiceMic)mic)) planar[index] = voice->planar[index];
  }
  const uint32_t count = take_events(voice);
  if (voice->drum) tabor_drum_process(voice->drum, voice->events, count, planar, frames);
}

/* The gain of all channels: it moves with the frames. In the order of a rendering's factors. */
static double next_gain(Voice *voice) {
  return fader_next(&voice->gain) * fader_next(&voice->expression) *
         silencer_next(&voice->silencer);
}

static double sample_of(const Voice *voice, uint32_t mic, uint32_t frame) {
  return (double)voice->planar[voice->mics[mic]][frame];
}

static void mix_stereo(Voice *voice, float *const *channels, uint32_t at, uint32_t frames) {
  bool heard[VOICE_MICS];
  for (uint32_t mic = 0; mic < VOICE_MICS; mic++) {
    heard[mic] = hears(voice, NULL, (VoiceMic)mic);
  }
  for (uint32_t frame = 0; frame < frames; frame++) {
    const double gain = next_gain(voice), pair = fader_next(&voice->levels[KNOB_LEVEL_PAIR]);
    double left = heard[VOICE_LEFT] ? pair * sample_of(voice, VOICE_LEFT, frame) : 0;
    double right = heard[VOICE_RIGHT] ? pair * sample_of(voice, VOICE_RIGHT, frame) : 0;
    for (uint32_t mic = VOICE_TOP; mic <= VOICE_FAR; mic++) {
      const double level = fader_next(&voice->levels[level_of((VoiceMic)mic)]);
      const double sample = heard[mic] ? level * sample_of(voice, mic, frame) : 0;
      left += sample;
      right += sample;
    }
    if (channels[0]) channels[0][at + frame] = (float)(gain * left);
    if (channels[1]) channels[1][at + frame] = (float)(gain * right);
  }
}

static void mix_multi(Voice *voice, const VoiceOutputs *outputs, uint32_t at, uint32_t frames) {
  for (uint32_t frame = 0; frame < frames; frame++) {
    const double gain = next_gain(voice);
    for (uint32_t mic = 0; mic < VOICE_MICS; mic++) {
      if (!outputs->channels[mic]) continue;
      const bool heard = hears(voice, outputs, (VoiceMic)mic);
      outputs->channels[mic][at + frame] =
        heard ? (float)(gain * (double)voice->planar[voice->mics[mic]][frame]) : 0;
    }
  }
}

uint32_t voice_play(Voice *voice, const VoiceOutputs *outputs, uint32_t at, uint32_t most,
                    bool waits) {
  if (voice->drum) silencer_step(&voice->silencer, voice->drum);
  act_due(voice);
  if (waits && !voice_is_settled(voice)) return 0;
  const uint32_t frames = silencer_limit(&voice->silencer, most < VOICE_PIECE ? most : VOICE_PIECE);
  compute(voice, outputs, frames);
  if (voice->stereo) {
    mix_stereo(voice, outputs->channels, at, frames);
  } else {
    mix_multi(voice, outputs, at, frames);
  }
  return frames;
}

void voice_rest(Voice *voice) {
  const MidiBinding binding = voice->midi.binding;
  if (voice->drum) tabor_drum_reset(voice->drum);
  start_over(voice, &binding);
  voice->gain = fader_at(voice->gain.target, voice->rate);
  for (uint32_t i = KNOB_LEVEL_PAIR; i < KNOB_COUNT; i++) {
    voice->levels[i] = fader_at(voice->levels[i].target, voice->rate);
  }
  voice->wish.strainer = voice->wish.grip = NAN;
  memset(voice->moved, 0, sizeof voice->moved); /* the drum has the values of its model */
  voice->grip_moved = false;
  move_live(voice);
}
