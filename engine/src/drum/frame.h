/* SPDX-License-Identifier: MIT */
/* One frame of the output of a drum that may be asleep. Audio-safe. */
#ifndef TB_FRAME_H
#define TB_FRAME_H

#include "state/state.h"

/* Sound from outside during a frame, and what is wanted of the drum's own. */
typedef struct TbFrameAir {
  uint32_t mic;    /* at whose place the sound's source is */
  bool low;        /* the low modes alone hear it (model.h) */
  double incident; /* [Pa]: see air/incident_sound.h */
  double wake;     /* a drum that sleeps does not hear what is less [Pa] */
  uint32_t tap;    /* microphone whose signal is wanted before its delay, or TB_NO_TAP */
  double tapped;   /* out [Pa] */
} TbFrameAir;

/* Advances the state by one frame, asleep or not; pressure[] as for tb_step(). Sound from outside
 * wakes the drum. `air` may be NULL. */
void tb_frame(TbView *view, uint32_t heard, TbFrameAir *air, double *pressure);

#endif
