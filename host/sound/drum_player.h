/* SPDX-License-Identifier: MIT */
/**
 * @file drum_player.h
 * Plays a drum or a kit: messages become events with their frames, and blocks are computed. Render,
 * play and plugins differ in where messages come from and where the sound goes; this is what they
 * share. Outputs of a drum are its microphones; those of a kit its mix, left and right, with its
 * samples, and then each drum's part of it, without room.
 *
 * A message acts at its frame for every block size: the same messages give the same sound to the
 * bit. One whose frame has passed acts at once. Real-time safe.
 */
#ifndef TABOR_HOST_DRUM_PLAYER_H
#define TABOR_HOST_DRUM_PLAYER_H

#include "sound/fader.h"
#include "sound/player_message.h"
#include "sound/room_mix.h"

#define DRUM_PLAYER_MOST_INPUT                                                                     \
  100.0 /**< of a sound that plays to a drum, times full scale: +40 dBFS */
#define DRUM_PLAYER_BLOCK ROOM_MIX_PIECE /**< most frames of a block */
#define DRUM_PLAYER_OUTPUTS (2 + 2 * TABOR_KIT_DRUMS)
#define DRUM_PLAYER_EVENTS 256 /**< most events of a frame; further ones act one frame later */

/** Takes the next message that acts before frame @p end out of @p source. False: there is none. */
typedef bool DrumSourceFn(void *source, uint64_t end, PlayerMessage *message) REALTIME;
/** Is told of each message and the frame at which it acts, in this order. */
typedef void DrumWitnessFn(void *context, const PlayerMessage *message, uint64_t frame) REALTIME;

typedef struct DrumPlayer {
  TaborDrum *drum; /**< or a kit; neither: silence, and events are lost */
  TaborKit *kit;   /**< its room is its own, and it hears no sound from outside */
  Fader mix;       /**< gain of a kit's outputs; a drum has its own */
  float loudest;   /**< largest sample of the kit before this gain, until somebody sets it to 0 */
  uint64_t position;
  uint32_t outputs;                   /**< that the drum was given by tabor_drum_route() */
  uint64_t heard;                     /**< bits of the outputs that anybody hears */
  uint32_t strikers[TABOR_KIT_DRUMS]; /**< of the current model of each drum */
  RoomMix *room;                      /**< behind the outputs, or NULL; the host's, as the next */
  RoomMix *former;                    /**< the room before, while it fades; else NULL */
  double gain, expression;
  uint64_t strokes;                         /**< number of strokes that the drum was asked for */
  TaborKitEvent events[DRUM_PLAYER_EVENTS]; /**< of the block, not yet played */
  uint32_t count;
  PlayerMessage next; /**< taken from the source, but not yet played */
  bool has_next;
  DrumWitnessFn *witness; /**< may be NULL */
  void *context;          /**< of the witness */
  const float
    *input; /**< [DRUM_PLAYER_BLOCK] sound from outside in the next block [Pa]; NULL: none */
  uint32_t input_mic; /**< microphone at whose place its source is */
  float sound[DRUM_PLAYER_OUTPUTS]
             [DRUM_PLAYER_BLOCK]; /**< the newest block of each output that is heard */
} DrumPlayer;

/** Starts without a drum and without a room; nothing is heard. */
void drum_player_begin(DrumPlayer *player, uint32_t outputs, double gain) REALTIME;
/** Gives the player its drum, at rest, with its outputs chosen and with so many strikers. */
void drum_player_set_drum(DrumPlayer *player, TaborDrum *drum, uint32_t strikers) REALTIME;
/** Gives the player a kit, at rest, and its samples, which may be NULL; @p rate is theirs [Hz]. */
void drum_player_set_kit(DrumPlayer *player, TaborKit *kit, double rate) REALTIME;
/** True if drum or kit are silent, and samples; a drum's room is not asked. */
bool drum_player_is_silent(const DrumPlayer *player) REALTIME;
/** Energy account of the drum, or of all drums of the kit together. */
void drum_player_ledger(const DrumPlayer *player, TaborLedger *sum) REALTIME;
/** Counters likewise: those that renderings and sessions report; the others are 0. */
void drum_player_statistics(const DrumPlayer *player, TaborStatistics *sum) REALTIME;
/** Puts @p room behind the outputs; the one before fades out, and is left then. */
void drum_player_set_room(DrumPlayer *player, RoomMix *room) REALTIME;
/** Brings drum and room to rest and forgets the expression; messages taken but not yet played are
 * lost. */
void drum_player_rest(DrumPlayer *player) REALTIME;
/** Plays @p frames frames, at most DRUM_PLAYER_BLOCK, into sound. */
void drum_player_play(DrumPlayer *player, DrumSourceFn *take, void *source,
                      uint32_t frames) REALTIME;

#endif
