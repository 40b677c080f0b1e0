/* SPDX-License-Identifier: MIT */
/* Live values: parameters that may move while a drum rings (step/live_params.h). */
#ifndef TB_LIVE_VALUES_H
#define TB_LIVE_VALUES_H

#include <math.h>

#include "tabor/tabor.h"

#define TB_LIVE_TIME 0.005    /* [s] that a move takes */
#define TB_LIVE_MOST_GAIN 1e6 /* 120 dB */

typedef enum TbLiveIndex {
  TB_LIVE_TENSION,
  TB_LIVE_DAMPING_0,
  TB_LIVE_DAMPING_1,
  TB_LIVE_STRAINER,
  TB_LIVE_MUFFLE, /* of the batter head; the resonant head's is next */
  TB_LIVE_MUFFLE_RESONANT,
  TB_LIVE_FULL_SCALE,
  TB_LIVE_GRIP,    /* of hands that press a stick */
  TB_LIVE_OPENING, /* of a hi-hat */
  TB_LIVE_GAIN,    /* of the first microphone; the others follow in order */
  TB_LIVE_COUNT = TB_LIVE_GAIN + TABOR_MAX_MICS
} TbLiveIndex;

typedef struct TbLiveParam {
  double now, target, step; /* step per sample while `left` samples remain */
  uint32_t left;
} TbLiveParam;

/* Starts a linear move of `samples` samples; 0: the value is there at once. Audio-safe, as all
 * here. */
static inline void tb_live_move(TbLiveParam *live, double target, uint32_t samples) {
  live->target = target;
  live->left = samples;
  if (samples == 0) live->now = target;
  live->step = samples > 0 ? (target - live->now) / (double)samples : 0.0;
}

/* Advances by one sample; returns the value. */
static inline double tb_live_next(TbLiveParam *live) {
  if (live->left == 0) return live->now;
  const double next = live->now + live->step;
  live->now = --live->left == 0 ? live->target : next;
  return live->now;
}

/* True if it is a gain in its range, as read from a state. */
static inline bool tb_live_is_gain(const TbLiveParam *live) {
  return live->now >= 0.0 && live->now <= TB_LIVE_MOST_GAIN && live->target >= 0.0 &&
         live->target <= TB_LIVE_MOST_GAIN && fabs(live->step) <= TB_LIVE_MOST_GAIN;
}

/* The foot's stroke on the pedal of a hi-hat: heads/pedal.h. */
typedef enum TbStampPhase { TB_STAMP_NONE, TB_STAMP_LIFTS, TB_STAMP_FALLS } TbStampPhase;

typedef struct TbStamp {
  double speed; /* [m/s] */
  uint64_t phase;
} TbStamp;

typedef struct TbLiveValues {
  TbLiveParam values[TB_LIVE_COUNT];
  TbStamp stamp;
  TbLiveParam output; /* gain of all outputs, which moves even while the drum sleeps */
} TbLiveValues;

#endif
