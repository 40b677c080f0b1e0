/* SPDX-License-Identifier: MIT */
/**
 * @file ring_out.h
 * When a rendering without --duration ends: once the stored energy has fallen 90 dB below its
 * largest value since the last stroke, but between 0.5 and 20 s after it.
 */
#ifndef TABOR_HOST_RING_OUT_H
#define TABOR_HOST_RING_OUT_H

#include <tabor/tabor.h>

#include "base/realtime.h"

/** Frames from one look at the energy to the next; fixed, as the length depends on it. */
#define RING_OUT_BLOCK 256
#define RING_OUT_MOST_TIME 20.0 /**< after the last stroke [s] */

typedef struct RingOut {
  uint32_t last_event;  /**< frame of the last stroke */
  uint32_t least, most; /**< frames of the whole sound; equal if the length is given */
  double loudest;       /**< stored energy at most since the last stroke [J] */
  bool sounding;        /**< it ended at most frames without having died away */
} RingOut;

/** A sound of @p frames frames, or, if that is 0, until @p rate [Hz]'s drum has died away. */
RingOut ring_out_begin(uint32_t frames, uint32_t last_event, double rate);
/** Looks at @p drum after @p position frames, at every block's end; true if the sound is over. */
bool ring_out_is_over(RingOut *ring_out, uint32_t position, const TaborDrum *drum) REALTIME;

#endif
