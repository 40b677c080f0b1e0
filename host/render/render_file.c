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
  OfflinePlayer player;
  SoundFiles sounds;
  SampleSpool spool; /* in use while the gain is not known */
  TraceFile trace;
  RingOut ring_out;
  PlayedFn *played;
  void *context; /* of played */
} Rendering;

static Outcome play_block(Rendering *rendering, uint32_t frames) {
  OfflinePlayer *const player = &rendering->player;
  Outcome outcome = OUTCOME_OK;
  if (rendering->request->has_trace) {
    outcome = offline_player_play_traced(player, frames, &rendering->trace);
  } else {
    outcome = offline_player_play(player, frames);
  }
  if (outcome != OUTCOME_OK) return outcome;
  if (rendering->request->normalize) {
    return sample_spool_write(&rendering->spool, player->interleaved,
                              (size_t)frames * rendering->request->channels);
  }
  return sound_files_write(&rendering->sounds, player->interleaved, frames);
}

static Outcome play(Rendering *rendering) {
  OfflinePlayer *const player = &rendering->player;
  RingOut *const ring_out = &rendering->ring_out;
  Outcome outcome = OUTCOME_OK;
  bool over = false;
  while (outcome == OUTCOME_OK && !over) {
    const uint32_t left = ring_out->most - player->position;
    outcome = play_block(rendering, left < RING_OUT_BLOCK ? left : RING_OUT_BLOCK);
    over = ring_out_is_over(ring_out, &player->core);
    rendering->played(rendering->context, player->position);
  }
  return outcome;
}

/* The gain that gives the whole sound its peak; silence stays as it is. */
static void choose_gain(Rendering *rendering) {
  RenderRequest *const request = rendering->request;
  OfflinePlayer *const player = &rendering->player;
  if (player->peak == 0) return;
  request->gain = pow(10, NORMAL_PEAK_DB / 20) / player->peak;
  request->gain_db = 20 * log10(request->gain);
  player->peak *= request->gain;
}

/* Writes what was set aside, with its gain. */
static Outcome write_normalized(Rendering *rendering) {
  const RenderRequest *const request = rendering->request;
  OfflinePlayer *const player = &rendering->player;
  choose_gain(rendering);
  Outcome outcome = sample_spool_rewind(&rendering->spool);
  for (uint32_t left = player->position; left > 0 && outcome == OUTCOME_OK;) {
    const uint32_t frames = left < OFFLINE_BLOCK ? left : OFFLINE_BLOCK;
    const size_t samples = (size_t)frames * request->channels;
    outcome = sample_spool_read(&rendering->spool, player->interleaved, samples);
    for (size_t i = 0; i < samples; i++) player->interleaved[i] *= request->gain;
    if (outcome == OUTCOME_OK) {
      outcome = sound_files_write(&rendering->sounds, player->interleaved, frames);
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
  OutputFile *outputs[SOUND_FILES_MOST + 1];
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
  note("the %s still sounds where the file ends, %g s after the last stroke; --duration gives more",
       request->kit ? "kit" : "drum", RING_OUT_MOST_TIME);
}

static Outcome render(Rendering *rendering, json_t **report) {
  prepare_length(rendering);
  Outcome outcome = open_files(rendering);
  if (outcome == OUTCOME_OK) outcome = offline_player_open(&rendering->player, rendering->request);
  if (outcome == OUTCOME_OK) outcome = play(rendering);
  if (outcome == OUTCOME_OK && rendering->request->normalize) outcome = write_normalized(rendering);
  if (outcome == OUTCOME_OK) outcome = deliver_files(rendering);
  if (outcome == OUTCOME_OK) note_cut(rendering);
  if (outcome == OUTCOME_OK) outcome = render_report(&rendering->player, report);
  return outcome;
}

Outcome render_file(RenderRequest *request, PlayedFn *played, void *context, json_t **report) {
  Rendering *const rendering = calloc(1, sizeof *rendering);
  if (!rendering) return fail_memory();
  rendering->request = request;
  rendering->played = played;
  rendering->context = context;
  const Outcome outcome = render(rendering, report);
  offline_player_free(&rendering->player);
  sound_files_free(&rendering->sounds);
  sample_spool_free(&rendering->spool);
  trace_file_free(&rendering->trace);
  free(rendering);
  return outcome;
}
