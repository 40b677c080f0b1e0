/* SPDX-License-Identifier: MIT */
/* Changes the model of a player while its drum sounds. */
#include <math.h>
#include <string.h>

#include "lv2/plugin_player_internal.h"

#define CROSS_HOLD 0.008 /* [s] after which a swapped drum is heard at all usual microphones */

static void take_restoration(PluginPlayer *player, const Reply *reply) {
  player->request.restoration = reply->restoration;
  player->request.program = MODEL_WORKER_NO_PROGRAM;
  plugin_player_forget_choice(player);
  atomic_store(&player->worker->program, MODEL_WORKER_NO_PROGRAM);
  plugin_player_forget_turns(&player->request);
  for (uint32_t i = 0; i < KNOB_KEYS; i++) {
    if (!isnan(reply->seen[i])) player->seen[i] = reply->seen[i];
  }
}

/* Both sides of a drum without a stereo pair are heard by its first microphone. */
static void attend(PluginPlayer *player, const Reply *reply) {
  for (uint32_t i = 0; i < PLUGIN_MICS; i++) {
    const bool may_replace = player->stereo && (i == PLUGIN_LEFT || i == PLUGIN_RIGHT);
    player->mics[i] = reply->mics[i] == MODEL_WORKER_NO_MIC && may_replace ? 0 : reply->mics[i];
  }
}

static void read_model(PluginPlayer *player, const Reply *reply) {
  attend(player, reply);
  player->striker_count = reply->def.striker_count;
  player->built_grip = reply->def.hand.grip;
  player->strainer = reply->binding.strainer;
  memcpy(player->built, reply->built, sizeof player->built);
}

/* The value that a live knob is to have: as MIDI says, else the knob, else the drum. */
static double live_value(const PluginPlayer *player, KnobId id) {
  if (id == KNOB_STRAINER && !isnan(player->request.strainer)) return player->request.strainer;
  if (!isnan(player->request.values[id])) return player->request.values[id];
  return id == KNOB_STRAINER ? player->strainer : player->built[id];
}

/* The engine carries what was moved over to the new model; there it is put right. */
void plugin_player_move_live(PluginPlayer *player) {
  for (uint32_t i = 0; i < KNOB_KEYS; i++) {
    if (knobs[i].kind != KNOB_LIVE || isnan(player->built[i])) continue;
    const double value = live_value(player, (KnobId)i);
    const bool differs = value != player->built[i];
    if (differs || player->moved[i]) plugin_player_move_parameter(player, player->ids[i], value);
    player->moved[i] = differs;
  }
  const double grip = isnan(player->request.grip) ? player->built_grip : player->request.grip;
  if (player->grip_moved) plugin_player_move_parameter(player, player->grip_id, grip);
  player->grip_moved = grip != player->built_grip;
}

/* There is room: a request empties it, and until the next two drums at most join those that sound. */
void plugin_player_throw_away(PluginPlayer *player, TaborDrum *drum) {
  uint32_t i = 0;
  if (!drum) return;
  while (i + 1 < MODEL_WORKER_TRASH && player->trash[i]) i++;
  player->trash[i] = drum;
}

void plugin_player_end_crossing(PluginPlayer *player) {
  plugin_player_throw_away(player, player->crossing.drum);
  player->crossing.drum = NULL;
}

void plugin_player_clear_up(PluginPlayer *player) {
  TaborDrum *drum;
  while ((drum = leaving_take(&player->leaving)) != NULL) plugin_player_throw_away(player, drum);
}

void plugin_player_cut_others(PluginPlayer *player) {
  plugin_player_end_crossing(player);
  leaving_cut(&player->leaving);
  plugin_player_clear_up(player);
}

/* A copy of the drum goes on as it was. */
static void copy_drum(PluginPlayer *player, const Reply *reply) {
  tabor_drum_state_save(player->drum, reply->state);
  const size_t size = tabor_drum_state_size(reply->spare);
  const bool copied = tabor_drum_state_load(reply->spare, reply->state, size) == TABOR_OK;
  plugin_player_end_crossing(player);
  if (copied && !tabor_drum_is_silent(player->drum)) {
    player->crossing = (Crossing){.drum = reply->spare,
                                  .hold = (uint32_t)(CROSS_HOLD * player->rate),
                                  .fade = (uint32_t)(CROSS_FADE * player->rate)};
  } else {
    plugin_player_throw_away(player, reply->spare);
  }
}

static void swap(PluginPlayer *player, const Reply *reply) {
  const TaborEvent event = {.type = TABOR_EVENT_SWAP, .swap = reply->swap};
  if (reply->spare) copy_drum(player, reply);
  tabor_drum_process(player->drum, &event, 1, NULL, 0);
  player->swap = reply->swap;
}

static void replace(PluginPlayer *player, TaborDrum *drum) {
  TaborDrum *const before = player->drum;
  plugin_player_end_crossing(player);
  if (before) {
    plugin_player_throw_away(player,
                             leaving_add(&player->leaving, before, player->mics, PLUGIN_MICS));
  }
  player->drum = drum;
  memset(player->moved, 0, sizeof player->moved);
  player->grip_moved = false;
}

/* Messages may be meant for a still newer preset already. */
static bool speaks_of(const PluginPlayer *player, const Reply *reply) {
  return player->chosen == MODEL_WORKER_NO_PROGRAM || player->chosen == reply->program;
}

static void land(PluginPlayer *player, const Reply *reply) {
  if (!reply->is_news) return;
  player->answered = reply->number;
  player->answered_restoration = reply->restoration;
  if (reply->restoration != player->request.restoration) take_restoration(player, reply);
  if (reply->failed) return;
  if (reply->drum) replace(player, reply->drum);
  if (reply->swap) swap(player, reply);
  if (reply->begins_anew) silencer_forget(&player->silencer);
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
  model_worker_accept(player->worker);
}

static bool is_littered(const PluginPlayer *player) {
  return player->trash[0] || (player->swap && tabor_swap_done(player->swap));
}

bool plugin_player_ask(PluginPlayer *player) {
  if (!model_worker_is_idle(player->worker) || !(wants(player) || is_littered(player)))
    return false;
  player->asked = player->request.number;
  player->asked_restoration = atomic_load(&player->worker->restoration);
  player->swap = NULL; /* the worker may clear it up now */
  memcpy(player->request.seen, player->seen, sizeof player->request.seen);
  memcpy(player->request.trash, player->trash, sizeof player->request.trash);
  memset(player->trash, 0, sizeof player->trash);
  model_worker_ask(player->worker, &player->request);
  return true;
}

bool plugin_player_is_ready(const PluginPlayer *player) {
  return player->drum && player->answered == player->request.number &&
         player->answered_restoration == atomic_load(&player->worker->restoration);
}

bool plugin_player_is_settled(const PluginPlayer *player) {
  return model_worker_is_idle(player->worker) && !wants(player);
}
