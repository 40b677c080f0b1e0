/* SPDX-License-Identifier: MIT */
#include "play/live_session.h"

#include <math.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "base/interrupt.h"
#include "base/stopwatch.h"
#include "drums/drum_args.h"
#include "strokes/stroke_options.h"

#define LOOK_AHEAD 1.0 /* [s] by which a score is known to the player */
#define HALT_TIME 0.3  /* [s] that the audio thread may take to come back */
#define STALL_TIME 1.5 /* [s] without a block after which the device is gone */
#define CLOSE_TIME 1.0 /* [s] that the device may take to let go */
#define MOST_TURN 0.1  /* [s] of one turn of the user's thread, longer ones are others' fault */
#define SIGNALLED 128  /* exit status of a program that a signal ended, less its number */

/* ---- opening -------------------------------------------------------------------------------- */

static Outcome open_device(Performance *performance) {
  PlayRequest *const request = performance->request;
  const Outcome outcome =
    request->backend->open(&request->device, &performance->stream, &performance->facts);
  performance->is_lost = outcome == OUTCOME_FAILED;
  request->model.sample_rate = performance->facts.rate;
  request->audio.rate = (uint32_t)lround(performance->facts.rate);
  return outcome;
}

/* Without a clock there is nobody to play: then it is as a rendering, with the preset's own stroke. */
static Outcome read_strokes(Performance *performance, Strokes *strokes) {
  PlayRequest *const request = performance->request;
  *strokes = (Strokes){0};
  if (!arguments_has(request->arguments, "events") && !request->backend->waits) return OUTCOME_OK;
  const Outcome outcome =
    strokes_read(request->arguments, &request->def, request->model.sample_rate, strokes);
  for (size_t i = 0; i < strokes->count; i++) {
    humanize(&request->humanizer, request->def.shell.radius, &strokes->events[i]);
  }
  return outcome;
}

static Outcome add_song(Performance *performance) {
  PlayRequest *const request = performance->request;
  MidiSong *const song = &request->song;
  Outcome outcome =
    midi_song_compose(song, &request->midi_map, &request->def, request->model.sample_rate);
  for (size_t i = 0; i < song->count && outcome == OUTCOME_OK; i++) {
    const MidiSongItem *const item = &song->items[i];
    Cue cue = play_midi_cue(&item->action, item->frame);
    humanize(&request->humanizer, item->head_radius, &cue.message.event);
    outcome = score_add(&performance->score, &cue);
  }
  return outcome;
}

/* As in rendering, what would not be heard is a mistake. */
static Outcome check_duration(const Performance *performance) {
  const PlayRequest *const request = performance->request;
  const double rate = request->model.sample_rate,
               last = (double)score_last_stroke(&performance->score);
  if (request->duration == 0 || last < round(request->duration * rate)) return OUTCOME_OK;
  return refuse("--duration '%.80s': too short; the last stroke comes at %.10g s",
                arguments_value(request->arguments, "duration"), last / rate);
}

static Outcome read_score(Performance *performance) {
  Strokes strokes;
  Outcome outcome = read_strokes(performance, &strokes);
  if (outcome == OUTCOME_OK) outcome = score_add_strokes(&performance->score, &strokes);
  if (outcome == OUTCOME_OK) outcome = add_song(performance);
  strokes_free(&strokes);
  score_sort(&performance->score);
  return outcome == OUTCOME_OK ? check_duration(performance) : outcome;
}

static Outcome create_drum(Performance *performance) {
  const PlayRequest *const request = performance->request;
  DrumChangesSetup setup = {.preset = request->preset,
                            .is_listed = drum_listed_preset(request->arguments) >= 0,
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
  setup.last_event = (uint32_t)score_last_frame(&performance->score);
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
  if (outcome == OUTCOME_OK && !request->backend->waits) {
    outcome =
      play_midi_open(request, performance->player, performance->changes, &performance->midi);
  }
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
  score_feed(&performance->score, performance->player, performance->changes, position + frames);
  if (performance->recorder) recorder_wait(performance->recorder, frames);
  return true;
}

static void feed(Performance *performance) {
  if (performance->request->backend->waits) return; /* its own thread does it */
  const double ahead = LOOK_AHEAD * performance->request->model.sample_rate;
  score_feed(&performance->score, performance->player, performance->changes,
             player_position(performance->player) + (uint64_t)ahead);
}

/* Whether the device goes on asking, as seen by the user's thread. */
typedef struct Pulse {
  double seen;       /* when last looked [s] */
  double silent;     /* for how long it has not asked [s] */
  uint64_t position; /* how far it was */
} Pulse;

/* True while the device goes on asking; one that has been silent for STALL_TIME is gone, too. */
static bool is_alive(const Performance *performance, Pulse *pulse) {
  const Backend *const backend = performance->request->backend;
  const double now = stopwatch_seconds(CLOCK_MONOTONIC);
  const uint64_t position = player_position(performance->player);
  /* a turn of this thread that took long, as when the program was suspended, counts as a short one */
  pulse->silent += fmin(now - pulse->seen, MOST_TURN);
  pulse->seen = now;
  if (position != pulse->position || backend->waits) pulse->silent = 0;
  pulse->position = position;
  return backend->is_running(performance->stream) && pulse->silent < STALL_TIME;
}

/* Once the first block has been played, everything is known. */
static void announce(Performance *performance) {
  const PlayRequest *const request = performance->request;
  const BackendFacts *const facts = &performance->facts;
  const uint32_t buffer = player_buffer(performance->player);
  performance->is_urgent = player_raise_priority(performance->player);
  if (request->quiet || request->backend->waits) return;
  if (request->device.rate > 0 && facts->rate != request->device.rate) {
    note("'%s' runs at %.10g Hz, not at %.10g", facts->device, facts->rate, request->device.rate);
  }
  if (buffer != request->device.buffer) {
    note("'%s' asks for %u frames at once, not for %u", facts->device, (unsigned)buffer,
         (unsigned)request->device.buffer);
  }
  note("%s on '%s': %.10g Hz, %u frames at once, %.1f ms from a stroke to its sound",
       request->preset, facts->device, facts->rate, (unsigned)buffer,
       1000 * performance_latency(performance));
  if (!performance->is_urgent) {
    note(
      "the sound has no real-time priority, which this system does not permit: there may be gaps");
  }
}

/* Until there is a reason to stop. */
static Outcome take_turns(Performance *performance, const PerformanceTurn *turn) {
  Player *const player = performance->player;
  Pulse pulse = {.seen = stopwatch_seconds(CLOCK_MONOTONIC)};
  bool announced = false;
  while (!player_is_over(player)) {
    feed(performance);
    if (interrupt_caught() != 0) return (Outcome)(SIGNALLED + interrupt_caught());
    if (!turn->take(turn->context)) break;
    if (!is_alive(performance, &pulse) && !player_is_over(player)) {
      performance->is_lost = true;
      return fail("'%s' is gone: it asks for no more sound", performance->facts.device);
    }
    if (!announced && pulse.position > 0) {
      announce(performance);
      announced = true;
    }
  }
  return OUTCOME_OK;
}

Outcome performance_run(Performance *performance, const PerformanceTurn *turn) {
  const BackendClient client = {.process = process, .prepare = prepare, .context = performance};
  interrupt_catch();
  feed(performance);
  const Outcome outcome = performance->request->backend->start(performance->stream, &client);
  performance->is_lost = outcome != OUTCOME_OK;
  return outcome == OUTCOME_OK ? take_turns(performance, turn) : outcome;
}

/* ---- looking -------------------------------------------------------------------------------- */

/* An event waits for one block, and then the device for what it holds back. */
double performance_latency(const Performance *performance) {
  const BackendFacts *const facts = &performance->facts;
  return player_buffer(performance->player) / facts->rate + facts->latency;
}

void performance_status(Performance *performance, PlayStatus *status) {
  *status = (PlayStatus){.buffer = player_buffer(performance->player),
                         .latency = performance_latency(performance)};
  memcpy(status->device, performance->facts.device, sizeof status->device);
  player_status(performance->player, status);
  drum_changes_status(performance->changes, status);
  MidiInputStatus midi;
  play_midi_status(performance->midi, &midi);
  status->dropped += midi.dropped;
  status->ignored_notes = play_midi_ignored(performance->midi);
}

/* ---- closing -------------------------------------------------------------------------------- */

Outcome performance_finish(Performance *performance) {
  if (performance->player) (void)player_halt(performance->player, HALT_TIME);
  Recorder *const recorder = performance->recorder;
  uint64_t kept = 0;
  performance->recorder = NULL;
  const Outcome outcome = recorder_finish(recorder, &kept);
  if (outcome == OUTCOME_OK) return outcome;
  performance->unwritten = player_position(performance->player) - kept;
  return outcome;
}

/* A device being closed, in a thread of its own. */
typedef struct Closing {
  const Backend *backend;
  BackendStream *stream;
  atomic_bool done;
} Closing;

static void *close_stream(void *context) {
  Closing *const closing = context;
  closing->backend->close(closing->stream);
  atomic_store(&closing->done, true);
  return NULL;
}

static void pause_briefly(void) {
  const struct timespec moment = {.tv_nsec = 2000000};
  (void)nanosleep(&moment, NULL);
}

/* Nothing may run any more that a thread might hang in: no handlers of exit(), no destructors. */
static void leave(Outcome outcome) {
  (void)fflush(stdout);
  _exit((int)outcome);
}

static void close_device(Performance *performance, Outcome outcome) {
  Closing closing = {.backend = performance->request->backend, .stream = performance->stream};
  pthread_t thread;
  const double start = stopwatch_seconds(CLOCK_MONOTONIC);
  if (pthread_create(&thread, NULL, close_stream, &closing) != 0) {
    (void)close_stream(&closing);
    return;
  }
  while (!atomic_load(&closing.done)) {
    if (stopwatch_seconds(CLOCK_MONOTONIC) - start > CLOSE_TIME) {
      warn("'%s' does not let go; left as it is", performance->facts.device);
      leave(outcome);
    }
    pause_briefly();
  }
  (void)pthread_join(thread, NULL);
}

void performance_close(Performance *performance, Outcome outcome) {
  (void)performance_finish(performance); /* nothing, unless opening failed */
  if (performance->is_lost) leave(outcome);
  play_midi_close(performance->midi);
  close_device(performance, outcome);
  drum_changes_stop(performance->changes);
  player_destroy(performance->player);
  drum_changes_destroy(performance->changes);
  score_free(&performance->score);
}
