/* SPDX-License-Identifier: MIT */
/* What is inside a player; for player.c and player_setup.c. */
#ifndef TABOR_HOST_PLAYER_STATE_H
#define TABOR_HOST_PLAYER_STATE_H

#include <pthread.h>

#include "base/spsc_queue.h"
#include "sound/fader.h"
#include "sound/frame_clock.h"
#include "sound/leaving.h"
#include "sound/player.h"
#include "sound/ring_out.h"
#include "sound/silencer.h"
#include "sound/tally.h"

#define PLAYER_PIECE RING_OUT_BLOCK /* frames computed at once at most, and looks at the end */
#define PLAYER_EVENTS 256           /* of one frame; further ones act at the next */
#define LOAD_BINS 256               /* of the load, in steps of 1 %; the last is for all above */

/* What the audio thread tells. Each is written by it alone, relaxed: numbers, not order. */
typedef struct PlayerMeters {
  _Atomic double peak[TABOR_MAX_MICS]; /* taken by the reader, who leaves 0 */
  _Atomic double loudest;              /* peak of all channels since the beginning */
  _Atomic double gain;
  atomic_ullong clipped, xruns, late, dropped, lost_frames;
  atomic_ullong strokes, solves, iterations, capped, recovered;
  atomic_uint newton_max, strikers;
  atomic_bool sleeping;
  atomic_uint load[LOAD_BINS];
  _Atomic double load_worst, load_worst_recent; /* the latter is taken by the reader */
  atomic_uint last_type;
  _Atomic double last_velocity, last_radius, last_angle, last_value;
  atomic_ullong last_frame;
} PlayerMeters;

struct Player {
  /* set up once */
  double rate;
  uint32_t channels, width;
  bool records, ends;
  SpscQueue sources[SOURCE_COUNT];
  SpscQueue recording;
  SpscQueue gone; /* drums that are done with */

  /* the audio thread's */
  TaborDrum *drum;
  Leaving leaving;
  Tally tally; /* of the drum before the last silence or change */
  uint64_t position, end;
  RingOut ring_out;
  Fader gain, expression;
  Silencer silencer;
  uint32_t mics[TABOR_MAX_MICS];
  uint32_t striker_count;
  TaborEvent events[PLAYER_EVENTS];
  uint32_t event_count;
  float *outputs[TABOR_MAX_MICS]; /* into planar, NULL for what nobody hears */
  float planar[TABOR_MAX_MICS][PLAYER_PIECE];
  double mixed[TABOR_MAX_MICS]
              [PLAYER_PIECE]; /* channels of all drums, then at their level, clipped */
  PlayerRecord *record;       /* the block being filled */

  /* shared */
  FrameClock clock;
  PlayerMeters meters;
  atomic_ullong played; /* = position, for others */
  atomic_bool over, halted, busy, has_thread;
  pthread_t thread; /* the audio thread, if has_thread */

  /* the user's thread */
  uint32_t load_seen[LOAD_BINS];
};

/* Gives each channel's microphone its samples in planar. */
void player_listen(Player *player) REALTIME;
/* The block for the recording is complete. */
void player_hand_over(Player *player) REALTIME;

#endif
