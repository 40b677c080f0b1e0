/* SPDX-License-Identifier: MIT */
#include "performance.h"

#include <math.h>
#include <string.h>
#include <time.h>

#include "drum_source.h"

#define LOOK_AHEAD 1.0 /* [s] by which a score is known to the player */
#define HALT_TIME 0.5  /* [s] that the audio thread may take to come back */

/* ---- opening -------------------------------------------------------------------------------- */

static Outcome open_device(Performance *performance) {
  PlayRequest *const request = performance->request;
  const Outcome outcome =
    request->backend->open(&request->device, &performance->stream, &performance->facts);
  request->model.sample_rate = performance->facts.rate;
  request->audio.rate = (uint32_t)lround(performance->facts.rate);
  return outcome;
}

/* Without a clock there is nobody to play: then it is as a rendering, with the preset's own stroke. */
static Outcome read_score(Performance *performance) {
  const PlayRequest *const request = performance->request;
  const bool given = arguments_has(request->arguments, "events");
  performance->score = (Score){.strokes = &performance->strokes};
  performance->strokes = (Strokes){.rate = request->model.sample_rate};
  if (!given && !request->backend->waits) return OUTCOME_OK;
  return strokes_read(request->arguments, &request->def, request->model.sample_rate,
                      &performance->strokes);
}

static Outcome create_drum(Performance *performance) {
  const PlayRequest *const request = performance->request;
  DrumChangesSetup setup = {.preset = request->preset,
                            .def = &request->def,
                            .options = request->model,
                            .channels = request->channels,
                            .waits = request->backend->waits};
  memcpy(setup.mics, request->mics, sizeof setup.mics);
  return drum_changes_create(&setup, &performance->changes);
}

static Outcome create_player(Performance *performance) {
  const PlayRequest *const request = performance->request;
  PlayerSetup setup = {
    .drum = drum_changes_drum(performance->changes),
    .rate = request->model.sample_rate,
    .channels = request->channels,
    .width = performance->facts.width,
    .buffer = performance->facts.buffer,
    .gain = request->gain,
    .records = request->records,
    .frames = (uint64_t)llround(request->duration * request->model.sample_rate),
    .dies_away = request->backend->waits,
  };
  memcpy(setup.mics, request->mics, sizeof setup.mics);
  if (performance->strokes.count > 0) setup.last_event = strokes_last_frame(&performance->strokes);
  const Outcome outcome = player_create(&setup, &performance->player);
  if (outcome != OUTCOME_OK) return outcome;
  return drum_changes_start(performance->changes, performance->player);
}

static Outcome start_recorder(Performance *performance) {
  PlayRequest *const request = performance->request;
  if (!request->records) return OUTCOME_OK;
  request->audio.most_frames = player_most_frames(performance->player);
  return recorder_start(&request->audio, &request->record, performance->player,
                        &performance->recorder);
}

Outcome performance_open(Performance *performance, PlayRequest *request) {
  memset(performance, 0, sizeof *performance);
  performance->request = request;
  Outcome outcome = open_device(performance);
  if (outcome == OUTCOME_OK) outcome = read_score(performance);
  if (outcome == OUTCOME_OK) outcome = create_drum(performance);
  if (outcome == OUTCOME_OK) outcome = create_player(performance);
  if (outcome == OUTCOME_OK) outcome = start_recorder(performance);
  return outcome;
}

/* ---- playing -------------------------------------------------------------------------------- */

static bool process(void *context, float *samples, uint32_t frames, double now, bool gap) {
  const Performance *const performance = context;
  return player_process(performance->player, samples, frames, now, gap);
}

/* Nothing is in a hurry here: the block waits for what comes within it, and for the disk. */
static bool prepare(void *context, uint32_t frames) {
  Performance *const performance = context;
  const uint64_t position = player_position(performance->player);
  score_feed(&performance->score, performance->player, position + frames);
  if (performance->recorder) recorder_wait(performance->recorder, frames);
  return true;
}

static void feed(Performance *performance) {
  if (performance->request->backend->waits) return; /* its own thread does it */
  const double ahead = LOOK_AHEAD * performance->request->model.sample_rate;
  score_feed(&performance->score, performance->player,
             player_position(performance->player) + (uint64_t)ahead);
}

Outcome performance_run(Performance *performance) {
  const struct timespec moment = {.tv_nsec = 10000000};
  const Backend *const backend = performance->request->backend;
  const BackendClient client = {.process = process, .prepare = prepare, .context = performance};
  feed(performance);
  const Outcome outcome = backend->start(performance->stream, &client);
  if (outcome != OUTCOME_OK) return outcome;
  while (!player_is_over(performance->player) && backend->is_running(performance->stream)) {
    feed(performance);
    (void)nanosleep(&moment, NULL);
  }
  return OUTCOME_OK;
}

/* ---- closing -------------------------------------------------------------------------------- */

Outcome performance_close(Performance *performance) {
  if (performance->player) (void)player_halt(performance->player, HALT_TIME);
  const Outcome outcome = recorder_finish(performance->recorder);
  if (performance->stream) performance->request->backend->close(performance->stream);
  drum_changes_stop(performance->changes);
  player_destroy(performance->player);
  drum_changes_destroy(performance->changes);
  strokes_free(&performance->strokes);
  return outcome;
}
