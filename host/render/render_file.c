/* SPDX-License-Identifier: MIT */
#include "render/render_file.h"

#include <math.h>
#include <stdlib.h>

#include "files/sample_spool.h"
#include "files/sound_files.h"
#include "render/render_report.h"
#include "sound/ring_out.h"

#define NORMAL_PEAK_DB (-1.0) /* of --normalize */

/* A rendering under way. */
typedef struct Rendering {
  RenderRequest *request;
  Session session;
  SoundFiles sounds;
  SampleSpool spool; /* in use while the gain is not known */
  TraceFile trace;
  RingOut ring_out;
  PlayedFn *played;
  void *context; /* of played */
} Rendering;

static Outcome play_block(Rendering *rendering, uint32_t frames) {
  Session *const session = &rendering->session;
  Outcome outcome = OUTCOME_OK;
  if (rendering->request->has_trace) {
    outcome = session_play_traced(session, frames, &rendering->trace);
  } else {
    outcome = session_play(session, frames);
  }
  if (outcome != OUTCOME_OK) return outcome;
  if (rendering->request->normalize) {
    return sample_spool_write(&rendering->spool, session->interleaved,
                              (size_t)frames * rendering->request->channels);
  }
  return sound_files_write(&rendering->sounds, session->interleaved, frames);
}

static Outcome play(Rendering *rendering) {
  const Session *const session = &rendering->session;
  RingOut *const ring_out = &rendering->ring_out;
  Outcome outcome = OUTCOME_OK;
  bool over = false;
  while (outcome == OUTCOME_OK && !over) {
    const uint32_t left = ring_out->most - session->position;
    outcome = play_block(rendering, left < RING_OUT_BLOCK ? left : RING_OUT_BLOCK);
    over = ring_out_is_over(ring_out, session->position, session->drum);
    rendering->played(rendering->context, session->position);
  }
  return outcome;
}

/* The gain that gives the whole sound its peak; silence stays as it is. */
static void choose_gain(Rendering *rendering) {
  RenderRequest *const request = rendering->request;
  Session *const session = &rendering->session;
  if (session->peak == 0) return;
  request->gain = pow(10, NORMAL_PEAK_DB / 20) / session->peak;
  request->gain_db = 20 * log10(request->gain);
  session->peak *= request->gain;
}

/* Writes what was set aside, with its gain. */
static Outcome write_normalized(Rendering *rendering) {
  const RenderRequest *const request = rendering->request;
  Session *const session = &rendering->session;
  choose_gain(rendering);
  Outcome outcome = sample_spool_rewind(&rendering->spool);
  for (uint32_t left = session->position; left > 0 && outcome == OUTCOME_OK;) {
    const uint32_t frames = left < SESSION_BLOCK ? left : SESSION_BLOCK;
    const size_t samples = (size_t)frames * request->channels;
    outcome = sample_spool_read(&rendering->spool, session->interleaved, samples);
    for (size_t i = 0; i < samples; i++) session->interleaved[i] *= request->gain;
    if (outcome == OUTCOME_OK) {
      outcome = sound_files_write(&rendering->sounds, session->interleaved, frames);
    }
    left -= frames;
  }
  return outcome;
}

static void prepare_length(Rendering *rendering) {
  RenderRequest *const request = rendering->request;
  rendering->ring_out =
    ring_out_begin(request->frames, render_request_last_frame(request), request->model.sample_rate);
  request->audio.most_frames = rendering->ring_out.most;
}

static Outcome open_outputs(RenderRequest *request) {
  const bool seeks = request->audio.container != AUDIO_AU;
  Outcome outcome = OUTCOME_OK;
  for (uint32_t i = 0; i < request->output_count && outcome == OUTCOME_OK; i++) {
    outcome = output_open(&request->outputs[i], seeks);
  }
  if (outcome == OUTCOME_OK && request->has_trace) outcome = output_open(&request->trace, false);
  return outcome;
}

static Outcome open_files(Rendering *rendering) {
  RenderRequest *const request = rendering->request;
  Outcome outcome = open_outputs(request);
  if (outcome == OUTCOME_OK) {
    outcome = sound_files_open(&rendering->sounds, &request->audio, request->outputs,
                               request->output_count);
  }
  if (outcome == OUTCOME_OK && request->has_trace) {
    outcome = trace_file_open(&rendering->trace, &request->trace);
  }
  if (outcome == OUTCOME_OK && request->normalize) outcome = sample_spool_open(&rendering->spool);
  return outcome;
}

/* All files are completed and checked before the first appears. */
static Outcome deliver_files(Rendering *rendering) {
  RenderRequest *const request = rendering->request;
  OutputFile *outputs[TABOR_MAX_MICS + 1];
  size_t count = 0;
  for (uint32_t i = 0; i < request->output_count; i++) outputs[count++] = &request->outputs[i];
  if (request->has_trace) outputs[count++] = &request->trace;
  Outcome outcome = sound_files_finish(&rendering->sounds);
  if (outcome == OUTCOME_OK && request->has_trace) outcome = trace_file_finish(&rendering->trace);
  for (size_t i = 0; i < count && outcome == OUTCOME_OK; i++) outcome = output_complete(outputs[i]);
  return outcome == OUTCOME_OK ? output_deliver(outputs, count) : outcome;
}

/* A length that was asked for needs no comment. */
static void note_cut(const Rendering *rendering) {
  const RenderRequest *const request = rendering->request;
  if (!rendering->ring_out.sounding || request->frames > 0 || request->quiet) return;
  note(
    "the drum still sounds where the file ends, %g s after the last stroke; --duration gives more",
    RING_OUT_MOST_TIME);
}

static Outcome render(Rendering *rendering, json_t **report) {
  prepare_length(rendering);
  Outcome outcome = open_files(rendering);
  if (outcome == OUTCOME_OK) outcome = session_open(&rendering->session, rendering->request);
  if (outcome == OUTCOME_OK) outcome = play(rendering);
  if (outcome == OUTCOME_OK && rendering->request->normalize) outcome = write_normalized(rendering);
  if (outcome == OUTCOME_OK) outcome = deliver_files(rendering);
  if (outcome == OUTCOME_OK) note_cut(rendering);
  if (outcome == OUTCOME_OK) outcome = render_report(&rendering->session, report);
  return outcome;
}

Outcome rendering_run(RenderRequest *request, PlayedFn *played, void *context, json_t **report) {
  Rendering *const rendering = calloc(1, sizeof *rendering);
  if (!rendering) return fail_memory();
  rendering->request = request;
  rendering->played = played;
  rendering->context = context;
  const Outcome outcome = render(rendering, report);
  session_free(&rendering->session);
  sound_files_free(&rendering->sounds);
  sample_spool_free(&rendering->spool);
  trace_file_free(&rendering->trace);
  free(rendering);
  return outcome;
}
