/* SPDX-License-Identifier: MIT */
/**
 * @file live_session.h
 * A drum being played on a device: everything that `tabor play` opens, runs and closes. All of it is for
 * the user's thread.
 */
#ifndef TABOR_HOST_PERFORMANCE_H
#define TABOR_HOST_PERFORMANCE_H

#include "play/cue_queue.h"
#include "play/model_builder.h"
#include "play/play_midi.h"
#include "play/play_request.h"
#include "play/take_writer.h"

typedef struct Performance {
  PlayRequest *request;
  BackendStream *stream;
  BackendFacts facts;
  DrumChanges *changes;
  Player *player;
  Recorder *recorder;
  Score score;
  PlayMidi *midi;     /**< live, or NULL */
  bool is_urgent;     /**< the audio thread has real-time priority */
  bool is_lost;       /**< the device did not open or start, or is gone: closing it could crash */
  uint64_t unwritten; /**< frames that the recording lacks at its end, because it failed */
} Performance;

/** What the user's thread does while the drum plays. */
typedef struct PerformanceTurn {
  /** Called again and again; waits for the user, 50 ms at most. False: the user wants to stop. */
  bool (*take)(void *context);
  void *context;
} PerformanceTurn;

/** Opens the device and builds the drum. Close with performance_close(), whatever the outcome. */
Outcome performance_open(Performance *performance, PlayRequest *request);
/**
 * Plays until everything has been played, the user or a signal ends it, or the device is gone. After a
 * signal the outcome is 128 + its number.
 */
Outcome performance_run(Performance *performance, const PerformanceTurn *turn);
/** Stops the sound and completes the recording. */
Outcome performance_finish(Performance *performance);
/**
 * Lets go of the device and frees everything. A device that is lost, or that does not let go, is left as it
 * is: then the program ends here, with the status @p outcome.
 */
void performance_close(Performance *performance, Outcome outcome);

/** What there is to show; medians and maxima are of the time since the last call. */
void performance_status(Performance *performance, PlayStatus *status);
/** From a stroke to its sound [s]; known once the first block has been played. */
double performance_latency(const Performance *performance);

#endif
