/* SPDX-License-Identifier: MIT */
/**
 * @file room_mix.h
 * The room behind a host's channels: adds what its walls send back to the sum of all drums.
 *
 * The room hears the drums by the microphones of its feeds. A host plays these as channels of their own, after the
 * ones that are heard: they go through changes of drums and fades like any other channel. Without a room there are
 * no such channels, and no bit changes.
 */
#ifndef TABOR_HOST_ROOM_MIX_H
#define TABOR_HOST_ROOM_MIX_H

#include <tabor/tabor.h>

#include "base/realtime.h"

#define ROOM_FEEDS 2
#define ROOM_PIECE 256 /**< frames computed at once at most */

typedef struct RoomMix {
  TaborRoom *room;      /**< NULL without one */
  const uint32_t *mics; /**< of each heard channel, in the room's definition */
  uint32_t channels;    /**< heard ones */
  uint32_t
    feed[ROOM_FEEDS]; /**< microphones of the channels after these, in the room's definition */
  double loudest;     /**< energy, for room_mix_is_over() */
  float dry[ROOM_FEEDS][ROOM_PIECE];
  float wet[TABOR_MAX_MICS][ROOM_PIECE];
} RoomMix;

/** Channels that the room of @p def needs beside those that are heard: 0 without a room. */
uint32_t room_mix_extra(const TaborDrumDef *def);
/** Begins with @p room, NULL for none, which the caller destroys. @p mics must live as long. */
void room_mix_begin(RoomMix *mix, TaborRoom *room, const uint32_t *mics,
                    uint32_t channels) REALTIME;
/**
 * Adds the room to @p sound, [channel][frame]: the heard channels, then ROOM_FEEDS that the room hears, which may
 * be the same as heard ones. The sound does not depend on the block size.
 */
void room_mix_play(RoomMix *mix, double *const *sound, uint32_t frames) REALTIME;
/** Silences the room. */
void room_mix_cut(RoomMix *mix) REALTIME;
/** True once the room has fallen 90 dB below the loudest that it was when this was called, or without a room. */
bool room_mix_is_over(RoomMix *mix) REALTIME;

#endif
