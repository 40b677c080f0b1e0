/* SPDX-License-Identifier: MIT */
/**
 * @file render.c
 * `tabor render`: plays a drum into a sound file.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "command.h"
#include "drum_source.h"
#include "render_report.h"
#include "ring_out.h"
#include "sound_files.h"
#include "spool.h"

#define NORMAL_PEAK_DB (-1.0) /* of --normalize */

/* A rendering under way. */
typedef struct Rendering {
  RenderRequest request;
  Session session;
  SoundFiles sounds;
  Spool spool; /* in use while the gain is not known */
  TraceFile trace;
  RingOut ring_out;
  bool shows_progress;
} Rendering;

static void show_progress(const Rendering *rendering) {
  const uint32_t rate = rendering->request.audio.rate;
  const uint32_t position = rendering->session.position;
  if (rendering->shows_progress && position % rate < RING_OUT_BLOCK) {
    (void)fprintf(stderr, "\r%u s ", (unsigned)(position / rate));
  }
}

static void clear_progress(const Rendering *rendering) {
  if (rendering->shows_progress) (void)fputs("\r            \r", stderr);
}

static Outcome play_block(Rendering *rendering, uint32_t frames) {
  Session *const session = &rendering->session;
  Outcome outcome = OUTCOME_OK;
  if (rendering->request.has_trace) {
    outcome = session_play_traced(session, frames, &rendering->trace);
  } else {
    session_play(session, frames);
  }
  if (outcome != OUTCOME_OK) return outcome;
  if (rendering->request.normalize) {
    return spool_write(&rendering->spool, session->interleaved,
                       (size_t)frames * rendering->request.channels);
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
    show_progress(rendering);
  }
  clear_progress(rendering);
  return outcome;
}

/* The gain that gives the whole sound its peak; silence stays as it is. */
static void choose_gain(Rendering *rendering) {
  RenderRequest *const request = &rendering->request;
  Session *const session = &rendering->session;
  if (session->peak == 0) return;
  request->gain = pow(10, NORMAL_PEAK_DB / 20) / session->peak;
  request->gain_db = 20 * log10(request->gain);
  session->peak *= request->gain;
}

/* Writes what was set aside, with its gain. */
static Outcome write_normalized(Rendering *rendering) {
  const RenderRequest *const request = &rendering->request;
  Session *const session = &rendering->session;
  choose_gain(rendering);
  Outcome outcome = spool_rewind(&rendering->spool);
  for (uint32_t left = session->position; left > 0 && outcome == OUTCOME_OK;) {
    const uint32_t frames = left < SESSION_BLOCK ? left : SESSION_BLOCK;
    const size_t samples = (size_t)frames * request->channels;
    outcome = spool_read(&rendering->spool, session->interleaved, samples);
    for (size_t i = 0; i < samples; i++) session->interleaved[i] *= request->gain;
    if (outcome == OUTCOME_OK) {
      outcome = sound_files_write(&rendering->sounds, session->interleaved, frames);
    }
    left -= frames;
  }
  return outcome;
}

static void prepare_length(Rendering *rendering) {
  RenderRequest *const request = &rendering->request;
  rendering->ring_out = ring_out_begin(request->frames, strokes_last_frame(&request->strokes),
                                       request->model.sample_rate);
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
  RenderRequest *const request = &rendering->request;
  Outcome outcome = open_outputs(request);
  if (outcome == OUTCOME_OK) {
    outcome = sound_files_open(&rendering->sounds, &request->audio, request->outputs,
                               request->output_count);
  }
  if (outcome == OUTCOME_OK && request->has_trace) {
    outcome = trace_file_open(&rendering->trace, &request->trace);
  }
  if (outcome == OUTCOME_OK && request->normalize) outcome = spool_open(&rendering->spool);
  return outcome;
}

/* All files are completed and checked before the first appears. */
static Outcome deliver_files(Rendering *rendering) {
  RenderRequest *const request = &rendering->request;
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
  const RenderRequest *const request = &rendering->request;
  if (!rendering->ring_out.sounding || request->frames > 0 || request->quiet) return;
  note(
    "the drum still sounds where the file ends, %g s after the last stroke; --duration gives more",
    RING_OUT_MOST_TIME);
}

static Outcome render(const Arguments *arguments, Rendering *rendering) {
  Outcome outcome = render_request_read(arguments, &rendering->request);
  if (outcome != OUTCOME_OK) return outcome;
  rendering->shows_progress = !rendering->request.quiet && isatty(STDERR_FILENO);
  prepare_length(rendering);
  outcome = open_files(rendering);
  if (outcome == OUTCOME_OK) outcome = session_open(&rendering->session, &rendering->request);
  if (outcome == OUTCOME_OK) outcome = play(rendering);
  if (outcome == OUTCOME_OK && rendering->request.normalize) outcome = write_normalized(rendering);
  if (outcome == OUTCOME_OK) outcome = deliver_files(rendering);
  if (outcome == OUTCOME_OK) note_cut(rendering);
  if (outcome == OUTCOME_OK) outcome = render_report(&rendering->session);
  return outcome;
}

static Outcome run(const Arguments *arguments) {
  Rendering *const rendering = calloc(1, sizeof *rendering);
  if (!rendering) return fail_memory();
  const Outcome outcome = render(arguments, rendering);
  session_free(&rendering->session);
  sound_files_free(&rendering->sounds);
  spool_free(&rendering->spool);
  trace_file_free(&rendering->trace);
  render_request_free(&rendering->request);
  free(rendering);
  return outcome;
}

static const char notes[] =
  "A stroke is written --strike time=0,velocity=2.5,radius=0.05,angle=30,striker=stick:\n"
  "  time       when [s], 0 to 3600\n"
  "  velocity   how fast [m/s], 0.01 to 30, or midi=1..127 for 0.3 to 12 m/s\n"
  "  radius     how far from the centre [m], or in per cent of the head, as 80%\n"
  "  angle      in which direction [degrees], counter-clockwise from +x\n"
  "  striker    one of the preset's, by name\n"
  "  technique  normal\n"
  "Fields left out are the preset's; a time left out is 0.\n"
  "\n"
  "--events reads a stroke a line, as comma-separated values; the first line names the columns:\n"
  "  time,velocity,radius,striker\n"
  "  0,2.5,30%,stick\n"
  "  0.5,1,,\n"
  "Any of the fields above, midi too, in any order; empty fields are the preset's. Lines may come\n"
  "in any order of time; those that begin with '#' are comments. Further --events and --strike\n"
  "add to them.\n"
  "\n" PRESET_NOTES "'tabor show' lists the keys for --set.\n";

const Command render_command = {
  .name = "render",
  .operand = "[PRESET]",
  .summary = "Play a drum into a sound file",
  .notes = notes,
  .options = render_options,
  .run = run,
};
