/* SPDX-License-Identifier: MIT */
/* What knobs and MIDI messages do to a voice. */
#include "lv2/plugin_player_internal.h"

#include <math.h>
#include <string.h>

#include "drums/live_headroom.h"
#include "strokes/fit_striker.h"

/* ---- events --------------------------------------------------------------------------------- */

/* Where there is no room, a parameter's last value counts. */
static void replace_parameter(Voice *voice, const TaborEvent *event) {
  if (event->type != TABOR_EVENT_PARAMETER) return;
  for (uint32_t i = voice->event_count; i-- > 0;) {
    TaborEvent *const other = &voice->events[i];
    if (other->type != TABOR_EVENT_PARAMETER || other->parameter != event->parameter) continue;
    other->value = event->value;
    return;
  }
}

static void push_event(Voice *voice, const TaborEvent *event) {
  if (voice->event_count == VOICE_EVENTS) {
    replace_parameter(voice, event);
    return;
  }
  voice->events[voice->event_count] = *event;
  voice->events[voice->event_count++].frame = 0;
}

static void process_at_once(Voice *voice, const TaborEvent *events, uint32_t count) {
  TaborDrum *const crossing = voice->crossing.drum;
  if (!voice->drum || count == 0) return;
  tabor_drum_process(voice->drum, events, count, NULL, 0);
  if (crossing) tabor_drum_process(crossing, events, count, NULL, 0);
}

void voice_move_parameter(Voice *voice, uint32_t id, double value) {
  const TaborEvent event = {.type = TABOR_EVENT_PARAMETER, .parameter = id, .value = value};
  silencer_remember(&voice->silencer, &event);
  process_at_once(voice, &event, 1);
}

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

void voice_note_events(Voice *voice, uint32_t count) {
  for (uint32_t i = 0; i < count; i++) {
    TaborEvent *const event = &voice->events[i];
    fit_striker(event, voice->striker_count);
    note_parameter(voice, event);
    silencer_remember(&voice->silencer, event);
  }
}

void voice_let_act(Voice *voice, uint32_t count) {
  voice_note_events(voice, count);
  process_at_once(voice, voice->events, count);
  voice->event_count -= count;
  voice->held_events -= count;
  memmove(voice->events, voice->events + count, voice->event_count * sizeof *voice->events);
  for (uint32_t i = 0; i < voice->action_count; i++) voice->actions[i].after -= count;
}

/* ---- knobs ---------------------------------------------------------------------------------- */

void voice_forget_turns(Wish *wish) {
  for (uint32_t i = 0; i < KNOB_KEYS; i++) wish->values[i] = NAN;
  wish->strainer = wish->grip = NAN;
}

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
  case KNOB_VELOCITY_CURVE: voice->map.response.curve = (MidiCurve)lroundf(value); break;
  case KNOB_VELOCITY_RANGE: voice->map.response.range = (MidiRange)lroundf(value); break;
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
  voice_move_parameter(voice, voice->ids[id], value);
}

/* Where strokes fall, until controllers say. */
void voice_place_strokes(Voice *voice) {
  MidiBinding *const binding = &voice->midi.binding;
  const double *const values = voice->wish.values;
  if (!isnan(values[KNOB_STRIKE_RADIUS])) {
    binding->radius = fmin(values[KNOB_STRIKE_RADIUS], binding->head_radius);
  }
  if (!isnan(values[KNOB_STRIKE_ANGLE])) binding->angle = values[KNOB_STRIKE_ANGLE];
}

void voice_forget_choice(Voice *voice) {
  voice->chosen = voice->chosen_before = WORKSHOP_NO_PROGRAM;
}

static void turn_key(Voice *voice, KnobId id, double value) {
  voice->wish.values[id] = value;
  voice_forget_choice(voice);
  switch (knobs[id].kind) {
  case KNOB_LIVE: turn_live(voice, id, value); break;
  case KNOB_REBUILD: voice->wish.number++; break;
  default: voice_place_strokes(voice); break;
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

static void take_event(Voice *voice, TaborEvent *event) {
  humanize(&voice->humanizer, voice->midi.binding.head_radius, event);
  push_event(voice, event);
}

static void insert_action(Voice *voice, uint32_t place, const MidiAction *action) {
  VoiceAction *const at = &voice->actions[place];
  memmove(at + 1, at, (voice->action_count - place) * sizeof *at);
  *at = (VoiceAction){.action = *action, .after = voice->held_events};
  voice->action_count++;
}

static void remove_action(Voice *voice, uint32_t place) {
  VoiceAction *const at = &voice->actions[place];
  voice->action_count--;
  memmove(at, at + 1, (voice->action_count - place) * sizeof *at);
}

/*
 * Of the program changes at one frame the last counts, and acts before all else; one to the drum that is there
 * already does nothing. The messages that follow are meant for the preset.
 */
static void take_preset(Voice *voice, const MidiAction *action) {
  const uint32_t first = voice->held_actions;
  const int32_t preset = (int32_t)action->preset;
  const bool takes_place =
    first < voice->action_count && voice->actions[first].action.type == MIDI_ACTION_PRESET;
  if (preset == voice->chosen || (voice->action_count == VOICE_ACTIONS && !takes_place)) return;
  if (takes_place) remove_action(voice, first);
  if (preset != voice->chosen_before) insert_action(voice, first, action);
  voice->chosen = preset;
  voice->midi.binding = voice->bindings[preset];
}

/* Where one that waits sets the gain after the last silence, the later value counts. */
static void take_gain(Voice *voice, const MidiAction *action) {
  for (uint32_t i = voice->action_count; i-- > 0;) {
    MidiAction *const other = &voice->actions[i].action;
    if (other->type == MIDI_ACTION_SILENCE) break;
    if (other->type != MIDI_ACTION_GAIN) continue;
    other->value = action->value;
    return;
  }
  if (voice->action_count < VOICE_ACTIONS) insert_action(voice, voice->action_count, action);
}

/* Nothing will have acted on the drum since the silence before. */
static bool is_silenced(const Voice *voice) {
  for (uint32_t i = voice->action_count; i-- > 0;) {
    const VoiceAction *const other = &voice->actions[i];
    if (other->after != voice->held_events) return false;
    if (other->action.type == MIDI_ACTION_SILENCE) return true;
  }
  return silencer_waits(&voice->silencer) && voice->held_events == 0;
}

static void take_silence(Voice *voice, const MidiAction *action) {
  if (is_silenced(voice) || voice->action_count == VOICE_ACTIONS) return;
  insert_action(voice, voice->action_count, action);
}

static void take_action(Voice *voice, const MidiAction *action) {
  switch (action->type) {
  case MIDI_ACTION_EVENT: break; /* these wait elsewhere */
  case MIDI_ACTION_GAIN: take_gain(voice, action); break;
  case MIDI_ACTION_SILENCE: take_silence(voice, action); break;
  case MIDI_ACTION_PRESET: take_preset(voice, action); break;
  }
}

void voice_take(Voice *voice, const MidiMessage *message) {
  MidiAction action;
  if (!midi_to_events_take(&voice->midi, message, &action)) return;
  if (action.type == MIDI_ACTION_EVENT) {
    take_event(voice, &action.event);
  } else {
    take_action(voice, &action);
  }
}

void voice_choose_preset(Voice *voice, uint32_t preset) {
  voice->wish.program = (int32_t)preset;
  voice->wish.choice++;
  voice->wish.number++;
  voice_forget_turns(&voice->wish);
  atomic_store(&voice->workshop->program, (int)preset);
}

static void act(Voice *voice, const MidiAction *action) {
  switch (action->type) {
  case MIDI_ACTION_EVENT: break; /* these wait elsewhere */
  case MIDI_ACTION_GAIN: fader_set(&voice->expression, action->value); break;
  case MIDI_ACTION_SILENCE:
    if (voice->drum) silencer_wish(&voice->silencer);
    break;
  case MIDI_ACTION_PRESET: voice_choose_preset(voice, action->preset); break;
  }
}

/* What has waited for the end of a silence acts in its order: strokes are for the drum of their time. */
static void act_first(Voice *voice) {
  const VoiceAction first = voice->actions[0];
  if (first.action.type != MIDI_ACTION_GAIN) voice_let_act(voice, first.after);
  remove_action(voice, 0);
  if (voice->held_actions > 0) voice->held_actions--;
  act(voice, &first.action);
}

void voice_act_due(Voice *voice, bool waits) {
  bool goes_on = true;
  while (goes_on && voice->action_count > 0 && !silencer_waits(&voice->silencer)) {
    goes_on = !waits || voice->actions[0].action.type != MIDI_ACTION_PRESET;
    act_first(voice);
  }
}
