/* SPDX-License-Identifier: MIT */
/**
 * @file replay.h
 * Reads the log of a performance (log_line.h), to be played again.
 */
#ifndef TABOR_HOST_REPLAY_H
#define TABOR_HOST_REPLAY_H

#include "sound/log_line.h"

/** A performance. Initialise with {0}. */
typedef struct Replay {
  LogStart start;
  LogDrum *drum; /**< at the start */
  PlayerMessage *messages;
  size_t count, capacity;
  LogDrum **models; /**< that messages change to; number 1 comes first */
  size_t model_count, model_capacity;
  uint32_t frames; /**< played */
  uint64_t lost;   /**< messages that the log lacks */
} Replay;

/** Reads the file @p name, "-" for standard input. Refuses anything but a whole log. Free with replay_free(), whatever
 * the outcome. */
Outcome replay_read(const char *name, Replay *replay);
void replay_free(Replay *replay);

#endif
