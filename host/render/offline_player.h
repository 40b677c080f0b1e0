/* SPDX-License-Identifier: MIT */
/**
 * @file offline_player.h
 * Plays one drum for a rendering: strokes in, interleaved samples out.
 *
 * Other actions of a MIDI file act at their frame, before strokes of that frame. A gain is reached over
 * 5 ms. A silence works as in silencer.h. A preset change starts a new drum, and the old one fades out
 * beside it. A room is that of the request's own drum throughout.
 */
#ifndef TABOR_HOST_OFFLINE_PLAYER_H
#define TABOR_HOST_OFFLINE_PLAYER_H

#include "drums/preset_drums.h"
#include "files/trace_file.h"
#include "render/render_request.h"
#include "sound/fader.h"
#include "sound/leaving.h"
#include "sound/room_mix.h"
#include "sound/silencer.h"
#include "sound/tally.h"

#define OFFLINE_BLOCK AUDIO_BLOCK

/** Numbers of events that the drum did not execute. */
typedef struct OfflineDrops {
  uint64_t strokes; /**< no slot was free for the stroke */
  uint64_t others;  /**< presses or moves without a target in play; too many hands */
} OfflineDrops;

typedef struct OfflinePlayer {
  RenderRequest *request;
  TaborDrum *drum;
  PresetDrums presets;
  Leaving leaving;
  Tally tally;                  /**< counts from before the last silence or drum change */
  size_t next_event, next_item; /**< index into the strokes, and into the song */
  uint32_t position;            /**< frames played */
  double peak;                  /**< largest absolute sample */
  double computing;             /**< processor time used by the drum [s] */
  OfflineDrops drops;
  Fader expression; /**< factor on top of the request's gain */
  Silencer silencer;
  RoomMix room;
  uint32_t channels;            /**< the request's, then the room's feeds */
  uint32_t mics[MOST_CHANNELS]; /**< of each channel, in the current model */
  float planar[TABOR_MAX_MICS][OFFLINE_BLOCK];
  double sound[MOST_CHANNELS][OFFLINE_BLOCK];        /**< sum of all drums, before the gain */
  double interleaved[MOST_CHANNELS * OFFLINE_BLOCK]; /**< the newest block */
} OfflinePlayer;

/** Builds model and drum. Free with offline_player_free(), whatever the outcome. */
Outcome offline_player_open(OfflinePlayer *player, RenderRequest *request);
/** Plays @p frames frames, at most OFFLINE_BLOCK, into interleaved. */
Outcome offline_player_play(OfflinePlayer *player, uint32_t frames);
/** Plays one frame at a time and adds a row to @p trace after each. The samples are the same. */
Outcome offline_player_play_traced(OfflinePlayer *player, uint32_t frames, TraceFile *trace);
void offline_player_free(OfflinePlayer *player);

#endif
