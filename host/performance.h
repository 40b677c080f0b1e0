/* SPDX-License-Identifier: MIT */
/**
 * @file performance.h
 * A drum being played on a device: everything that `tabor play` opens, runs and closes.
 */
#ifndef TABOR_HOST_PERFORMANCE_H
#define TABOR_HOST_PERFORMANCE_H

#include "drum_changes.h"
#include "play_request.h"
#include "recorder.h"
#include "score.h"

typedef struct Performance {
  PlayRequest *request;
  BackendStream *stream;
  BackendFacts facts;
  DrumChanges *changes;
  Player *player;
  Recorder *recorder;
  Strokes strokes;
  Score score;
} Performance;

/** Opens the device and builds the drum. Close with performance_close(), whatever the outcome. */
Outcome performance_open(Performance *performance, PlayRequest *request);
/** Plays until everything has been played, the user or a signal ends it, or the device is gone. */
Outcome performance_run(Performance *performance);
/** Completes the recording, then lets go of the device. */
Outcome performance_close(Performance *performance);

#endif
