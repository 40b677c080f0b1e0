/* SPDX-License-Identifier: MIT */
#include "plugin/plugin_player_internal.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "drums/stereo_pair.h"

/* ---- beginning and end ---------------------------------------------------------------------- */

static bool bind_presets(PluginPlayer *player) {
  const uint32_t count = tabor_preset_count();
  player->bindings = calloc(count, sizeof *player->bindings);
  for (uint32_t i = 0; player->bindings && i < count; i++) {
    TaborDrumDef def;
    if (tabor_drum_def_preset(&def, tabor_preset(i)->name, NULL) != TABOR_OK) return false;
    midi_binding_make(&player->map, &def, &player->bindings[i]);
    if (strcmp(tabor_preset(i)->name, DEFAULT_PRESET) == 0) player->request.program = (int32_t)i;
  }
  player->chosen = player->chosen_before = player->request.program;
  return player->bindings != NULL;
}

static void prepare_knobs(PluginPlayer *player) {
  player->sound = player->mix = fader_at(0, player->rate);
  player->restored_drum = NAN;
  for (uint32_t i = 0; i < KNOB_COUNT; i++) {
    const KnobId id = (KnobId)i;
    player->ranges[i] = knob_range(id, &player->worker->base);
    player->seen[i] = NAN;
    player->levels[i] = fader_at(0, player->rate);
    if (i >= KNOB_SEEN) continue;
    player->seen[i] = player->ranges[i].fallback;
    player->given[i] = NAN;
    if (i >= KNOB_KEYS) continue;
    player->built[i] = NAN;
    if (knobs[i].kind == KNOB_LIVE) player->ids[i] = tabor_parameter_find(knobs[i].key)->id;
  }
}

static void start_over(PluginPlayer *player, const MidiBinding *binding) {
  midi_to_events_begin(&player->midi, &player->map, binding);
  player->humanizer.state = HUMANIZE_SEED;
}

/* A DrumWitnessFn. */
static void note_stroke(void *context, const PlayerMessage *message, uint64_t frame) REALTIME;
static void note_stroke(void *context, const PlayerMessage *message, uint64_t frame) {
  (void)frame;
  if (message->type == PLAYER_EVENT && message->event.type == TABOR_EVENT_STRIKE)
    ((PluginPlayer *)context)->struck = message->event;
}

bool plugin_player_take_struck(PluginPlayer *player, TaborEvent *stroke) {
  *stroke = player->struck;
  player->struck.type = 0;
  return stroke->type == TABOR_EVENT_STRIKE;
}

bool plugin_player_begin(PluginPlayer *player, ModelWorker *worker, double rate, bool stereo) {
  MidiBinding binding;
  player->base_gain = stereo ? knob_factor(&knobs[KNOB_LEVEL_PAIR], STEREO_GAIN_DB) : 1;
  drum_player_begin(&player->core, PLUGIN_MICS, player->base_gain);
  player->core.witness = note_stroke;
  player->core.context = player;
  player->worker = worker;
  player->rate = rate;
  player->stereo = stereo;
  player->map = worker->map;
  player->grip_id = tabor_parameter_find("hand.grip")->id;
  player->quality = TABOR_QUALITY_LIVE;
  player->request =
    (Request){.number = 1, .quality = TABOR_QUALITY_LIVE, .room = TABOR_ROOM_STUDIO};
  plugin_player_forget_turns(&player->request);
  prepare_knobs(player);
  midi_binding_make(&player->map, &worker->base, &binding);
  start_over(player, &binding);
  return bind_presets(player);
}

void plugin_player_end(PluginPlayer *player) {
  tabor_drum_destroy(player->core.drum);
  free(player->bindings);
}

/* ---- a new beginning ------------------------------------------------------------------------- */

/* The worker builds on these. */
static void keep_models(PluginPlayer *player) {
  uint32_t kept = 0;
  for (uint32_t i = 0; i < player->count; i++) {
    if (player->messages[i].message.type == PLAYER_MODEL) {
      player->messages[kept++] = player->messages[i];
    }
  }
  player->count = player->first_count = kept;
}

void plugin_player_rest(PluginPlayer *player) {
  const MidiBinding binding = player->midi.binding;
  drum_player_rest(&player->core);
  keep_models(player);
  start_over(player, &binding);
  for (uint32_t i = 0; i < KNOB_COUNT; i++) {
    if (!knob_is_level((KnobId)i)) continue;
    player->levels[i] = fader_at(player->levels[i].target, player->rate);
    player->waits[i] = 0;
  }
  player->request.strainer = player->request.grip = (KnobTurn){.is_turned = false};
  memset(player->moved, 0, sizeof player->moved); /* the drum has the values of its model */
  player->grip_moved = false;
  plugin_player_move_live(player);
}
