/* SPDX-License-Identifier: MIT */
/**
 * @file leaving.h
 * Drums that others have taken the place of: each rings out under a fade of 30 ms beside the one that is played.
 *
 * Every channel goes on hearing the microphone that it had. Where more than LEAVING_MOST leave at once, the
 * oldest is cut. The drums stay the caller's, who gets each back to destroy it where he may. The sound depends
 * on frames alone, not on blocks. Real-time safe.
 */
#ifndef TABOR_HOST_LEAVING_H
#define TABOR_HOST_LEAVING_H

#include <tabor/tabor.h>

#include "base/realtime.h"

#define LEAVING_TIME 0.03         /**< [s] */
#define LEAVING_MOST 4            /**< drums at once */
#define LEAVING_CHANNELS 64       /**< at most */
#define LEAVING_PIECE 256         /**< frames computed at once at most */
#define LEAVING_NO_MIC UINT32_MAX /**< of a channel that hears nothing */

typedef struct LeavingDrum {
  TaborDrum *drum;
  uint32_t mics[LEAVING_CHANNELS]; /**< of each channel, or LEAVING_NO_MIC */
  uint32_t left;                   /**< frames of its fade */
} LeavingDrum;

typedef struct Leaving {
  LeavingDrum drums[LEAVING_MOST]; /**< the oldest first */
  uint32_t count;
  uint32_t length; /**< of a fade [frames] */
  float planar[TABOR_MAX_MICS][LEAVING_PIECE];
} Leaving;

/** None leaves yet, at @p rate [Hz]. */
void leaving_begin(Leaving *leaving, double rate) REALTIME;
/**
 * From the next frame on @p drum leaves, which each of @p channels channels has heard by the microphone in @p mics.
 * Gives back the drum that is done with at once: this one if it is silent, or the oldest for want of room; or NULL.
 */
TaborDrum *leaving_add(Leaving *leaving, TaborDrum *drum, const uint32_t *mics,
                       uint32_t channels) REALTIME;
/** Adds the next @p frames frames to @p sound, [channel][frame]; NULL: nobody hears the channel. */
void leaving_play(Leaving *leaving, double *const *sound, uint32_t channels,
                  uint32_t frames) REALTIME;
/** The same added to @p samples of the drum that is played: @p sound is what every channel hears of all. */
void leaving_join(Leaving *leaving, const float *const *samples, double *const *sound,
                  uint32_t channels, uint32_t frames) REALTIME;
/** All have left. */
void leaving_cut(Leaving *leaving) REALTIME;
/** Gives a drum back that has left; NULL if there is none. */
TaborDrum *leaving_take(Leaving *leaving) REALTIME;

#endif
