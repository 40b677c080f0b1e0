/* SPDX-License-Identifier: MIT */
/**
 * @file session.h
 * One drum being played: strokes in, interleaved samples out.
 */
#ifndef TABOR_HOST_SESSION_H
#define TABOR_HOST_SESSION_H

#include "render_request.h"
#include "trace_file.h"

#define SESSION_BLOCK AUDIO_BLOCK

typedef struct Session {
  RenderRequest *request;
  TaborDrum *drum;
  size_t next_event;
  uint32_t position;              /**< frames played */
  double peak;                    /**< largest sample in size */
  double computing;               /**< processor time that the drum took [s] */
  float *outputs[TABOR_MAX_MICS]; /**< into planar; NULL for microphones that nobody hears */
  float planar[TABOR_MAX_MICS][SESSION_BLOCK];
  double interleaved[MOST_CHANNELS * SESSION_BLOCK]; /**< the newest block */
} Session;

/** Builds model and drum. Free with session_free(), whatever the outcome. */
Outcome session_open(Session *session, RenderRequest *request);
/** Plays @p frames frames, at most SESSION_BLOCK, into interleaved. */
void session_play(Session *session, uint32_t frames);
/** The same one frame at a time, with a row of @p trace after each. The samples are the same. */
Outcome session_play_traced(Session *session, uint32_t frames, TraceFile *trace);
void session_free(Session *session);

#endif
