/* SPDX-License-Identifier: MIT */
/**
 * @file leaving.h
 * Drums that were replaced: each fades out over 30 ms while the new drum plays.
 *
 * Each channel keeps the leaving drum's microphone that it had. If more than LEAVING_MOST drums leave at
 * once, the oldest is cut. The caller owns the drums and gets each back, to destroy it on a thread that
 * may free memory. The sound does not depend on the block size. Real-time safe.
 */
#ifndef TABOR_HOST_LEAVING_H
#define TABOR_HOST_LEAVING_H

#include <tabor/tabor.h>

#include "base/realtime.h"

#define LEAVING_TIME 0.03         /**< [s] */
#define LEAVING_MOST 4            /**< drums at once */
#define LEAVING_CHANNELS 64       /**< at most */
#define LEAVING_PIECE 256         /**< frames computed at once at most */
#define LEAVING_NO_MIC UINT32_MAX /**< the channel has no microphone */

typedef struct LeavingDrum {
  TaborDrum *drum;
  uint32_t mics[LEAVING_CHANNELS]; /**< microphone of each channel, or LEAVING_NO_MIC */
  uint32_t left;                   /**< frames left of its fade */
} LeavingDrum;

typedef struct Leaving {
  LeavingDrum drums[LEAVING_MOST]; /**< the oldest first */
  uint32_t count;
  uint32_t length; /**< of a fade [frames] */
  float planar[TABOR_MAX_MICS][LEAVING_PIECE];
} Leaving;

/** Starts without leaving drums, at @p rate [Hz]. */
void leaving_begin(Leaving *leaving, double rate) REALTIME;
/**
 * Starts the fade of @p drum at the next frame. @p mics: its microphone for each of @p channels channels.
 * Returns a drum that is finished already, or NULL: @p drum itself if it is silent, or the oldest one if there
 * is no room.
 */
TaborDrum *leaving_add(Leaving *leaving, TaborDrum *drum, const uint32_t *mics,
                       uint32_t channels) REALTIME;
/** Adds the next @p frames frames to @p sound, [channel][frame]. A NULL channel is skipped. */
void leaving_play(Leaving *leaving, double *const *sound, uint32_t channels,
                  uint32_t frames) REALTIME;
/** Sets @p sound to the sum of @p samples, from the current drum, and of all leaving drums. */
void leaving_join(Leaving *leaving, const float *const *samples, double *const *sound,
                  uint32_t channels, uint32_t frames) REALTIME;
/** Ends all fades at once. */
void leaving_cut(Leaving *leaving) REALTIME;
/** Returns a drum whose fade has ended; NULL if there is none. */
TaborDrum *leaving_take(Leaving *leaving) REALTIME;

#endif
