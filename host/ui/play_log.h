/* SPDX-License-Identifier: MIT */
/**
 * @file play_log.h
 * Logs what happens during play, line by line, for use without a screen.
 */
#ifndef TABOR_HOST_PLAY_LOG_H
#define TABOR_HOST_PLAY_LOG_H

#include "sound/play_status.h"

/** The state that has been logged. Initialise with {0}. */
typedef struct PlayLog {
  bool has_begun, clips;
  char preset[TABOR_TEXT_SIZE];
  uint64_t strokes, xruns, dropped, recovered, ignored_notes;
} PlayLog;

/** Prints changes since the last call, a line each: strokes, a new drum, dropouts and other
 * trouble. */
void play_log_take(PlayLog *log, const PlayStatus *status, double head_radius);

#endif
