/* SPDX-License-Identifier: MIT */
/* Internals of a player, for player.c and player_setup.c. */
#ifndef TABOR_HOST_PLAYER_STATE_H
#define TABOR_HOST_PLAYER_STATE_H

#include <pthread.h>

#include "base/spsc_queue.h"
#include "sound/drum_player.h"
#include "sound/frame_clock.h"
#include "sound/player.h"
#include "sound/ring_out.h"

#define PLAYER_PIECE RING_OUT_BLOCK /* most frames computed at once, between checks of the end */
#define LOAD_BINS 256 /* load histogram in steps of 1 %; the last bin holds all higher loads */

/* Meters, written by the audio thread with relaxed order: readers need the numbers, not their
 * order. */
typedef struct PlayerMeters {
  _Atomic double peak[TABOR_MAX_MICS]; /* the reader takes the value and leaves 0 */
  _Atomic double loudest;              /* peak of all channels since the start */
  _Atomic double gain;
  atomic_ullong clipped, xruns, late, dropped;
  atomic_ullong strokes, solves, iterations, capped, recovered;
  atomic_uint newton_max, strikers;
  atomic_bool sleeping;
  atomic_uint load[LOAD_BINS];
  _Atomic double load_worst, load_worst_recent; /* the reader takes the latter, leaves 0 */
  atomic_uint last_type;
  _Atomic double last_velocity, last_radius, last_angle, last_value;
  atomic_ullong last_frame;
} PlayerMeters;

struct Player {
  /* set up once */
  double rate;
  uint32_t width, channels;
  uint32_t mics[TABOR_MAX_MICS]; /* output of the drum for each channel */
  bool logs, ends;
  SpscQueue sources[SOURCE_COUNT];
  SpscQueue log; /* of PlayerMessage */

  /* audio thread */
  DrumPlayer core;
  RoomMix room;
  uint64_t end;
  RingOut ring_out;
  double mixed[TABOR_MAX_MICS][PLAYER_PIECE]; /* sound of each channel, clipped */
  Recording recording;

  /* shared */
  FrameClock clock;
  PlayerMeters meters;
  atomic_ullong played; /* = the core's position, for other threads */
  atomic_bool over, halted, busy, has_thread;
  pthread_t thread; /* the audio thread, if has_thread */

  /* user's thread */
  uint32_t load_seen[LOAD_BINS];
};

#endif
