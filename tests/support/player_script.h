/* SPDX-License-Identifier: MIT */
/**
 * @file player_script.h
 * Plays messages at their frames in blocks of any size, without a device, for tests of the player.
 */
#ifndef TEST_PLAYER_SCRIPT_H
#define TEST_PLAYER_SCRIPT_H

#include "play/model_builder.h"

enum { PLAYER_SCRIPT_MOST = 4096 };

/** A player with its drum, and its recording so far. */
typedef struct Stage {
  TaborDrum *drum;
  ModelBuilder *builder;
  Player *player;
  uint32_t channels;
  uint64_t position; /**< frames requested so far */
  double *samples;   /**< [frame][channel] */
  uint64_t recorded, room;
} Stage;

/** Messages of one source, in order of their frames. */
typedef struct Messages {
  PlayerMessage list[PLAYER_SCRIPT_MOST];
  uint32_t count, next;
} Messages;

/** Opens @p preset at 48 kHz with its first microphone and room for @p frames; fails the test on
 * errors. */
Stage *stage_open(const char *preset, TaborQuality quality, bool waits, uint32_t frames);
void stage_close(Stage *stage);
/** Requests a block and stores its recording. */
void stage_block(Stage *stage, uint32_t frames);
/** Plays @p messages until frame @p until in blocks of @p size, 0: of random sizes up to 4096. */
void stage_play(Stage *stage, Messages *messages, uint64_t until, uint32_t size);
/** Halts the player and stores the last, partial block of the recording. */
void stage_end(Stage *stage);
/** Model of the current drum. */
const TaborModel *stage_model(const Stage *stage);
/** Largest absolute sample from .. until. */
double stage_peak(const Stage *stage, uint64_t from, uint64_t until);

PlayerMessage message_strike(uint64_t frame, double velocity, double radius);
PlayerMessage message_silence(uint64_t frame);
PlayerMessage message_parameter(uint64_t frame, const char *key, double value);
void messages_add(Messages *messages, PlayerMessage message);

/** Returns the next random number, at least 0 and below 1. */
double random_next(uint64_t *state);

#endif
