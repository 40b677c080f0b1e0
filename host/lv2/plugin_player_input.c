/* SPDX-License-Identifier: MIT */
/* Applies knobs and MIDI messages to a player. */
#include "lv2/plugin_player_internal.h"

#include <math.h>
#include <string.h>

#include "drums/live_headroom.h"
#include "strokes/fit_striker.h"

/* ---- events --------------------------------------------------------------------------------- */

/* Where there is no room, a parameter's last value counts. */
static void replace_parameter(PluginPlayer *player, const TaborEvent *event) {
  if (event->type != TABOR_EVENT_PARAMETER) return;
  for (uint32_t i = player->event_count; i-- > 0;) {
    TaborEvent *const other = &player->events[i];
    if (other->type != TABOR_EVENT_PARAMETER || other->parameter != event->parameter) continue;
    other->value = event->value;
    return;
  }
}

static void push_event(PluginPlayer *player, const TaborEvent *event) {
  if (player->event_count == PLUGIN_EVENTS) {
    replace_parameter(player, event);
    return;
  }
  player->events[player->event_count] = *event;
  player->events[player->event_count++].frame = 0;
}

static void process_at_once(PluginPlayer *player, const TaborEvent *events, uint32_t count) {
  TaborDrum *const crossing = player->crossing.drum;
  if (!player->drum || count == 0) return;
  tabor_drum_process(player->drum, events, count, NULL, 0);
  if (crossing) tabor_drum_process(crossing, events, count, NULL, 0);
}

void plugin_player_move_parameter(PluginPlayer *player, uint32_t id, double value) {
  const TaborEvent event = {.type = TABOR_EVENT_PARAMETER, .parameter = id, .value = value};
  silencer_remember(&player->silencer, &event);
  process_at_once(player, &event, 1);
}

/* What MIDI moves stays so on the next model, unless that is another drum. */
static void note_parameter(PluginPlayer *player, const TaborEvent *event) {
  if (event->type != TABOR_EVENT_PARAMETER) return;
  if (event->parameter == player->ids[KNOB_STRAINER]) {
    player->request.strainer = event->value;
    player->moved[KNOB_STRAINER] = true;
  }
  if (event->parameter == player->grip_id) {
    player->request.grip = event->value;
    player->grip_moved = true;
  }
}

void plugin_player_note_events(PluginPlayer *player, uint32_t count) {
  for (uint32_t i = 0; i < count; i++) {
    TaborEvent *const event = &player->events[i];
    fit_striker(event, player->striker_count);
    note_parameter(player, event);
    silencer_remember(&player->silencer, event);
  }
}

void plugin_player_let_act(PluginPlayer *player, uint32_t count) {
  plugin_player_note_events(player, count);
  process_at_once(player, player->events, count);
  player->event_count -= count;
  player->held_events -= count;
  memmove(player->events, player->events + count, player->event_count * sizeof *player->events);
  for (uint32_t i = 0; i < player->action_count; i++) player->actions[i].after -= count;
}

/* ---- knobs ---------------------------------------------------------------------------------- */

void plugin_player_forget_turns(Request *request) {
  for (uint32_t i = 0; i < KNOB_KEYS; i++) request->values[i] = NAN;
  request->strainer = request->grip = NAN;
}

static void fade_to(const PluginPlayer *player, Fader *fader, double factor, bool at_once) {
  if (at_once) {
    *fader = fader_at(factor, player->rate);
  } else {
    fader_set(fader, factor);
  }
}

/* What is under way to a microphone when it is switched on is not heard: its level waits for what comes. */
static void turn_level(PluginPlayer *player, KnobId id, double factor, bool at_once) {
  Fader *const level = &player->levels[id];
  if (level->now == 0 && level->left == 0)
    player->waits[id] = (uint32_t)(PLUGIN_WAIT * player->rate);
  if (at_once) player->waits[id] = 0;
  fade_to(player, level, factor, at_once);
}

static void turn_setting(PluginPlayer *player, KnobId id, float value, bool at_once) {
  switch (id) {
  case KNOB_VELOCITY_CURVE: player->map.response.curve = (MidiCurve)lroundf(value); break;
  case KNOB_VELOCITY_RANGE: player->map.response.range = (MidiRange)lroundf(value); break;
  case KNOB_HUMANIZE: player->humanizer.amount = knob_decimal(value); break;
  case KNOB_QUALITY:
    player->request.quality = TABOR_QUALITY_DRAFT + (uint32_t)lroundf(value);
    player->request.number++;
    break;
  case KNOB_GAIN: fade_to(player, &player->gain, knob_factor(id, value), at_once); break;
  default: turn_level(player, id, knob_factor(id, value), at_once); break;
  }
}

/* The wires' grid is made for values not far above those of its model. */
static bool outgrows(const PluginPlayer *player, KnobId id, double value) {
  return id == KNOB_WIRE_TENSION && value > LIVE_HEADROOM * player->built[id];
}

static void turn_live(PluginPlayer *player, KnobId id, double value) {
  if (id == KNOB_STRAINER) player->request.strainer = NAN;
  if (outgrows(player, id, value)) player->request.number++;
  if (isnan(player->built[id])) return; /* the drum has no such part, or there is none yet */
  player->moved[id] = true;
  plugin_player_move_parameter(player, player->ids[id], value);
}

/* Where strokes fall, until controllers say. */
void plugin_player_place_strokes(PluginPlayer *player) {
  MidiBinding *const binding = &player->midi.binding;
  const double *const values = player->request.values;
  if (!isnan(values[KNOB_STRIKE_RADIUS])) {
    binding->radius = fmin(values[KNOB_STRIKE_RADIUS], binding->head_radius);
  }
  if (!isnan(values[KNOB_STRIKE_ANGLE])) binding->angle = values[KNOB_STRIKE_ANGLE];
}

void plugin_player_forget_choice(PluginPlayer *player) {
  player->chosen = player->chosen_before = MODEL_WORKER_NO_PROGRAM;
}

static void turn_key(PluginPlayer *player, KnobId id, double value) {
  player->request.values[id] = value;
  plugin_player_forget_choice(player);
  switch (knobs[id].kind) {
  case KNOB_LIVE: turn_live(player, id, value); break;
  case KNOB_REBUILD: player->request.number++; break;
  default: plugin_player_place_strokes(player); break;
  }
}

void plugin_player_turn(PluginPlayer *player, KnobId id, float value) {
  const float before = player->seen[id];
  if (value == before) return;
  player->seen[id] = value;
  if (id < KNOB_KEYS) {
    turn_key(player, id, knob_decimal(value));
  } else {
    turn_setting(player, id, value, isnan(before));
  }
}

/* ---- MIDI ----------------------------------------------------------------------------------- */

static void take_event(PluginPlayer *player, TaborEvent *event) {
  humanize(&player->humanizer, player->midi.binding.head_radius, event);
  push_event(player, event);
}

static void insert_action(PluginPlayer *player, uint32_t place, const MidiAction *action) {
  PluginAction *const at = &player->actions[place];
  memmove(at + 1, at, (player->action_count - place) * sizeof *at);
  *at = (PluginAction){.action = *action, .after = player->held_events};
  player->action_count++;
}

static void remove_action(PluginPlayer *player, uint32_t place) {
  PluginAction *const at = &player->actions[place];
  player->action_count--;
  memmove(at, at + 1, (player->action_count - place) * sizeof *at);
}

/*
 * Of the program changes at one frame the last counts, and acts before all else; one to the drum that is there
 * already does nothing. The messages that follow are meant for the preset.
 */
static void take_preset(PluginPlayer *player, const MidiAction *action) {
  const uint32_t first = player->held_actions;
  const int32_t preset = (int32_t)action->preset;
  const bool takes_place =
    first < player->action_count && player->actions[first].action.type == MIDI_ACTION_PRESET;
  if (preset == player->chosen || (player->action_count == PLUGIN_ACTIONS && !takes_place)) return;
  if (takes_place) remove_action(player, first);
  if (preset != player->chosen_before) insert_action(player, first, action);
  player->chosen = preset;
  player->midi.binding = player->bindings[preset];
}

/* Where one that waits sets the gain after the last silence, the later value counts. */
static void take_gain(PluginPlayer *player, const MidiAction *action) {
  for (uint32_t i = player->action_count; i-- > 0;) {
    MidiAction *const other = &player->actions[i].action;
    if (other->type == MIDI_ACTION_SILENCE) break;
    if (other->type != MIDI_ACTION_GAIN) continue;
    other->value = action->value;
    return;
  }
  if (player->action_count < PLUGIN_ACTIONS) insert_action(player, player->action_count, action);
}

/* Nothing will have acted on the drum since the silence before. */
static bool is_silenced(const PluginPlayer *player) {
  for (uint32_t i = player->action_count; i-- > 0;) {
    const PluginAction *const other = &player->actions[i];
    if (other->after != player->held_events) return false;
    if (other->action.type == MIDI_ACTION_SILENCE) return true;
  }
  return silencer_waits(&player->silencer) && player->held_events == 0;
}

static void take_silence(PluginPlayer *player, const MidiAction *action) {
  if (is_silenced(player) || player->action_count == PLUGIN_ACTIONS) return;
  insert_action(player, player->action_count, action);
}

static void take_action(PluginPlayer *player, const MidiAction *action) {
  switch (action->type) {
  case MIDI_ACTION_EVENT: break; /* these wait elsewhere */
  case MIDI_ACTION_GAIN: take_gain(player, action); break;
  case MIDI_ACTION_SILENCE: take_silence(player, action); break;
  case MIDI_ACTION_PRESET: take_preset(player, action); break;
  }
}

void plugin_player_take(PluginPlayer *player, const MidiMessage *message) {
  MidiAction action;
  if (!midi_to_events_take(&player->midi, message, &action)) return;
  if (action.type == MIDI_ACTION_EVENT) {
    take_event(player, &action.event);
  } else {
    take_action(player, &action);
  }
}

void plugin_player_choose_preset(PluginPlayer *player, uint32_t preset) {
  player->request.program = (int32_t)preset;
  player->request.choice++;
  player->request.number++;
  plugin_player_forget_turns(&player->request);
  atomic_store(&player->worker->program, (int)preset);
}

static void act(PluginPlayer *player, const MidiAction *action) {
  switch (action->type) {
  case MIDI_ACTION_EVENT: break; /* these wait elsewhere */
  case MIDI_ACTION_GAIN: fader_set(&player->expression, action->value); break;
  case MIDI_ACTION_SILENCE:
    if (player->drum) silencer_wish(&player->silencer);
    break;
  case MIDI_ACTION_PRESET: plugin_player_choose_preset(player, action->preset); break;
  }
}

/* What has waited for the end of a silence acts in its order: strokes are for the drum of their time. */
static void act_first(PluginPlayer *player) {
  const PluginAction first = player->actions[0];
  if (first.action.type != MIDI_ACTION_GAIN) plugin_player_let_act(player, first.after);
  remove_action(player, 0);
  if (player->held_actions > 0) player->held_actions--;
  act(player, &first.action);
}

void plugin_player_act_due(PluginPlayer *player, bool waits) {
  bool goes_on = true;
  while (goes_on && player->action_count > 0 && !silencer_waits(&player->silencer)) {
    goes_on = !waits || player->actions[0].action.type != MIDI_ACTION_PRESET;
    act_first(player);
  }
}
