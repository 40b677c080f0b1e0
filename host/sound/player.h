/* SPDX-License-Identifier: MIT */
/**
 * @file player.h
 * Plays a drum or a kit: messages in, sound out.
 *
 * The audio thread receives only messages. It delivers only sound, numbers and blocks of the
 * recording. Each source of messages (keyboard, MIDI, score, drum changes) is one thread and has
 * its own queue. A full queue drops the message and counts it.
 *
 * A message acts at its frame, for every block size: the same messages give the same sound to the
 * bit. A message whose frame has passed acts at once. A source must send its messages in order of
 * their frames, because a message holds back all later ones of its queue.
 *
 * Functions are grouped by thread. player.c holds the functions of the audio thread, player_setup.c
 * the rest.
 */
#ifndef TABOR_HOST_PLAYER_H
#define TABOR_HOST_PLAYER_H

#include "base/message.h"
#include "base/realtime.h"
#include "sound/play_status.h"
#include "sound/player_message.h"
#include "sound/recording.h"

/** Senders of messages, one thread each. At one frame, the order here is the order of execution. */
typedef enum PlayerSource {
  SOURCE_SWAPS,   /**< model_builder.h */
  SOURCE_CHANGES, /**< model_builder.h, whose locks serialise the threads that send, as for
                     SOURCE_SWAPS */
  SOURCE_SCORE,   /**< --events and --midi-file */
  SOURCE_MIDI,    /**< MIDI inputs */
  SOURCE_KEYS,    /**< the computer keyboard and the command line */
  SOURCE_COUNT
} PlayerSource;

/** Parameters of a player. */
typedef struct PlayerSetup {
  TaborDrum *drum;         /**< at rest, with its microphones as outputs; owned by the caller */
  const TaborDrumDef *def; /**< of the drum, and of the room */
  TaborKit *kit;           /**< in place of drum and def; its channels are left and right */
  double rate;             /**< sample rate of the model [Hz] */
  uint32_t channels;       /**< 1 to TABOR_MAX_MICS */
  uint32_t mics[TABOR_MAX_MICS]; /**< output of each channel */
  uint32_t width;  /**< channels of the device, 0 without one; a single channel feeds them all */
  uint32_t buffer; /**< frames that the device asks for at once, or 0 if it does not say */
  double gain;     /**< factor */
  bool records;
  bool logs;       /**< messages are kept for a log */
  uint64_t frames; /**< number to play; 0: see dies_away */
  /** With frames 0: true ends as a rendering does (ring_out.h), false never ends. */
  bool dies_away;
  uint32_t last_event; /**< frame of the last stroke, for dies_away */
} PlayerSetup;

typedef struct Player Player;

/* SET-UP: call while no other thread uses the player */

Outcome player_create(const PlayerSetup *setup, Player **player);
/** NULL is allowed. */
void player_destroy(Player *player);
/** Largest number of frames that will be played; UINT64_MAX without an end. */
uint64_t player_most_frames(const Player *player);

/* SOURCES: one thread per source */

/** Sends a message. Real-time safe. False: the queue was full; the message was dropped and counted.
 */
bool player_send(Player *player, PlayerSource source, const PlayerMessage *message) REALTIME;
/** Number of messages of a source that still wait. */
size_t player_waiting(const Player *player, PlayerSource source);
/** The frame of an event at @p time [s of CLOCK_MONOTONIC], delayed by one block of the device.
 * PLAYER_NOW before the first block. Any thread. */
uint64_t player_frame_at(const Player *player, double time);

/* AUDIO */

/**
 * Plays @p frames frames into @p samples, interleaved, with the setup's width as number of
 * channels.
 * @p now: time of the device's request [s of CLOCK_MONOTONIC]. @p gap: the device had a dropout
 * before this block. Returns false once everything has been played; from then on it writes silence.
 */
bool player_process(Player *player, float *samples, uint32_t frames, double now, bool gap) REALTIME;

/* THE RECORDING'S THREAD */

/** The recording, of no channels if the setup says so. */
Recording *player_recording(Player *player);

/* THE LOG'S THREAD */

/**
 * Returns the next message that acted, with the frame at which it did, valid until
 * player_log_next(); NULL if there is none yet. A full queue loses messages and counts them.
 */
const PlayerMessage *player_log(const Player *player);
/** Releases that message. */
void player_log_next(Player *player);
/** True if the log's queue has room for as many messages as may wait. Any thread. */
bool player_log_has_room(const Player *player);
/** Number of messages that the log has lost. Any thread. */
uint64_t player_log_lost(const Player *player);

/* THE USER'S THREAD */

/** Fills in all fields but preset, building, device, buffer and latency. Maxima and medians cover
 * the time since the last call. */
void player_status(Player *player, PlayStatus *status);
/** Load of all blocks so far, median and worst. */
void player_load(const Player *player, double *median, double *worst);
/** Largest number of frames that the device has asked for at once. */
uint32_t player_buffer(const Player *player);
/** True once everything has been played. */
bool player_is_over(const Player *player);
/** Frames played so far; messages that acted before are in the log's queue or were taken from it.
 * The number stops growing if the device fails. Any thread. */
uint64_t player_position(const Player *player);
/**
 * Stops the work of the audio thread and hands over the rest of the recording. False if the audio
 * thread does not return within @p seconds: that rest is then lost.
 */
bool player_halt(Player *player, double seconds);
/** Raises the audio thread to real-time priority; call after its first block. False if not
 * permitted. */
bool player_raise_priority(Player *player);

#endif
