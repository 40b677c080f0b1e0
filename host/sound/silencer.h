/* SPDX-License-Identifier: MIT */
/**
 * @file silencer.h
 * Silence at once: the sound fades out within 5 ms, the drum goes to rest, and is heard again 15 ms after the wish.
 * A drum that nothing has acted on since it was at rest is silent already: there a wish does nothing.
 *
 * Until it may be heard, strokes wait. A drum at rest has the values of its model: live parameters that were
 * moved since are moved again, unheard. Everything depends on frames alone, not on blocks. Real-time safe.
 */
#ifndef TABOR_HOST_SILENCER_H
#define TABOR_HOST_SILENCER_H

#include <tabor/tabor.h>

#include "sound/fader.h"

#define SILENCER_LIVE 24 /* live parameters that outlive a silence */

typedef enum SilencerPhase {
  SILENCER_HEARD,
  SILENCER_FADING, /**< to a silence that was wished for */
  SILENCER_RESTING /**< in it */
} SilencerPhase;

typedef struct Silencer {
  SilencerPhase phase;
  bool at_rest; /**< nothing has acted on the drum since it was */
  Fader fader;
  uint32_t resting; /**< frames left of that phase */
  TaborEvent live[SILENCER_LIVE];
  uint32_t live_count;
} Silencer;

/** For @p rate [Hz]; the drum is at rest and heard. */
Silencer silencer_begin(double rate) REALTIME;
/** Silence is wished for. */
void silencer_wish(Silencer *silencer) REALTIME;
/** True while messages wait. */
static inline bool silencer_waits(const Silencer *silencer) {
  return silencer->phase != SILENCER_HEARD;
}

/** An @p event acts on the drum: if it moves a live parameter, that is to outlive a silence. */
void silencer_remember(Silencer *silencer, const TaborEvent *event) REALTIME;
/** Another model has come, with values of its own. */
void silencer_forget(Silencer *silencer) REALTIME;

/** True if the drum goes to rest at this frame: silencer_step() will reset it, with its counters. */
bool silencer_is_due(const Silencer *silencer) REALTIME;
/** Does what is to be done at this frame. */
void silencer_step(Silencer *silencer, TaborDrum *drum) REALTIME;
/** How many of the next @p most frames to compute before the next silencer_step(). */
uint32_t silencer_limit(const Silencer *silencer, uint32_t most) REALTIME;
/** The factor of the next frame's sound. */
double silencer_next(Silencer *silencer) REALTIME;

#endif
