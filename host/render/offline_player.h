/* SPDX-License-Identifier: MIT */
/**
 * @file offline_player.h
 * Plays one drum or a kit for a rendering: the drum player run as fast as it can, interleaved
 * samples out.
 *
 * Plays strokes and a MIDI file, or a log. Other actions of a MIDI file act before strokes of their
 * frame. A preset change waits for its model. A room is that of the request's own drum throughout.
 */
#ifndef TABOR_HOST_OFFLINE_PLAYER_H
#define TABOR_HOST_OFFLINE_PLAYER_H

#include "drums/preset_models.h"
#include "files/trace_file.h"
#include "kit/kit_threads.h"
#include "render/render_request.h"
#include "sound/drum_player.h"

#define OFFLINE_BLOCK AUDIO_BLOCK

/** Numbers of events that the drum did not execute. */
typedef struct OfflineDrops {
  uint64_t strokes; /**< no slot was free for the stroke */
  uint64_t others;  /**< presses or moves without a target in play; too many hands */
} OfflineDrops;

/** A swap that the drum may still need. */
typedef struct SentSwap {
  TaborSwap *swap;
  struct SentSwap *next;
} SentSwap;

typedef struct OfflinePlayer {
  RenderRequest *request;
  TaborDrum *drum; /**< or a kit */
  TaborKit *kit;
  KitThreads *threads; /**< of the kit, or NULL */
  DrumPlayer core;     /**< of a drum, with an output for each of the first drum's microphones */
  RoomMix room;
  PresetModels presets;
  TaborModel *models[TABOR_KIT_DRUMS]; /**< that each drum has, or will have after the newest swap;
                                          borrowed */
  TaborModel *built[TABOR_KIT_DRUMS];  /**< the same, if it is of a log's; owned */
  SentSwap *swaps;
  size_t next_event,
    next_item;         /**< index into the strokes, and into the song; of a kit, into its song */
  size_t next_message; /**< index into the log */
  uint32_t position;   /**< frames played */
  double peak;         /**< largest absolute sample */
  double computing;    /**< processor time used by the drum [s] */
  Outcome outcome;     /**< of building models of presets */
  float input[DRUM_PLAYER_BLOCK];                    /**< of the next block */
  double interleaved[MOST_CHANNELS * OFFLINE_BLOCK]; /**< the newest block */
} OfflinePlayer;

/** Builds model and drum. Free with offline_player_free(), whatever the outcome. */
Outcome offline_player_open(OfflinePlayer *player, RenderRequest *request);
/** Plays @p frames frames, at most OFFLINE_BLOCK, into interleaved. */
Outcome offline_player_play(OfflinePlayer *player, uint32_t frames);
/** Plays one frame at a time and adds a row to @p trace after each. The samples are the same. */
Outcome offline_player_play_traced(OfflinePlayer *player, uint32_t frames, TraceFile *trace);
/** What has been dropped so far. */
OfflineDrops offline_player_drops(const OfflinePlayer *player);
void offline_player_free(OfflinePlayer *player);

#endif
