/* SPDX-License-Identifier: MIT */
/**
 * @file silencer.h
 * Silences a drum: the sound fades out within 5 ms, the drum is reset, and it is audible again 15 ms after the
 * request. If nothing has acted on the drum since its last reset, it is silent and the request does nothing.
 *
 * Strokes wait until the drum is audible again. A reset restores the parameters of the model, so live parameters
 * that were moved are moved again while the drum is inaudible. The block size has no influence. Real-time safe.
 */
#ifndef TABOR_HOST_SILENCER_H
#define TABOR_HOST_SILENCER_H

#include <tabor/tabor.h>

#include "sound/fader.h"

#define SILENCER_LIVE 24 /* most live parameters kept through a silence */

typedef enum SilencerPhase {
  SILENCER_HEARD,  /**< the drum is audible */
  SILENCER_FADING, /**< a silence was requested; the sound fades out */
  SILENCER_RESTING /**< the drum was reset and is inaudible */
} SilencerPhase;

typedef struct Silencer {
  SilencerPhase phase;
  bool at_rest; /**< nothing has acted on the drum since its last reset */
  Fader fader;
  uint32_t resting; /**< frames left of SILENCER_RESTING */
  TaborEvent live[SILENCER_LIVE];
  uint32_t live_count;
} Silencer;

/** Starts at @p rate [Hz] with a drum that is at rest and audible. */
Silencer silencer_begin(double rate) REALTIME;
/** Requests a silence. */
void silencer_wish(Silencer *silencer) REALTIME;
/** True while messages have to wait. */
static inline bool silencer_waits(const Silencer *silencer) {
  return silencer->phase != SILENCER_HEARD;
}

/** Call when @p event acts on the drum. A live parameter that it moves is kept through a silence. */
void silencer_remember(Silencer *silencer, const TaborEvent *event) REALTIME;
/** Forgets moved parameters; call when another model, with its own values, has come. */
void silencer_forget(Silencer *silencer) REALTIME;

/** True if silencer_step() will reset the drum, with its counters, at this frame. */
bool silencer_is_due(const Silencer *silencer) REALTIME;
/** Advances the phase at this frame; resets @p drum when that is due. */
void silencer_step(Silencer *silencer, TaborDrum *drum) REALTIME;
/** Number of frames, @p most at most, to compute before the next silencer_step(). */
uint32_t silencer_limit(const Silencer *silencer, uint32_t most) REALTIME;
/** The gain factor of the next frame. */
double silencer_next(Silencer *silencer) REALTIME;

#endif
