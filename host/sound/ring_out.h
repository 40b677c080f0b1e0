/* SPDX-License-Identifier: MIT */
/**
 * @file ring_out.h
 * Decides when a rendering without --duration ends: once the energy of all drums, and that of the
 * sound in their room, have fallen 90 dB below their largest values since the last stroke, but at
 * least 0.5 s and at most 20 s after that stroke.
 */
#ifndef TABOR_HOST_RING_OUT_H
#define TABOR_HOST_RING_OUT_H

#include "sound/drum_player.h"

/** Frames between two checks of the energy. Fixed, because the length of the sound depends on it.
 */
#define RING_OUT_BLOCK DRUM_PLAYER_BLOCK
#define RING_OUT_MOST_TIME 20.0 /**< longest time after the last stroke [s] */

typedef struct RingOut {
  uint32_t last_event;  /**< frame of the last stroke */
  uint32_t least, most; /**< limits of the sound's length [frames]; equal if the length is given */
  double loudest;       /**< largest stored energy since the last stroke [J] */
  bool sounding;        /**< the sound reached `most` before it had died away */
} RingOut;

/** A sound of @p frames frames; 0: until the drum has died away. @p rate: sample rate [Hz]. */
RingOut ring_out_begin(uint32_t frames, uint32_t last_event, double rate);
/** Checks drum and room; call at the end of every block. True if the sound is over. */
bool ring_out_is_over(RingOut *ring_out, DrumPlayer *player) REALTIME;

#endif
