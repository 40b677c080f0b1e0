/* SPDX-License-Identifier: MIT */
/* Live values: parameters that may move while a drum rings (step/live_params.h). */
#ifndef TB_LIVE_VALUES_H
#define TB_LIVE_VALUES_H

#include "tabor/tabor.h"

typedef enum TbLiveIndex {
  TB_LIVE_TENSION,
  TB_LIVE_DAMPING_0,
  TB_LIVE_DAMPING_1,
  TB_LIVE_STRAINER,
  TB_LIVE_MUFFLE, /* of the batter head; the resonant head's is next */
  TB_LIVE_MUFFLE_RESONANT,
  TB_LIVE_FULL_SCALE,
  TB_LIVE_GRIP, /* of hands that press a stick */
  TB_LIVE_GAIN, /* of the first microphone; the others follow in order */
  TB_LIVE_COUNT = TB_LIVE_GAIN + TABOR_MAX_MICS
} TbLiveIndex;

typedef struct TbLiveParam {
  double now, target, step; /* step per sample while `left` samples remain */
  uint32_t left;
} TbLiveParam;

typedef struct TbLiveValues {
  TbLiveParam values[TB_LIVE_COUNT];
  TbLiveParam output; /* gain of all outputs, which moves even while the drum sleeps */
} TbLiveValues;

#endif
