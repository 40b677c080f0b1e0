/* SPDX-License-Identifier: MIT */
#include "voice.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "live_headroom.h"

#define HUMANIZE_SEED 1
#define CROSS_HOLD 0.008 /* [s] after which a swapped drum is heard at all usual microphones */
#define CROSS_FADE 0.008 /* [s] */
#define RING_OUT 0.03    /* [s] of a drum that another one takes the place of */

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
  tabor_drum_destroy(voice->leaving.drum);
  for (uint32_t i = 0; i < WORKSHOP_TRASH; i++) tabor_drum_destroy(voice->trash[i]);
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

/* What is under way to a microphone when it is switched on is not heard: its level waits for what comes. */
static void turn_level(Voice *voice, KnobId id, double factor, bool at_once) {
  Fader *const level = &voice->levels[id];
  if (level->now == 0 && level->left == 0) voice->waits[id] = (uint32_t)(VOICE_WAIT * voice->rate);
  if (at_once) voice->waits[id] = 0;
  fade_to(voice, level, factor, at_once);
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
  default: turn_level(voice, id, knob_factor(id, value), at_once); break;
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

static void throw_away(Voice *voice, TaborDrum *drum) {
  uint32_t i = 0;
  while (i + 1 < WORKSHOP_TRASH && voice->trash[i]) i++;
  voice->trash[i] = drum; /* there is room: wishes empty it, and leave two drums behind at most */
}

static void end_leaving(Voice *voice) {
  if (voice->leaving.drum) throw_away(voice, voice->leaving.drum);
  voice->leaving.drum = NULL;
}

static void begin_leaving(Voice *voice, TaborDrum *drum, bool is_copy) {
  Leaving *const leaving = &voice->leaving;
  end_leaving(voice);
  leaving->drum = drum;
  leaving->is_copy = is_copy;
  memcpy(leaving->mics, voice->mics, sizeof leaving->mics);
  leaving->hold = is_copy ? (uint32_t)(CROSS_HOLD * voice->rate) : 0;
  leaving->fade = (uint32_t)((is_copy ? CROSS_FADE : RING_OUT) * voice->rate);
}

/* A copy of the drum goes on as it was. */
static void copy_drum(Voice *voice, const Offer *offer) {
  tabor_drum_state_save(voice->drum, offer->state);
  const size_t size = tabor_drum_state_size(offer->spare);
  const bool copied = tabor_drum_state_load(offer->spare, offer->state, size) == TABOR_OK;
  if (copied && !tabor_drum_is_silent(voice->drum)) {
    begin_leaving(voice, offer->spare, true);
  } else {
    throw_away(voice, offer->spare);
  }
}

static void swap(Voice *voice, const Offer *offer) {
  const TaborEvent event = {.type = TABOR_EVENT_SWAP, .swap = offer->swap};
  if (offer->spare) copy_drum(voice, offer);
  tabor_drum_process(voice->drum, &event, 1, NULL, 0);
  voice->swap = offer->swap;
}

static void replace(Voice *voice, TaborDrum *drum) {
  if (voice->drum) begin_leaving(voice, voice->drum, false);
  voice->drum = drum;
  memset(voice->moved, 0, sizeof voice->moved);
  voice->grip_moved = false;
}

/* Messages may be meant for a still newer preset already. */
static bool speaks_of(const Voice *voice, const Offer *offer) {
  return voice->chosen == WORKSHOP_NO_PROGRAM || voice->chosen == offer->program;
}

static void land(Voice *voice, Offer *offer) {
  if (!offer->is_news) return;
  voice->answered = offer->number;
  voice->answered_restoration = offer->restoration;
  if (offer->restoration != voice->wish.restoration) take_restoration(voice, offer);
  if (offer->failed) return;
  if (offer->drum) replace(voice, offer->drum);
  if (offer->swap) swap(voice, offer);
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

static bool is_littered(const Voice *voice) {
  return voice->trash[0] || (voice->swap && tabor_swap_done(voice->swap));
}

bool voice_ask(Voice *voice) {
  if (!workshop_is_idle(voice->workshop) || !(wants(voice) || is_littered(voice))) return false;
  voice->asked = voice->wish.number;
  voice->asked_restoration = atomic_load(&voice->workshop->restoration);
  voice->swap = NULL; /* the worker may clear it up now */
  memcpy(voice->wish.seen, voice->seen, sizeof voice->wish.seen);
  memcpy(voice->wish.trash, voice->trash, sizeof voice->wish.trash);
  memset(voice->trash, 0, sizeof voice->trash);
  workshop_ask(voice->workshop, &voice->wish);
  return true;
}

bool voice_is_ready(const Voice *voice) {
  return voice->drum && voice->answered == voice->wish.number &&
         voice->answered_restoration == atomic_load(&voice->workshop->restoration);
}

bool voice_is_settled(const Voice *voice) {
  return workshop_is_idle(voice->workshop) && !wants(voice);
}

/* ---- sound ---------------------------------------------------------------------------------- */

static bool is_audible(const Voice *voice, KnobId id) {
  return voice->levels[id].now != 0 || voice->levels[id].left > 0;
}

/* The knob of a microphone's level. */
static KnobId level_of(VoiceMic mic) {
  static const KnobId levels[VOICE_MICS] = {KNOB_LEVEL_TOP, KNOB_LEVEL_BOTTOM, KNOB_LEVEL_NEAR,
                                            KNOB_LEVEL_FAR, KNOB_LEVEL_PAIR,   KNOB_LEVEL_PAIR};
  return levels[mic];
}

static bool hears(const Voice *voice, const VoiceOutputs *outputs, VoiceMic mic) {
  if (!voice->drum) return false;
  return voice->stereo ? is_audible(voice, level_of(mic)) : outputs->channels[mic] != NULL;
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

/* Where a drum's microphones go: NULL for those that nobody hears. */
static void choose_planar(const bool *heard, const uint32_t *mics, float (*samples)[VOICE_PIECE],
                          float **planar) {
  for (uint32_t mic = 0; mic < VOICE_MICS; mic++) {
    if (heard[mic] && mics[mic] != VOICE_NO_MIC) planar[mics[mic]] = samples[mics[mic]];
  }
}

static void compute(Voice *voice, const bool *heard, uint32_t frames) {
  Leaving *const leaving = &voice->leaving;
  float *planar[TABOR_MAX_MICS] = {NULL}, *leaving_planar[TABOR_MAX_MICS] = {NULL};
  const uint32_t count = take_events(voice);
  if (!voice->drum) return;
  choose_planar(heard, voice->mics, voice->planar, planar);
  tabor_drum_process(voice->drum, voice->events, count, planar, frames);
  if (!leaving->drum) return;
  choose_planar(heard, leaving->mics, voice->leaving_planar, leaving_planar);
  tabor_drum_process(leaving->drum, voice->events, leaving->is_copy ? count : 0, leaving_planar,
                     frames);
}

/* How much of the leaving drum is heard so many frames from now. */
static double leaving_part(const Voice *voice, uint32_t frame) {
  const Leaving *const leaving = &voice->leaving;
  const double length = (leaving->is_copy ? CROSS_FADE : RING_OUT) * voice->rate;
  if (frame < leaving->hold) return 1;
  const uint32_t gone = frame - leaving->hold;
  return gone < leaving->fade ? (leaving->fade - gone) / (length + 1) : 0;
}

/* What a microphone hears, of the drum and of the one that leaves. */
static void gather(Voice *voice, VoiceMic mic, uint32_t frames) {
  const Leaving *const leaving = &voice->leaving;
  const uint32_t index = voice->mics[mic], old = leaving->mics[mic];
  double *const sound = voice->sound[mic];
  for (uint32_t i = 0; i < frames; i++) {
    sound[i] = index == VOICE_NO_MIC ? 0 : (double)voice->planar[index][i];
  }
  for (uint32_t i = 0; leaving->drum && i < frames; i++) {
    const double part = leaving_part(voice, i);
    const double sample = old == VOICE_NO_MIC ? 0 : (double)voice->leaving_planar[old][i];
    sound[i] += part * (sample - (leaving->is_copy ? sound[i] : 0));
  }
}

static void pass(Voice *voice, uint32_t frames) {
  Leaving *const leaving = &voice->leaving;
  const uint32_t held = frames < leaving->hold ? frames : leaving->hold, rest = frames - held;
  leaving->hold -= held;
  leaving->fade -= rest < leaving->fade ? rest : leaving->fade;
  if (leaving->hold + leaving->fade == 0) end_leaving(voice);
}

/* The gain of all channels: it moves with the frames. In the order of a rendering's factors. */
static double next_gain(Voice *voice) {
  return fader_next(&voice->gain) * fader_next(&voice->expression) *
         silencer_next(&voice->silencer);
}

static double next_level(Voice *voice, KnobId id) {
  if (voice->waits[id] == 0) return fader_next(&voice->levels[id]);
  voice->waits[id]--;
  return voice->levels[id].now;
}

static void mix_stereo(Voice *voice, const bool *heard, float *const *channels, uint32_t at,
                       uint32_t frames) {
  for (uint32_t frame = 0; frame < frames; frame++) {
    const double gain = next_gain(voice), pair = next_level(voice, KNOB_LEVEL_PAIR);
    double left = heard[VOICE_LEFT] ? pair * voice->sound[VOICE_LEFT][frame] : 0;
    double right = heard[VOICE_RIGHT] ? pair * voice->sound[VOICE_RIGHT][frame] : 0;
    for (uint32_t mic = VOICE_TOP; mic <= VOICE_FAR; mic++) {
      const double level = next_level(voice, level_of((VoiceMic)mic));
      const double sample = heard[mic] ? level * voice->sound[mic][frame] : 0;
      left += sample;
      right += sample;
    }
    if (channels[0]) channels[0][at + frame] = (float)(gain * left);
    if (channels[1]) channels[1][at + frame] = (float)(gain * right);
  }
}

static void mix_multi(Voice *voice, const bool *heard, float *const *channels, uint32_t at,
                      uint32_t frames) {
  for (uint32_t frame = 0; frame < frames; frame++) {
    const double gain = next_gain(voice);
    for (uint32_t mic = 0; mic < VOICE_MICS; mic++) {
      const double sample = heard[mic] ? voice->sound[mic][frame] : 0;
      if (channels[mic]) channels[mic][at + frame] = (float)(gain * sample);
    }
  }
}

uint32_t voice_play(Voice *voice, const VoiceOutputs *outputs, uint32_t at, uint32_t most,
                    bool waits) {
  if (silencer_is_due(&voice->silencer)) end_leaving(voice);
  if (voice->drum) silencer_step(&voice->silencer, voice->drum);
  act_due(voice);
  if (waits && !voice_is_settled(voice)) return 0;
  const uint32_t frames = silencer_limit(&voice->silencer, most < VOICE_PIECE ? most : VOICE_PIECE);
  bool heard[VOICE_MICS];
  for (uint32_t mic = 0; mic < VOICE_MICS; mic++) heard[mic] = hears(voice, outputs, (VoiceMic)mic);
  compute(voice, heard, frames);
  for (uint32_t mic = 0; mic < VOICE_MICS; mic++) {
    if (heard[mic]) gather(voice, (VoiceMic)mic, frames);
  }
  if (voice->stereo) {
    mix_stereo(voice, heard, outputs->channels, at, frames);
  } else {
    mix_multi(voice, heard, outputs->channels, at, frames);
  }
  if (voice->leaving.drum) pass(voice, frames);
  return frames;
}

void voice_rest(Voice *voice) {
  const MidiBinding binding = voice->midi.binding;
  if (voice->drum) tabor_drum_reset(voice->drum);
  end_leaving(voice);
  start_over(voice, &binding);
  voice->gain = fader_at(voice->gain.target, voice->rate);
  for (uint32_t i = KNOB_LEVEL_PAIR; i < KNOB_COUNT; i++) {
    voice->levels[i] = fader_at(voice->levels[i].target, voice->rate);
    voice->waits[i] = 0;
  }
  voice->wish.strainer = voice->wish.grip = NAN;
  memset(voice->moved, 0, sizeof voice->moved); /* the drum has the values of its model */
  voice->grip_moved = false;
  move_live(voice);
}
