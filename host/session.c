/* SPDX-License-Identifier: MIT */
#include "session.h"

#include <math.h>

#include "drum_source.h"
#include "stopwatch.h"

Outcome session_open(Session *session, RenderRequest *request) {
  session->request = request;
  session->next_event = 0;
  session->position = 0;
  session->peak = session->computing = 0;
  for (uint32_t mic = 0; mic < TABOR_MAX_MICS; mic++) session->outputs[mic] = NULL;
  for (uint32_t channel = 0; channel < request->channels; channel++) {
    const uint32_t mic = request->mics[channel];
    session->outputs[mic] = session->planar[mic];
  }
  return drum_create(&request->def, &request->model, &session->drum);
}

/* This thread's: others may play other drums. */
static double processor_time(void) { return stopwatch_seconds(CLOCK_THREAD_CPUTIME_ID); }

/* Plays frames from session->position on to outputs. */
static void process(Session *session, float *const *outputs, uint32_t frames) {
  const Strokes *const strokes = &session->request->strokes;
  TaborEvent *const events = strokes->events + session->next_event;
  uint32_t count = 0;
  while (session->next_event < strokes->count && events[count].frame < session->position + frames) {
    events[count].frame -= session->position; /* from here on counted within the block */
    session->next_event++;
    count++;
  }
  const double start = processor_time();
  tabor_drum_process(session->drum, events, count, outputs, frames);
  session->computing += processor_time() - start;
  session->position += frames;
}

static void interleave(Session *session, uint32_t frames) {
  const RenderRequest *const request = session->request;
  const uint32_t channels = request->channels;
  for (uint32_t channel = 0; channel < channels; channel++) {
    const float *const samples = session->planar[request->mics[channel]];
    for (uint32_t frame = 0; frame < frames; frame++) {
      const double sample = request->gain * (double)samples[frame];
      session->interleaved[frame * channels + channel] = sample;
      session->peak = fmax(session->peak, fabs(sample));
    }
  }
}

void session_play(Session *session, uint32_t frames) {
  process(session, session->outputs, frames);
  interleave(session, frames);
}

Outcome session_play_traced(Session *session, uint32_t frames, TraceFile *trace) {
  const double rate = session->request->model.sample_rate;
  Outcome outcome = OUTCOME_OK;
  for (uint32_t frame = 0; outcome == OUTCOME_OK && frame < frames; frame++) {
    float *outputs[TABOR_MAX_MICS];
    for (uint32_t mic = 0; mic < TABOR_MAX_MICS; mic++) {
      outputs[mic] = session->outputs[mic] ? session->outputs[mic] + frame : NULL;
    }
    process(session, outputs, 1);
    outcome = trace_file_row(trace, session->position / rate, session->drum);
  }
  interleave(session, frames);
  return outcome;
}

void session_free(Session *session) {
  tabor_drum_destroy(session->drum);
  session->drum = NULL;
}
