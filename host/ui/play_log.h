/* SPDX-License-Identifier: MIT */
/**
 * @file play_log.h
 * What happens while a drum is played, in lines, for those who have no screen or want none.
 */
#ifndef TABOR_HOST_PLAY_LOG_H
#define TABOR_HOST_PLAY_LOG_H

#include "sound/play_status.h"

/** What has been told. Begins as {0}. */
typedef struct PlayLog {
  bool has_begun, clips;
  char preset[TABOR_TEXT_SIZE];
  uint64_t strokes, xruns, dropped, recovered, ignored_notes;
} PlayLog;

/** Tells what is new since the last look: strokes, another drum, gaps and other trouble, a line each. */
void play_log_take(PlayLog *log, const PlayStatus *status, double head_radius);

#endif
