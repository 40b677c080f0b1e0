/* SPDX-License-Identifier: MIT */
/**
 * @file render.c
 * `tabor render`: plays a drum into a sound file.
 */
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "command.h"
#include "render_report.h"
#include "ring_out.h"

/* A rendering under way. */
typedef struct Rendering {
  RenderRequest request;
  Session session;
  AudioFile audio;
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
  return audio_file_write(&rendering->audio, session->interleaved, frames);
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

static void prepare_length(Rendering *rendering) {
  RenderRequest *const request = &rendering->request;
  rendering->ring_out = ring_out_begin(request->frames, strokes_last_frame(&request->strokes),
                                       request->model.sample_rate);
  request->audio.most_frames = rendering->ring_out.most;
}

static Outcome open_files(Rendering *rendering) {
  RenderRequest *const request = &rendering->request;
  const bool seeks = request->audio.container != AUDIO_AU;
  Outcome outcome = output_open(&request->output, seeks);
  if (outcome == OUTCOME_OK && request->has_trace) outcome = output_open(&request->trace, false);
  if (outcome == OUTCOME_OK) {
    outcome = audio_file_open(&rendering->audio, &request->audio, &request->output);
  }
  if (outcome == OUTCOME_OK && request->has_trace) {
    outcome = trace_file_open(&rendering->trace, &request->trace);
  }
  return outcome;
}

/* Both files are completed and checked before the first appears. */
static Outcome complete_files(Rendering *rendering) {
  RenderRequest *const request = &rendering->request;
  Outcome outcome = audio_file_finish(&rendering->audio);
  if (outcome == OUTCOME_OK && request->has_trace) outcome = trace_file_finish(&rendering->trace);
  if (outcome == OUTCOME_OK) outcome = output_complete(&request->output);
  if (outcome == OUTCOME_OK && request->has_trace) outcome = output_complete(&request->trace);
  return outcome;
}

static Outcome deliver_files(Rendering *rendering) {
  RenderRequest *const request = &rendering->request;
  Outcome outcome = complete_files(rendering);
  if (outcome == OUTCOME_OK) outcome = output_deliver(&request->output);
  if (outcome == OUTCOME_OK && request->has_trace) outcome = output_deliver(&request->trace);
  return outcome;
}

static Outcome render(const Arguments *arguments, Rendering *rendering) {
  Outcome outcome = render_request_read(arguments, &rendering->request);
  if (outcome != OUTCOME_OK) return outcome;
  rendering->shows_progress = !rendering->request.quiet && isatty(STDERR_FILENO);
  prepare_length(rendering);
  outcome = open_files(rendering);
  if (outcome == OUTCOME_OK) outcome = session_open(&rendering->session, &rendering->request);
  if (outcome == OUTCOME_OK) outcome = play(rendering);
  if (outcome == OUTCOME_OK) outcome = deliver_files(rendering);
  if (outcome == OUTCOME_OK) outcome = render_report(&rendering->session);
  return outcome;
}

static Outcome run(const Arguments *arguments) {
  Rendering *const rendering = calloc(1, sizeof *rendering);
  if (!rendering) return fail_memory();
  const Outcome outcome = render(arguments, rendering);
  session_free(&rendering->session);
  audio_file_free(&rendering->audio);
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
  "Fields left out are the preset's. PRESET is a name that 'tabor presets' lists, or a file:\n"
  "with a '/' in it, or ending in .ini. 'tabor show' lists the keys for --set.\n";

const Command render_command = {
  .name = "render",
  .operand = "[PRESET]",
  .summary = "Play a drum into a sound file",
  .notes = notes,
  .options = render_options,
  .run = run,
};
