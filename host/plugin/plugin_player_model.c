/* SPDX-License-Identifier: MIT */
/* Changes the model of a player while its drum sounds. */
#include <math.h>
#include <string.h>

#include "plugin/plugin_player_internal.h"

static void take_restoration(PluginPlayer *player, const Reply *reply) {
  player->request.restoration = reply->restoration;
  player->request.program = MODEL_WORKER_NO_PROGRAM;
  plugin_player_forget_choice(player);
  atomic_store(&player->worker->program, MODEL_WORKER_NO_PROGRAM);
  plugin_player_forget_turns(&player->request);
  for (uint32_t i = 0; i < KNOB_KEYS; i++) {
    if (!isnan(reply->seen[i])) player->seen[i] = reply->seen[i];
  }
  player->restored_drum = reply->seen[KNOB_DRUM];
  if (isnan(player->restored_drum)) player->seen[KNOB_DRUM] = NAN; /* it is where it stands next */
  player->given[KNOB_DRUM] = NAN;
}

static void read_model(PluginPlayer *player, const Reply *reply) {
  player->built_grip = reply->def.hand.grip;
  player->strainer = reply->binding.strainer;
  memcpy(player->built, reply->built, sizeof player->built);
}

/* The engine carries what was moved over to the new model; there it is put right. */
void plugin_player_move_live(PluginPlayer *player) {
  for (uint32_t i = 0; i < KNOB_KEYS; i++) {
    if (knobs[i].kind != KNOB_LIVE || isnan(player->built[i])) continue;
    const double value = plugin_player_live_value(player, (KnobId)i);
    const bool differs = value != player->built[i];
    if (differs || player->moved[i]) plugin_player_move_parameter(player, player->ids[i], value);
    player->moved[i] = differs;
  }
  const double grip = knob_turned_or(player->request.grip, player->built_grip);
  if (player->grip_moved) plugin_player_move_parameter(player, player->grip_id, grip);
  player->grip_moved = grip != player->built_grip;
}

static void change_model(PluginPlayer *player, const Reply *reply) {
  const PlayerMessage message = {
    .type = PLAYER_MODEL,
    .strikers = reply->def.striker_count,
    .event = {.type = reply->begins_anew ? TABOR_EVENT_REPLACE : TABOR_EVENT_SWAP,
              .swap = reply->swap}};
  plugin_player_act_now(player, &message);
  player->swap = reply->swap;
}

/* Unless something else was asked for meanwhile. */
static void note_given(PluginPlayer *player, const Reply *reply) {
  if (reply->number != player->request.number) return;
  memcpy(player->given, reply->given, sizeof reply->given);
}

bool plugin_player_take_given(PluginPlayer *player, KnobId id, float *asked, float *given) {
  *asked = player->seen[id];
  *given = player->given[id];
  player->given[id] = NAN;
  return !isnan(*given) && *given != *asked;
}

static void begin_anew(PluginPlayer *player) {
  memset(player->moved, 0, sizeof player->moved);
  player->grip_moved = false;
}

/* Messages may be meant for a still newer preset already. */
static bool speaks_of(const PluginPlayer *player, const Reply *reply) {
  return player->chosen == MODEL_WORKER_NO_PROGRAM || player->chosen == reply->program;
}

static void land(PluginPlayer *player, const Reply *reply) {
  if (!reply->is_news) return;
  if (reply->cancelled) {
    player->asked = 0; /* no request has this number: ask again */
    return;
  }
  player->answered = reply->number;
  player->answered_restoration = reply->restoration;
  if (reply->restoration != player->request.restoration) take_restoration(player, reply);
  if (reply->failed) return;
  note_given(player, reply);
  if (reply->begins_anew) begin_anew(player);
  if (reply->drum) {
    drum_player_set_drum(&player->core, reply->drum, reply->def.striker_count);
  }
  if (reply->swap) change_model(player, reply);
  if (reply->room) drum_player_set_room(&player->core, reply->room);
  read_model(player, reply);
  if (speaks_of(player, reply)) {
    player->midi.binding = reply->binding;
    plugin_player_place_strokes(player);
  }
  plugin_player_move_live(player);
}

static bool wants(const PluginPlayer *player) {
  return player->request.number != player->asked ||
         atomic_load(&player->worker->restoration) != player->asked_restoration;
}

void plugin_player_receive(PluginPlayer *player) {
  const Reply *const reply = model_worker_reply(player->worker);
  if (!reply) return;
  land(player, reply);
  builder_accept(&player->worker->builder);
}

static bool is_littered(const PluginPlayer *player) {
  return player->swap && tabor_swap_done(player->swap);
}

bool plugin_player_ask(PluginPlayer *player) {
  if (wants(player)) builder_outdate(&player->worker->builder);
  if (!builder_is(&player->worker->builder, BUILDER_IDLE) ||
      !(wants(player) || is_littered(player)))
    return false;
  player->asked = player->request.number;
  player->asked_restoration = atomic_load(&player->worker->restoration);
  player->swap = NULL; /* the worker may clear it up now */
  memcpy(player->request.seen, player->seen, sizeof player->request.seen);
  model_worker_ask(player->worker, &player->request);
  return true;
}

bool plugin_player_is_restored(const PluginPlayer *player) {
  return player->core.drum &&
         player->answered_restoration == atomic_load(&player->worker->restoration);
}

bool plugin_player_is_ready(const PluginPlayer *player) {
  return plugin_player_is_restored(player) && player->answered == player->request.number;
}

static bool is_room_silent(const RoomMix *mix) {
  return !mix || !mix->room || (tabor_room_is_silent(mix->room) && !room_mix_is_fading(mix));
}

bool plugin_player_is_silent(const PluginPlayer *player) {
  const DrumPlayer *const core = &player->core;
  if (player->count > 0 || core->count > 0 || core->has_next || core->former) return false;
  return is_room_silent(core->room) && (!core->drum || tabor_drum_is_silent(core->drum));
}

bool plugin_player_is_settled(const PluginPlayer *player) {
  return builder_is(&player->worker->builder, BUILDER_IDLE) && !wants(player);
}
