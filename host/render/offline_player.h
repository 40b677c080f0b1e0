/* SPDX-License-Identifier: MIT */
/**
 * @file offline_player.h
 * One drum being played: strokes in, interleaved samples out.
 *
 * What a MIDI file does beside its strokes acts at its frame, before these: a gain is reached over
 * 5 ms; silence is silencer.h's; another preset is another drum, beside which the one before rings out.
 */
#ifndef TABOR_HOST_OFFLINE_PLAYER_H
#define TABOR_HOST_OFFLINE_PLAYER_H

#include "drums/preset_drums.h"
#include "files/trace_file.h"
#include "render/render_request.h"
#include "sound/fader.h"
#include "sound/leaving.h"
#include "sound/silencer.h"
#include "sound/tally.h"

#define OFFLINE_BLOCK AUDIO_BLOCK

/** Events that the drum did not carry out. */
typedef struct OfflineDrops {
  uint64_t strokes; /**< nothing was free to strike them */
  uint64_t others;  /**< presses or moves of what is not in play, and hands too many */
} OfflineDrops;

typedef struct OfflinePlayer {
  RenderRequest *request;
  TaborDrum *drum;
  PresetDrums presets;
  Leaving leaving;
  Tally tally;                  /**< of the drum before the last silence or change */
  size_t next_event, next_item; /**< of the strokes, of the song */
  uint32_t position;            /**< frames played */
  double peak;                  /**< largest sample in size */
  double computing;             /**< processor time that the drum took [s] */
  OfflineDrops drops;
  Fader expression; /**< factor beside the request's gain */
  Silencer silencer;
  uint32_t mics[MOST_CHANNELS]; /**< of each channel, in the model of now */
  float planar[TABOR_MAX_MICS][OFFLINE_BLOCK];
  double sound[MOST_CHANNELS][OFFLINE_BLOCK];        /**< of all drums, before their gain */
  double interleaved[MOST_CHANNELS * OFFLINE_BLOCK]; /**< the newest block */
} OfflinePlayer;

/** Builds model and drum. Free with offline_player_free(), whatever the outcome. */
Outcome offline_player_open(OfflinePlayer *player, RenderRequest *request);
/** Plays @p frames frames, at most OFFLINE_BLOCK, into interleaved. */
Outcome offline_player_play(OfflinePlayer *player, uint32_t frames);
/** The same one frame at a time, with a row of @p trace after each. The samples are the same. */
Outcome offline_player_play_traced(OfflinePlayer *player, uint32_t frames, TraceFile *trace);
void offline_player_free(OfflinePlayer *player);

#endif
