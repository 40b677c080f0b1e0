/* SPDX-License-Identifier: MIT */
/**
 * @file kit_player.h
 * A kit played block by block for a device: a song's events and live ones, each at its frame, the mix out.
 */
#ifndef TABOR_HOST_KIT_PLAYER_H
#define TABOR_HOST_KIT_PLAYER_H

#include "base/message.h"
#include "base/spsc_queue.h"
#include "kit/kit_samples.h"
#include "kit/kit_song.h"
#include "sound/frame_clock.h"
#include "sound/recording.h"

#define KIT_PLAYER_PIECE 256  /**< most frames at once */
#define KIT_PLAYER_EVENTS 256 /**< most events of a piece; further ones act in the next */

typedef struct KitPlayerSetup {
  TaborKit *kit;       /**< outlives the player, as does the song */
  const KitSong *song; /**< may have no events */
  KitSamples *samples; /**< read; for the audio thread alone from now on */
  double rate, gain;   /**< [Hz]; factor */
  uint32_t width;      /**< channels of the device */
  uint32_t buffer;     /**< frames of a block, as far as they are known */
  uint64_t end;        /**< frame at which it is over; 0: never */
  bool records;
} KitPlayerSetup;

typedef struct KitPlayer {
  KitPlayerSetup setup;
  SpscQueue live; /**< of LiveEvent */
  Recording recording;
  FrameClock clock;
  size_t next; /**< event of the song */
  uint64_t position;
  TaborKitEvent events[KIT_PLAYER_EVENTS];
  float sound[2][KIT_PLAYER_PIECE];
  atomic_bool over;
  _Atomic double peak, worst_load, busy; /**< busy: computing time so far [s] */
  atomic_ullong played, clipped, gaps;
} KitPlayer;

typedef struct KitPlayerStatus {
  double seconds;    /**< played */
  double load;       /**< computing time in a second of sound */
  double worst_load; /**< of a block */
  double peak;
  uint64_t clipped, gaps, dropped;
} KitPlayerStatus;

/** SET-UP. Free with kit_player_end(), whatever the outcome. */
Outcome kit_player_begin(KitPlayer *player, const KitPlayerSetup *setup);
void kit_player_end(KitPlayer *player);
/** One thread: plays an event that came at @p time [s of CLOCK_MONOTONIC]. */
void kit_player_send(KitPlayer *player, double time, const TaborKitEvent *event) REALTIME;
/** AUDIO: as BackendClient.process of play/backend.h. */
bool kit_player_process(KitPlayer *player, float *samples, uint32_t frames, double now,
                        bool gap) REALTIME;
/** ANY. */
bool kit_player_is_over(const KitPlayer *player);
void kit_player_status(const KitPlayer *player, KitPlayerStatus *status);

#endif
