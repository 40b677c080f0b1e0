/* SPDX-License-Identifier: MIT */
/**
 * @file live_session.h
 * A drum being played on a device: everything that `tabor play` opens, runs and closes. All of it is for
 * the user's thread.
 */
#ifndef TABOR_HOST_LIVE_SESSION_H
#define TABOR_HOST_LIVE_SESSION_H

#include "play/cue_queue.h"
#include "play/model_builder.h"
#include "play/play_midi.h"
#include "play/play_request.h"
#include "play/take_writer.h"

typedef struct LiveSession {
  PlayRequest *request;
  BackendStream *stream;
  BackendFacts facts;
  ModelBuilder *builder;
  Player *player;
  TakeWriter *writer;
  CueQueue queue;
  PlayMidi *midi;     /**< live, or NULL */
  bool is_urgent;     /**< the audio thread has real-time priority */
  bool is_lost;       /**< the device did not open or start, or is gone: closing it could crash */
  uint64_t unwritten; /**< frames that the recording lacks at its end, because it failed */
} LiveSession;

/** What the user's thread does while the drum plays. */
typedef struct LiveSessionTurn {
  /** Called again and again; waits for the user, 50 ms at most. False: the user wants to stop. */
  bool (*take)(void *context);
  void *context;
} LiveSessionTurn;

/** Opens the device and builds the drum. Close with live_session_close(), whatever the outcome. */
Outcome live_session_open(LiveSession *session, PlayRequest *request);
/**
 * Plays until everything has been played, the user or a signal ends it, or the device is gone. After a
 * signal the outcome is 128 + its number.
 */
Outcome live_session_run(LiveSession *session, const LiveSessionTurn *turn);
/** Stops the sound and completes the recording. */
Outcome live_session_finish(LiveSession *session);
/**
 * Lets go of the device and frees everything. A device that is lost, or that does not let go, is left as it
 * is: then the program ends here, with the status @p outcome.
 */
void live_session_close(LiveSession *session, Outcome outcome);

/** What there is to show; medians and maxima are of the time since the last call. */
void live_session_status(LiveSession *session, PlayStatus *status);
/** From a stroke to its sound [s]; known once the first block has been played. */
double live_session_latency(const LiveSession *session);

#endif
