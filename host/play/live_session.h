/* SPDX-License-Identifier: MIT */
/**
 * @file live_session.h
 * A drum or a kit played on a device: everything that `tabor play` opens, runs and closes. All
 * functions are for the user's thread.
 */
#ifndef TABOR_HOST_LIVE_SESSION_H
#define TABOR_HOST_LIVE_SESSION_H

#include <pthread.h>

#include "kit/kit_threads.h"
#include "play/cue_queue.h"
#include "play/model_builder.h"
#include "play/play_midi.h"
#include "play/play_request.h"
#include "play/take_writer.h"

typedef struct LiveSession {
  PlayRequest *request;
  BackendStream *stream;
  BackendFacts facts;
  TaborDrum *drum; /**< or a kit */
  TaborKit *kit;
  KitThreads *threads;                     /**< of the kit, or NULL */
  ModelBuilder *builders[TABOR_KIT_DRUMS]; /**< of each drum of the kit, or of the drum */
  uint32_t drum_count;
  pthread_mutex_t sending; /**< of the builders */
  Player *player;
  TakeWriter *writer;
  LogWriter *log; /**< NULL without --log */
  CueQueue queue;
  uint64_t song_ignored; /**< notes of the MIDI file that are not in the map */
  PlayMidi *midi;        /**< live MIDI, or NULL */
  bool is_urgent;        /**< the audio thread has real-time priority */
  bool is_lost;       /**< the device failed to open or start, or is gone: closing it could crash */
  uint64_t unwritten; /**< frames missing at the end of a recording that failed */
} LiveSession;

/** Callback of the user's thread while the drum plays. */
typedef struct LiveSessionTurn {
  /** Called repeatedly; waits for the user, 50 ms at most. False: the user wants to stop. */
  bool (*take)(void *context);
  void *context;
} LiveSessionTurn;

/** Opens the device and builds the drum. Close with live_session_close(), whatever the outcome. */
Outcome live_session_open(LiveSession *session, PlayRequest *request);
/**
 * Plays until everything has been played, the user or a signal stops it, or the device is gone.
 * After a signal the outcome is 128 + the signal's number.
 */
Outcome live_session_run(LiveSession *session, const LiveSessionTurn *turn);
/** Stops the sound and completes the recording and the log. */
Outcome live_session_finish(LiveSession *session);
/**
 * Closes the device and frees everything. If the device is lost or does not close, it stays open
 * and the program exits here with the status @p outcome.
 */
void live_session_close(LiveSession *session, Outcome outcome);

/** Fills in @p status; medians and maxima cover the time since the last call. */
void live_session_status(LiveSession *session, PlayStatus *status);
/** Time from a stroke to its sound [s]; known once the first block has been played. */
double live_session_latency(const LiveSession *session);

#endif
