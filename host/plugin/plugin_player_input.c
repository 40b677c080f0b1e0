/* SPDX-License-Identifier: MIT */
/* Applies knobs and MIDI messages to a player. */
#include "plugin/plugin_player_internal.h"

#include <math.h>
#include <string.h>

#include "drums/live_headroom.h"

static const double HEARING_THRESHOLD = 2e-5; /* [Pa]: 0 dB SPL */

/* ---- messages ------------------------------------------------------------------------------- */

/* Where there is no room, the last value counts of a parameter and of the gain. */
static void replace_value(PluginPlayer *player, const PlayerMessage *message) {
  const bool moves = message->event.type == TABOR_EVENT_PARAMETER;
  if (message->type == PLAYER_EVENT && !moves) return;
  for (uint32_t i = player->count; i-- > player->first_count;) {
    PlayerMessage *const other = &player->messages[i].message;
    if (other->type != message->type || other->event.type != message->event.type) continue;
    if (other->event.parameter != message->event.parameter) continue;
    other->value = message->value;
    other->event.value = message->event.value;
    return;
  }
}

/* Gains and silences act before all else at their frame, as they do in a song. */
static bool acts_early(const PlayerMessage *message) {
  return message->type != PLAYER_EVENT || message->event.type == TABOR_EVENT_SILENCE;
}

static void insert(PluginPlayer *player, uint32_t place, const PluginMessage *message) {
  PluginMessage *const at = &player->messages[place];
  memmove(at + 1, at, (player->count - place) * sizeof *at);
  *at = *message;
  player->count++;
}

static void push(PluginPlayer *player, const PlayerMessage *message) {
  uint32_t place = player->count;
  if (player->count == PLUGIN_MESSAGES) {
    replace_value(player, message);
    return;
  }
  while (acts_early(message) && place > player->first_count &&
         player->messages[place - 1].message.frame == message->frame &&
         !acts_early(&player->messages[place - 1].message)) {
    place--;
  }
  insert(player, place, &(PluginMessage){.message = *message, .is_midi = true});
}

/* The last message makes room: it is one of MIDI's, since the others are few. */
void plugin_player_act_now(PluginPlayer *player, const PlayerMessage *message) {
  PluginMessage now = {.message = *message};
  now.message.frame = player->core.position;
  if (player->count == PLUGIN_MESSAGES) player->count--;
  insert(player, player->first_count++, &now);
}

void plugin_player_move_parameter(PluginPlayer *player, uint32_t id, double value) {
  const PlayerMessage message = {
    .type = PLAYER_EVENT,
    .event = {.type = TABOR_EVENT_PARAMETER, .parameter = id, .value = value}};
  if (player->core.drum) plugin_player_act_now(player, &message);
}

/* What MIDI moves stays so on the next model, unless that is another drum. */
static void note_parameter(PluginPlayer *player, const TaborEvent *event) {
  if (event->type != TABOR_EVENT_PARAMETER) return;
  if (event->parameter == player->ids[KNOB_STRAINER]) {
    player->request.strainer = knob_turned(event->value);
    player->moved[KNOB_STRAINER] = true;
  }
  if (event->parameter == player->grip_id) {
    player->request.grip = knob_turned(event->value);
    player->grip_moved = true;
  }
}

bool plugin_player_next(void *source, uint64_t end, PlayerMessage *message) {
  PluginPlayer *const player = source;
  const PluginMessage *const first = player->messages;
  if (player->count == 0 || first->message.frame >= end) return false;
  *message = first->message;
  if (first->is_midi && message->type == PLAYER_EVENT) note_parameter(player, &message->event);
  player->count--;
  if (player->first_count > 0) player->first_count--;
  memmove(player->messages, first + 1, player->count * sizeof *first);
  return true;
}

/* ---- knobs ---------------------------------------------------------------------------------- */

void plugin_player_forget_turns(Request *request) {
  memset(request->turns, 0, sizeof request->turns);
  request->strainer = request->grip = (KnobTurn){.is_turned = false};
}

static void fade_to(const PluginPlayer *player, Fader *fader, double factor, bool at_once) {
  if (at_once) {
    *fader = fader_at(factor, player->rate);
  } else {
    fader_set(fader, factor);
  }
}

/* What is under way to a microphone when it is switched on is not heard: its level waits for what
 * comes. */
static void turn_level(PluginPlayer *player, KnobId id, double factor, bool at_once) {
  Fader *const level = &player->levels[id];
  if (level->now == 0 && level->left == 0)
    player->waits[id] = (uint32_t)(PLUGIN_WAIT * player->rate);
  if (at_once) player->waits[id] = 0;
  fade_to(player, level, factor, at_once);
}

static void set_gain(PluginPlayer *player, double factor) {
  const PlayerMessage message = {.type = PLAYER_GAIN, .value = factor * player->base_gain};
  plugin_player_act_now(player, &message);
}

/* The wires' grid is made for values not far above those of its model. */
static double modulated(const PluginPlayer *player, KnobId id, double value) {
  const KnobRange *const range = &player->ranges[id];
  double most = (double)range->maximum;
  if (player->offsets[id] == 0) return value;
  if (id == KNOB_WIRE_TENSION) most = fmin(most, fmax(value, LIVE_HEADROOM * player->built[id]));
  return fmin(fmax(value + (double)player->offsets[id], (double)range->minimum), most);
}

static double factor_of(const PluginPlayer *player, KnobId id) {
  const double factor =
    knob_factor(&knobs[id], (float)modulated(player, id, (double)player->seen[id]));
  return knob_is_level(id) ? factor / player->base_gain : factor;
}

double plugin_player_live_value(const PluginPlayer *player, KnobId id) {
  const Request *const request = &player->request;
  const double own = id == KNOB_STRAINER ? player->strainer : player->built[id];
  const double by_knob = knob_turned_or(request->turns[id], own);
  const bool by_midi = id == KNOB_STRAINER && request->strainer.is_turned;
  return modulated(player, id, by_midi ? request->strainer.value : by_knob);
}

static void set_quality(PluginPlayer *player) {
  Request *const request = &player->request;
  request->is_held = !player->exports && player->quality > PLUGIN_LIVE_QUALITY;
  request->quality = request->is_held ? PLUGIN_LIVE_QUALITY : player->quality;
  request->number++;
}

void plugin_player_export(PluginPlayer *player, bool exports) {
  if (player->exports == exports) return;
  player->exports = exports;
  if (player->quality > PLUGIN_LIVE_QUALITY) set_quality(player);
}

/* Of an effect that is not enabled there is none. What is not known yet will follow. */
static double part_of_drum(const PluginPlayer *player) {
  const float mix = player->seen[KNOB_MIX];
  return player->seen[KNOB_ENABLED] == 0 || isnan(mix) ? 0 : knob_decimal(mix);
}

static void turn_setting(PluginPlayer *player, KnobId id, float value, bool at_once) {
  switch (id) {
  case KNOB_VELOCITY_CURVE: player->map.response.curve = (MidiCurve)lroundf(value); break;
  case KNOB_VELOCITY_RANGE: player->map.response.range = (MidiRange)lroundf(value); break;
  case KNOB_HUMANIZE: player->humanizer.amount = knob_decimal(value); break;
  case KNOB_QUALITY:
    player->quality = TABOR_QUALITY_DRAFT + (uint32_t)lroundf(value);
    set_quality(player);
    break;
  case KNOB_STICK:
    player->request.stick = (uint32_t)lroundf(value);
    player->request.number++;
    break;
  case KNOB_ROOM:
    player->request.room = (uint32_t)lroundf(value);
    player->request.number++;
    break;
  case KNOB_GAIN: set_gain(player, factor_of(player, id)); break;
  case KNOB_SOUND:
    fade_to(player, &player->sound, HEARING_THRESHOLD * knob_factor(&knobs[id], value), at_once);
    break;
  case KNOB_MIX:
  case KNOB_ENABLED: fade_to(player, &player->mix, part_of_drum(player), at_once); break;
  default: turn_level(player, id, factor_of(player, id), at_once); break;
  }
}

static bool outgrows(const PluginPlayer *player, KnobId id, double value) {
  return id == KNOB_WIRE_TENSION && value > LIVE_HEADROOM * player->built[id];
}

static void turn_live(PluginPlayer *player, KnobId id, double value) {
  if (id == KNOB_STRAINER) player->request.strainer.is_turned = false;
  if (outgrows(player, id, value)) player->request.number++;
  if (isnan(player->built[id])) return; /* the drum has no such part, or there is none yet */
  player->moved[id] = true;
  plugin_player_move_parameter(player, player->ids[id], modulated(player, id, value));
}

/* Where strokes fall, until controllers say. */
void plugin_player_place_strokes(PluginPlayer *player) {
  MidiBinding *const binding = &player->midi.binding;
  const KnobTurn *const turns = player->request.turns;
  const double radius = knob_turned_or(turns[KNOB_STRIKE_RADIUS], binding->radius);
  binding->radius = fmin(radius, binding->head_radius);
  binding->angle = knob_turned_or(turns[KNOB_STRIKE_ANGLE], binding->angle);
}

void plugin_player_forget_choice(PluginPlayer *player) {
  player->chosen = player->chosen_before = MODEL_WORKER_NO_PROGRAM;
}

static void turn_key(PluginPlayer *player, KnobId id, double value) {
  player->request.turns[id] = knob_turned(value);
  plugin_player_forget_choice(player);
  switch (knobs[id].kind) {
  case KNOB_LIVE: turn_live(player, id, value); break;
  case KNOB_REBUILD: player->request.number++; break;
  default: plugin_player_place_strokes(player); break;
  }
}

/* ---- drums ---------------------------------------------------------------------------------- */

/* A restored drum that is on its way takes the place of what is chosen meanwhile. */
static bool is_restoring(const PluginPlayer *player) {
  return player->request.restoration != atomic_load(&player->worker->restoration);
}

/* The messages that follow are meant for the preset. */
static void take_preset(PluginPlayer *player, uint32_t preset) {
  if ((int32_t)preset == player->chosen) return;
  player->chosen = (int32_t)preset;
  player->midi.binding = player->bindings[preset];
}

void plugin_player_begin_frame(PluginPlayer *player) { player->chosen_before = player->chosen; }

/* Of the program changes at one frame the last counts; one to the drum that is there already does
 * nothing. */
bool plugin_player_has_choice(const PluginPlayer *player) {
  return player->chosen != player->chosen_before;
}

void plugin_player_choose(PluginPlayer *player) {
  player->restored_drum = NAN;
  player->request.program = player->chosen;
  player->request.choice++;
  player->request.keeps_room = true;
  player->request.number++;
  plugin_player_forget_turns(&player->request);
  if (!is_restoring(player)) player->given[KNOB_DRUM] = (float)player->chosen;
  atomic_store(&player->worker->program, player->chosen);
}

static void turn_drum(PluginPlayer *player, float value) {
  plugin_player_begin_frame(player);
  take_preset(player, (uint32_t)lroundf(value));
  if (!plugin_player_has_choice(player)) return;
  plugin_player_choose(player);
  player->request.keeps_room = false;
}

void plugin_player_turn(PluginPlayer *player, KnobId id, float value) {
  const float before = player->seen[id];
  if (value == before || isnan(value)) return;
  if (id == KNOB_DRUM && is_restoring(player)) return; /* it will say where the knob stood */
  player->seen[id] = value;
  if (id == KNOB_DRUM) {
    if (!isnan(before) && value != player->restored_drum) turn_drum(player, value);
  } else if (id < KNOB_KEYS) {
    turn_key(player, id, knob_decimal(value));
  } else {
    turn_setting(player, id, value, isnan(before));
  }
}

void plugin_player_modulate(PluginPlayer *player, KnobId id, float offset) {
  if (!knob_is_modulated(id) || offset == player->offsets[id]) return;
  player->offsets[id] = offset;
  if (id == KNOB_GAIN) {
    set_gain(player, factor_of(player, id));
  } else if (knob_is_level(id)) {
    turn_level(player, id, factor_of(player, id), false);
  } else if (!isnan(player->built[id])) {
    player->moved[id] = true;
    plugin_player_move_parameter(player, player->ids[id], plugin_player_live_value(player, id));
  }
}

/* ---- MIDI ----------------------------------------------------------------------------------- */

static void act(PluginPlayer *player, const MidiAction *action, uint32_t ahead) {
  PlayerMessage message;
  if (player_message_from_midi(action, player->core.position + ahead, &message)) {
    humanize(&player->humanizer, player->midi.binding.head_radius, &message.event);
    push(player, &message);
  } else {
    take_preset(player, action->preset);
  }
}

void plugin_player_take(PluginPlayer *player, const MidiMessage *midi, uint32_t ahead) {
  MidiAction actions[MIDI_MOST_ACTIONS];
  const uint32_t count = midi_to_events_take(&player->midi, midi, actions);
  for (uint32_t i = 0; i < count; i++) act(player, &actions[i], ahead);
}

/* A negative place is the drum's own, as of a note. */
void plugin_player_strike(PluginPlayer *player, double velocity, double radius, double angle) {
  const MidiBinding *const binding = &player->midi.binding;
  const bool is_placed = radius >= 0;
  const PlayerMessage message = {
    .type = PLAYER_EVENT,
    .event = {.type = TABOR_EVENT_STRIKE,
              .velocity = velocity,
              .radius = is_placed ? radius * binding->head_radius : binding->radius,
              .angle = is_placed ? angle : binding->angle}};
  if (player->core.drum && player->count < PLUGIN_MESSAGES) plugin_player_act_now(player, &message);
}

bool plugin_player_is_full(const PluginPlayer *player) {
  return player->count > PLUGIN_MESSAGES / 2;
}
