/* SPDX-License-Identifier: MIT */
#include "render/offline_player.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "drums/drum_args.h"
#include "drums/model_build.h"
#include "kit/kit_build.h"
#include "platform/clock.h"
#include "sound/room_create.h"

static Outcome open_drum(OfflinePlayer *player) {
  const RenderRequest *const request = player->request;
  Outcome outcome = drum_create(&request->def, &request->model, request->shared, &player->drum);
  if (outcome != OUTCOME_OK) return outcome;
  player->models[0] = (TaborModel *)tabor_drum_model(player->drum);
  drum_player_begin(&player->core, request->def.mic_count, request->gain);
  outcome = room_create(&request->def, request->model.sample_rate, &player->room);
  if (outcome != OUTCOME_OK) return outcome;
  drum_player_set_room(&player->core, &player->room);
  drum_player_set_drum(&player->core, player->drum, request->def.striker_count);
  if (request->input.pressure) player->core.input = player->input;
  player->core.input_mic = request->input.mic;
  return OUTCOME_OK;
}

static Outcome create_kit(OfflinePlayer *player, TaborModel *const *models) {
  TaborError error;
  if (tabor_kit_create(player->request->kit, models, &player->kit, &error) == TABOR_OK) {
    return OUTCOME_OK;
  }
  return report_engine_error(&error);
}

static Outcome build_kit(OfflinePlayer *player) {
  const RenderRequest *const request = player->request;
  TaborModel *models[TABOR_KIT_DRUMS] = {NULL};
  if (request->kit_models) return create_kit(player, request->kit_models);
  Outcome outcome = kit_models_build(request->kit, &request->model, request->threads, models);
  if (outcome == OUTCOME_OK) outcome = create_kit(player, models);
  kit_models_release(models);
  return outcome;
}

/* Samples are in the mix alone, not in the drums' parts of it. */
static Outcome open_kit(OfflinePlayer *player) {
  RenderRequest *const request = player->request;
  const double rate = request->model.sample_rate;
  Outcome outcome = build_kit(player);
  if (outcome == OUTCOME_OK && !request->split) outcome = kit_sample_files_read(player->kit);
  if (outcome != OUTCOME_OK) return outcome;
  for (uint32_t i = 0; i < request->kit->drum_count; i++) {
    player->models[i] = (TaborModel *)tabor_drum_model(tabor_kit_drum(player->kit, i));
  }
  player->threads = kit_threads_begin(request->threads, false, NULL);
  kit_threads_serve(player->threads, player->kit);
  drum_player_begin(&player->core, 2 + 2 * request->kit->drum_count, request->gain);
  drum_player_set_kit(&player->core, player->kit, rate);
  return OUTCOME_OK;
}

Outcome offline_player_open(OfflinePlayer *player, RenderRequest *request) {
  memset(player, 0, sizeof *player);
  player->request = request;
  player->presets.options = &request->model;
  const Outcome outcome = request->kit ? open_kit(player) : open_drum(player);
  if (outcome != OUTCOME_OK) return outcome;
  for (uint32_t i = 0; i < request->channels; i++) {
    player->core.heard |= UINT64_C(1) << request->mics[i];
  }
  return OUTCOME_OK;
}

/* ---- changes of the preset ---- */

static void free_done(OfflinePlayer *player, bool all) {
  for (SentSwap **link = &player->swaps; *link;) {
    SentSwap *const sent = *link;
    if (!all && !tabor_swap_done(sent->swap)) {
      link = &sent->next;
      continue;
    }
    *link = sent->next;
    tabor_swap_destroy(sent->swap);
    free(sent);
  }
}

static Outcome prepare_swap(OfflinePlayer *player, uint32_t drum, TaborModel *model,
                            TaborSwap **swap) {
  SentSwap *const sent = calloc(1, sizeof *sent);
  TaborError error;
  if (!sent) return fail_memory();
  if (tabor_swap_create(player->models[drum], model, &sent->swap, &error) != TABOR_OK) {
    free(sent);
    return report_engine_error(&error);
  }
  sent->next = player->swaps;
  player->swaps = sent;
  player->models[drum] = model;
  *swap = sent->swap;
  return OUTCOME_OK;
}

/* Completes the message that changes the drum to @p model. */
static Outcome change_model(OfflinePlayer *player, TaborModel *model, PlayerMessage *message) {
  free_done(player, false);
  const Outcome outcome = prepare_swap(player, message->drum, model, &message->event.swap);
  if (outcome != OUTCOME_OK) return outcome;
  message->strikers = tabor_model_definition(model)->striker_count;
  if (!player->kit) drum_keep_mics(&player->request->def, model, message->event.swap);
  return outcome;
}

static Outcome change_preset(OfflinePlayer *player, uint32_t preset, PlayerMessage *message) {
  TaborModel *model = NULL;
  message->type = PLAYER_MODEL;
  message->event.type = TABOR_EVENT_REPLACE;
  const Outcome outcome = preset_models_find(&player->presets, preset, &model);
  return outcome == OUTCOME_OK ? change_model(player, model, message) : outcome;
}

/* Drum and swaps keep their own references to models. */
static Outcome change_logged(OfflinePlayer *player, PlayerMessage *message) {
  const LogDrum *const drum = player->request->replay.models[message->model - 1];
  TaborModelOptions options = player->request->model;
  TaborModel *model = NULL;
  options.quality = drum->quality;
  Outcome outcome = model_build(&drum->def, &options, &model);
  if (outcome == OUTCOME_OK) outcome = change_model(player, model, message);
  TaborModel **const built = &player->built[message->drum];
  TaborModel *const unused = outcome == OUTCOME_OK ? *built : model;
  if (outcome == OUTCOME_OK) *built = model;
  tabor_model_release(unused);
  return outcome;
}

/* ---- messages ---- */

static const MidiSongItem *next_item(const OfflinePlayer *player) {
  const MidiSong *const song = &player->request->song;
  return player->next_item < song->count ? &song->items[player->next_item] : NULL;
}

static const TaborEvent *next_event(const OfflinePlayer *player) {
  const Strokes *const strokes = &player->request->strokes;
  return player->next_event < strokes->count ? &strokes->events[player->next_event] : NULL;
}

static bool take_item(OfflinePlayer *player, const MidiSongItem *item, PlayerMessage *message) {
  player->next_item++;
  if (player_message_from_midi(&item->action, item->frame, message)) return true;
  player->outcome = change_preset(player, item->action.preset, message);
  return player->outcome == OUTCOME_OK;
}

static bool take_logged(OfflinePlayer *player, uint64_t end, PlayerMessage *message) {
  const Replay *const replay = &player->request->replay;
  const size_t next = player->next_message;
  if (next == replay->count || replay->messages[next].frame >= end) return false;
  *message = replay->messages[next];
  player->next_message++;
  if (message->type == PLAYER_MODEL) player->outcome = change_logged(player, message);
  return player->outcome == OUTCOME_OK;
}

static bool take_of_kit(OfflinePlayer *player, uint64_t end, PlayerMessage *message) {
  const KitSong *const song = &player->request->kit_song;
  if (player->next_item == song->count) return false;
  const TaborKitEvent *const next = &song->events[player->next_item];
  if (next->event.frame >= end) return false;
  *message = player_message_from_kit(next);
  player->next_item++;
  return true;
}

/* A DrumSourceFn. */
static bool take_message(void *source, uint64_t end, PlayerMessage *message) {
  OfflinePlayer *const player = source;
  const MidiSongItem *const item = next_item(player);
  const TaborEvent *const event = next_event(player);
  if (player->outcome != OUTCOME_OK) return false;
  if (player->request->replays) return take_logged(player, end, message);
  if (player->kit) return take_of_kit(player, end, message);
  if (item && item->frame < end && (!event || item->frame <= event->frame)) {
    return take_item(player, item, message);
  }
  if (!event || event->frame >= end) return false;
  *message = (PlayerMessage){.frame = event->frame, .type = PLAYER_EVENT, .event = *event};
  player->next_event++;
  return true;
}

OfflineDrops offline_player_drops(const OfflinePlayer *player) {
  TaborStatistics statistics;
  drum_player_statistics(&player->core, &statistics);
  const uint64_t strokes = player->core.strokes - statistics.strikes;
  return (OfflineDrops){.strokes = strokes, .others = statistics.dropped_events - strokes};
}

/* ---- sound ---- */

/* Frames from @p at on in the block. */
static void interleave(OfflinePlayer *player, uint32_t at, uint32_t frames) {
  const RenderRequest *const request = player->request;
  const uint32_t channels = request->channels;
  for (uint32_t frame = 0; frame < frames; frame++) {
    for (uint32_t channel = 0; channel < channels; channel++) {
      const double sample = (double)player->core.sound[request->mics[channel]][frame];
      player->interleaved[(at + frame) * channels + channel] = sample;
      player->peak = fmax(player->peak, fabs(sample));
    }
  }
}

/* Of a kit that of all its threads. */
static double computing_time(const OfflinePlayer *player) {
  return player->kit ? process_seconds() : processor_seconds();
}

/* Frames @p at to @p end of the block. */
static Outcome play(OfflinePlayer *player, uint32_t at, uint32_t end) {
  while (at < end && player->outcome == OUTCOME_OK) {
    const uint32_t left = end - at, frames = left < DRUM_PLAYER_BLOCK ? left : DRUM_PLAYER_BLOCK;
    if (player->core.input) {
      sound_input_take(&player->request->input, player->position, frames, player->input);
    }
    const double start = computing_time(player);
    drum_player_play(&player->core, take_message, player, frames);
    player->computing += computing_time(player) - start;
    interleave(player, at, frames);
    player->position += frames;
    at += frames;
  }
  return player->outcome;
}

Outcome offline_player_play(OfflinePlayer *player, uint32_t frames) {
  return play(player, 0, frames);
}

Outcome offline_player_play_traced(OfflinePlayer *player, uint32_t frames, TraceFile *trace) {
  const double rate = player->request->model.sample_rate;
  Outcome outcome = OUTCOME_OK;
  for (uint32_t frame = 0; outcome == OUTCOME_OK && frame < frames; frame++) {
    outcome = play(player, frame, frame + 1);
    if (outcome == OUTCOME_OK) {
      outcome = trace_file_row(trace, player->position / rate, player->drum);
    }
  }
  return outcome;
}

void offline_player_free(OfflinePlayer *player) {
  kit_threads_end(player->threads);
  room_mix_free(&player->room);
  tabor_drum_destroy(player->drum);
  tabor_kit_destroy(player->kit);
  player->drum = NULL;
  player->kit = NULL;
  free_done(player, true);
  for (uint32_t i = 0; i < TABOR_KIT_DRUMS; i++) tabor_model_release(player->built[i]);
  preset_models_free(&player->presets);
}
