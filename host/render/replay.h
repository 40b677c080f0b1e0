/* SPDX-License-Identifier: MIT */
/**
 * @file replay.h
 * Reads the log of a performance (log_line.h), to be played again.
 */
#ifndef TABOR_HOST_REPLAY_H
#define TABOR_HOST_REPLAY_H

#include "render/log_line.h"

/** A performance. Initialise with {0}. */
typedef struct Replay {
  LogStart start;
  LogDrum *drum;    /**< at the start */
  TaborKitDef *kit; /**< at the start, or NULL */
  PlayerMessage *messages;
  size_t count, capacity;
  LogDrum **models; /**< that messages change to; number 1 comes first */
  size_t model_count, model_capacity;
  uint32_t frames; /**< played, as far as the log knows */
  uint64_t lost;   /**< messages that the log lacks */
  bool is_cut;     /**< the log has no end: its writer was killed, and more may have been played */
} Replay;

/**
 * Reads the file @p name, "-" for standard input. A log without an end is taken up to the frame to
 * which it is complete: that of its mark or of its last message. If its last line is no JSON, that
 * line is ignored. Anything else that is not a log is refused. Free with replay_free(), whatever
 * the outcome.
 */
Outcome replay_read(const char *name, Replay *replay);
void replay_free(Replay *replay);

#endif
