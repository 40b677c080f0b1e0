/* SPDX-License-Identifier: MIT */
/**
 * @file player.h
 * A drum being played: messages in, sound out.
 *
 * Nothing but messages gets into the audio thread, nothing but sound, numbers and blocks for the
 * recording comes out of it. Every source of messages (the keyboard, MIDI, cues, changes of the
 * drum) is one thread and has its own queue; a queue that is full drops the message and counts it.
 *
 * A message acts at its frame, whatever the size of the device's blocks: the same messages give the
 * same sound to the bit. One whose frame has passed acts at once. Messages of one source are to come
 * in order of their frames: one that is due later holds back those behind it.
 *
 * Functions are grouped by thread. player.c holds what the audio thread runs, player_setup.c the rest.
 */
#ifndef TABOR_HOST_PLAYER_H
#define TABOR_HOST_PLAYER_H

#include "base/message.h"
#include "base/realtime.h"
#include "sound/play_status.h"

#define PLAYER_NOW 0      /**< as a message's frame: as soon as possible, and not late */
#define PLAYER_RECORD 256 /**< frames of a block for the recording */

/** Who sends messages: one thread each. Of messages of one frame those of the first act first. */
typedef enum PlayerSource {
  SOURCE_SWAPS,   /**< model_builder.h */
  SOURCE_CHANGES, /**< model_builder.h, whose lock makes one thread of many */
  SOURCE_SCORE,   /**< --events and --midi-file */
  SOURCE_MIDI,    /**< MIDI inputs */
  SOURCE_KEYS,    /**< the computer keyboard and the command line */
  SOURCE_COUNT
} PlayerSource;

typedef enum PlayerMessageType {
  PLAYER_EVENT, /**< event; but swaps come as PLAYER_SWAP */
  PLAYER_SWAP,  /**< event: the drum goes on with another model; see mics and strikers */
  PLAYER_DRUM, /**< drum: another one in place of that which is played, which rings out beside it */
  PLAYER_GAIN, /**< value: factor of the output, reached over 5 ms */
  PLAYER_EXPRESSION, /**< the same beside that one, by MIDI */
  PLAYER_SILENCE /**< the sound fades out within 5 ms, and the drum is at rest; strokes wait for it */
} PlayerMessageType;

typedef struct PlayerMessage {
  uint64_t frame; /**< since playing began, or PLAYER_NOW */
  uint32_t type;  /**< a PlayerMessageType */
  TaborDrum *drum;
  uint8_t mics[TABOR_MAX_MICS]; /**< each channel's microphone on what has come */
  uint32_t strikers;            /**< that it has */
  double value;
  TaborEvent event; /**< its own frame is ignored */
} PlayerMessage;

/** PLAYER_RECORD frames of what was played; fewer only at the end. */
typedef struct PlayerRecord {
  uint64_t frame;
  uint32_t frames;
  double samples[]; /**< interleaved channels */
} PlayerRecord;

/** What a player is made for. */
typedef struct PlayerSetup {
  TaborDrum *drum;               /**< see player_gone() */
  double rate;                   /**< [Hz], the model's */
  uint32_t channels;             /**< 1 to TABOR_MAX_MICS */
  uint32_t mics[TABOR_MAX_MICS]; /**< of each channel */
  uint32_t width;  /**< channels of the device, 0 for none; one channel goes to all of them */
  uint32_t buffer; /**< frames that the device asks for at once, or 0 if it does not say */
  double gain;     /**< factor */
  bool records;
  uint64_t frames; /**< how many to play, or 0: see dies_away */
  bool
    dies_away; /**< ends as a rendering does, last_event being the frame of the last stroke; or else
                        never */
  uint32_t last_event;
} PlayerSetup;

typedef struct Player Player;

/* SET-UP: while no other thread uses the player */

Outcome player_create(const PlayerSetup *setup, Player **player);
/** NULL is allowed. */
void player_destroy(Player *player);
/** Frames that will be played at most; UINT64_MAX without an end. */
uint64_t player_most_frames(const Player *player);

/* SOURCES: each one thread */

/** Real-time safe. False: the queue was full, the message is dropped and counted. */
bool player_send(Player *player, PlayerSource source, const PlayerMessage *message) REALTIME;
/** Messages of a source that still wait. */
size_t player_waiting(const Player *player, PlayerSource source);
/** The frame for what happens at @p time [s of CLOCK_MONOTONIC]: as late as every other, by one
 * block of the device. PLAYER_NOW before the first block. Any thread. */
uint64_t player_frame_at(const Player *player, double time);

/**
 * A drum that is done with, or NULL. Drums stay their sender's, who leaves them to the player until they come back
 * here, or until it is destroyed. One thread at a time.
 */
TaborDrum *player_gone(Player *player);

/* AUDIO */

/**
 * Plays @p frames frames into @p samples, interleaved, as many channels as the setup's width; asked
 * for at @p now [s of CLOCK_MONOTONIC]. @p gap: the device has run dry before. False once everything
 * has been played: then there is silence.
 */
bool player_process(Player *player, float *samples, uint32_t frames, double now, bool gap) REALTIME;

/* THE RECORDING'S THREAD */

/** The next block, valid until player_record_next(); NULL if there is none yet. */
const PlayerRecord *player_record(const Player *player);
void player_record_next(Player *player);
/** True if the recording has room for @p frames more. Any thread. */
bool player_record_has_room(const Player *player, uint32_t frames);

/* THE USER'S THREAD */

/** Fills in what the player knows: not preset, building, device, buffer, latency. Maxima and medians are of
 * the time since the last call. */
void player_status(Player *player, PlayStatus *status);
/** Load of all blocks so far, median and worst. */
void player_load(const Player *player, double *median, double *worst);
/** Frames that the device asks for at once: the most so far. */
uint32_t player_buffer(const Player *player);
/** True once everything has been played. */
bool player_is_over(const Player *player);
/** Frames played; stands still if the device has died. */
uint64_t player_position(const Player *player);
/**
 * Lets the audio thread do no more, and hands the rest of the recording over. True; or false if the
 * audio thread does not come back within @p seconds: then that rest is lost.
 */
bool player_halt(Player *player, double seconds);
/** Raises the audio thread to real-time priority, once it has played a block; false if that is not permitted. */
bool player_raise_priority(Player *player);

#endif
