/* SPDX-License-Identifier: MIT */
/**
 * @file room_mix.h
 * The room behind a drum player's outputs: adds to each what its walls send back.
 *
 * A silence lets go of the room, too: what sounds in it fades over ROOM_MIX_FADE, while what is
 * played from then on sounds in another room like it, which is at rest.
 */
#ifndef TABOR_HOST_ROOM_MIX_H
#define TABOR_HOST_ROOM_MIX_H

#include <stdatomic.h>

#include <tabor/tabor.h>

#include "base/realtime.h"

#define ROOM_MIX_FADE 0.015  /**< [s], as that of a drum's silence */
#define ROOM_MIX_PIECE 256   /**< most frames at once */
#define ROOM_MIX_NO_MIC 0xff /**< an output without a microphone of the room */

typedef struct RoomMix {
  TaborRoom *room;     /**< NULL without one */
  TaborRoom *fading;   /**< another one like it, which the last silence silenced */
  atomic_bool is_left; /**< its drum player plays it no more */
  uint32_t outputs;
  uint8_t mics[TABOR_MAX_MICS]; /**< of each output, in the room's definition, or ROOM_MIX_NO_MIC */
  uint32_t feeds;               /**< bits of the outputs that the room hears */
  uint32_t fade, left;          /**< frames of a fade, and that are left of this one */
  double loudest;               /**< energy, for room_mix_is_over() */
  float wet[TABOR_MAX_MICS][ROOM_MIX_PIECE];
} RoomMix;

/**
 * Puts the room of @p def behind @p outputs outputs, which hear its microphones @p mics; a room of
 * the kind none adds nothing and takes no memory. Prints an error. Free with room_mix_free(),
 * whatever the outcome.
 */
TaborStatus room_mix_create(RoomMix *mix, const TaborDrumDef *def, double rate, const uint8_t *mics,
                            uint32_t outputs, TaborError *error);
void room_mix_free(RoomMix *mix);

/** Adds the room to @p frames frames of each output whose bit is set in @p heard, from frame @p
 * from on. At most ROOM_MIX_PIECE frames. The sound does not depend on the block size. */
void room_mix_play(RoomMix *mix, float (*sound)[ROOM_MIX_PIECE], uint32_t heard, uint32_t from,
                   uint32_t frames) REALTIME;
/** Lets the room fade, as a silence does. */
void room_mix_silence(RoomMix *mix) REALTIME;
/** True while something fades. */
bool room_mix_is_fading(const RoomMix *mix) REALTIME;
/** Brings the room to rest. */
void room_mix_rest(RoomMix *mix) REALTIME;
/** True once the room has fallen 90 dB below the loudest that it was when this was called, or
 * without a room. */
bool room_mix_is_over(RoomMix *mix) REALTIME;

#endif
