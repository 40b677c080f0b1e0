/* SPDX-License-Identifier: MIT */
#include "play/live_session.h"

#include <math.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "base/interrupt.h"
#include "drums/drum_args.h"
#include "drums/model_build.h"
#include "kit/kit_build.h"
#include "kit/kit_sample_files.h"
#include "kit/kit_song_input.h"
#include "platform/clock.h"
#include "platform/process.h"
#include "strokes/duration.h"
#include "strokes/stroke_options.h"

#define LOOK_AHEAD 1.0 /* [s] by which cues are known to the player */
#define HALT_TIME 0.3  /* [s] that the audio thread may take to come back */
#define STALL_TIME 1.5 /* [s] without a block after which the device is gone */
#define CLOSE_TIME 1.0 /* [s] that the device may take to let go */
#define MOST_TURN 0.1  /* [s] of one turn of the user's thread, longer ones are others' fault */
#define SIGNALLED 128  /* exit status of a program that a signal ended, less its number */

/* ---- opening -------------------------------------------------------------------------------- */

static Outcome open_device(LiveSession *session) {
  PlayRequest *const request = session->request;
  const Outcome outcome =
    request->backend->open(&request->device, &session->stream, &session->facts);
  session->is_lost = outcome == OUTCOME_FAILED;
  request->model.sample_rate = session->facts.rate;
  request->record.audio.rate = (uint32_t)lround(session->facts.rate);
  return outcome;
}

/* Without a clock there is nobody to play: then it is as a rendering, with the preset's own stroke.
 */
static Outcome read_strokes(LiveSession *session, Strokes *strokes) {
  PlayRequest *const request = session->request;
  *strokes = (Strokes){0};
  if (!arguments_has(request->arguments, "events") && !request->backend->waits) return OUTCOME_OK;
  const Outcome outcome =
    strokes_read(request->arguments, &request->def, request->model.sample_rate, strokes);
  for (size_t i = 0; i < strokes->count; i++) {
    humanize(&request->humanizer, request->def.shell.radius, &strokes->events[i]);
  }
  return outcome;
}

static Outcome add_kit_events(LiveSession *session, const KitSong *song) {
  Outcome outcome = OUTCOME_OK;
  for (size_t i = 0; i < song->count && outcome == OUTCOME_OK; i++) {
    const Cue cue = {.message = player_message_from_kit(&song->events[i])};
    outcome = cue_queue_add(&session->queue, &cue);
  }
  return outcome;
}

static Outcome add_kit_song(LiveSession *session) {
  const PlayRequest *const request = session->request;
  const char *const name = arguments_value(request->arguments, "midi-file");
  KitMidi *const midi = malloc(sizeof *midi);
  if (!midi) return fail_memory();
  KitSong song = {0};
  play_request_kit_midi(request, midi);
  Outcome outcome = kit_song_read(request->arguments, request->kit, midi, request->humanizer,
                                  request->model.sample_rate, &song);
  if (outcome == OUTCOME_OK && name && !request->quiet) kit_song_note(name, midi);
  if (outcome == OUTCOME_OK) outcome = add_kit_events(session, &song);
  session->song_ignored = kit_midi_unknown(midi);
  kit_song_free(&song);
  free(midi);
  return outcome;
}

static Outcome add_song(LiveSession *session) {
  PlayRequest *const request = session->request;
  MidiSong *const song = &request->song;
  Outcome outcome = OUTCOME_OK;
  if (!midi_song_compose(song, &request->midi_map, &request->def, request->model.sample_rate)) {
    return fail_memory();
  }
  for (size_t i = 0; i < song->count && outcome == OUTCOME_OK; i++) {
    const MidiSongItem *const item = &song->items[i];
    Cue cue = play_midi_cue(&item->action, item->frame);
    humanize(&request->humanizer, item->head_radius, &cue.message.event);
    outcome = cue_queue_add(&session->queue, &cue);
  }
  session->song_ignored = song->counts.ignored_notes;
  return outcome;
}

static Outcome check_duration(const LiveSession *session) {
  const PlayRequest *const request = session->request;
  const double rate = request->model.sample_rate,
               last = (double)cue_queue_last_stroke(&session->queue);
  if (request->duration == 0 || last < round(request->duration * rate)) return OUTCOME_OK;
  return duration_too_short(request->arguments, arguments_has(request->arguments, "midi-file"),
                            last / rate, request->quiet);
}

static Outcome read_score(LiveSession *session) {
  Strokes strokes;
  if (session->request->kit) {
    const Outcome outcome = add_kit_song(session);
    cue_queue_sort(&session->queue);
    return outcome == OUTCOME_OK ? check_duration(session) : outcome;
  }
  Outcome outcome = read_strokes(session, &strokes);
  if (outcome == OUTCOME_OK) outcome = cue_queue_add_strokes(&session->queue, &strokes);
  if (outcome == OUTCOME_OK) outcome = add_song(session);
  strokes_free(&strokes);
  cue_queue_sort(&session->queue);
  return outcome == OUTCOME_OK ? check_duration(session) : outcome;
}

static Outcome create_builder(LiveSession *session, const ModelBuilderSetup *part) {
  ModelBuilderSetup setup = *part;
  setup.options = session->request->model;
  setup.sending = &session->sending;
  setup.waits = session->request->backend->waits;
  return model_builder_create(&setup, &session->builders[session->drum_count++]);
}

static Outcome create_drum(LiveSession *session) {
  const PlayRequest *const request = session->request;
  ModelBuilderSetup setup = {.preset = request->preset,
                             .is_listed = drum_listed_preset(request->arguments) >= 0,
                             .def = &request->def};
  TaborError error;
  Outcome outcome = model_build(setup.def, &request->model, &setup.model);
  if (outcome == OUTCOME_OK) outcome = create_builder(session, &setup);
  if (outcome == OUTCOME_OK && tabor_drum_create(setup.model, &session->drum, &error) != TABOR_OK) {
    outcome = report_engine_error(&error);
  }
  tabor_model_release(setup.model);
  return outcome;
}

static Outcome create_kit(LiveSession *session) {
  PlayRequest *const request = session->request;
  const TaborKitDef *const kit = request->kit;
  TaborModel *models[TABOR_KIT_DRUMS] = {NULL};
  TaborError error;
  Outcome outcome = kit_models_build(kit, &request->model, process_processors(), models);
  for (uint32_t i = 0; i < kit->drum_count && outcome == OUTCOME_OK; i++) {
    const TaborDrumDef *const def = &kit->drum[i].def;
    const ModelBuilderSetup setup = {
      .preset = def->name, .def = def, .model = models[i], .kit = kit, .drum = i};
    outcome = create_builder(session, &setup);
  }
  if (outcome == OUTCOME_OK && tabor_kit_create(kit, models, &session->kit, &error) != TABOR_OK) {
    outcome = report_engine_error(&error);
  }
  if (outcome == OUTCOME_OK) outcome = kit_sample_files_read(session->kit);
  session->threads = kit_threads_begin(request->threads, !request->backend->waits, NULL);
  if (session->kit) kit_threads_serve(session->threads, session->kit);
  kit_models_release(models);
  return outcome;
}

static Outcome create_instrument(LiveSession *session) {
  return session->request->kit ? create_kit(session) : create_drum(session);
}

static Outcome start_builders(LiveSession *session) {
  Outcome outcome = OUTCOME_OK;
  for (uint32_t i = 0; i < session->drum_count && outcome == OUTCOME_OK; i++) {
    outcome = model_builder_start(session->builders[i], session->player);
  }
  return outcome;
}

static void stop_builders(const LiveSession *session) {
  for (uint32_t i = 0; i < session->drum_count; i++) model_builder_stop(session->builders[i]);
}

static Outcome create_player(LiveSession *session) {
  const PlayRequest *const request = session->request;
  PlayerSetup setup = {
    .drum = session->drum,
    .def = &request->def,
    .kit = session->kit,
    .rate = request->model.sample_rate,
    .channels = request->channels,
    .width = session->facts.width,
    .buffer = session->facts.buffer,
    .gain = request->gain,
    .records = request->record.records,
    .logs = request->logs,
    .frames = (uint64_t)llround(request->duration * request->model.sample_rate),
    .dies_away = request->backend->waits,
  };
  memcpy(setup.mics, request->mics, sizeof setup.mics);
  setup.last_event = (uint32_t)cue_queue_last_frame(&session->queue);
  return player_create(&setup, &session->player);
}

static Outcome start_log(LiveSession *session) {
  PlayRequest *const request = session->request;
  if (!request->logs) return OUTCOME_OK;
  LogWriterSetup setup = {
    .player = session->player,
    .start = {.rate = request->model.sample_rate,
              .gain = request->gain,
              .channels = request->channels,
              .kit = request->kit},
    .model = tabor_drum_model(session->kit ? tabor_kit_drum(session->kit, 0) : session->drum),
    .preset = request->preset,
  };
  memcpy(setup.start.mics, request->mics, sizeof setup.start.mics);
  const Outcome outcome = log_writer_start(&setup, &request->log, &session->log);
  for (uint32_t i = 0; i < session->drum_count; i++) {
    model_builder_log(session->builders[i], session->log);
  }
  return outcome;
}

static Outcome start_recorder(LiveSession *session) {
  PlayRequest *const request = session->request;
  RecordRequest *const record = &request->record;
  if (!record->records) return OUTCOME_OK;
  record->audio.most_frames = player_most_frames(session->player);
  return take_writer_start(&record->audio, &record->output, player_recording(session->player),
                           &session->writer);
}

Outcome live_session_open(LiveSession *session, PlayRequest *request) {
  memset(session, 0, sizeof *session);
  session->request = request;
  (void)pthread_mutex_init(&session->sending, NULL);
  Outcome outcome = open_device(session);
  if (outcome == OUTCOME_OK) outcome = read_score(session);
  if (outcome == OUTCOME_OK) outcome = create_instrument(session);
  if (outcome == OUTCOME_OK) outcome = create_player(session);
  if (outcome == OUTCOME_OK) outcome = start_log(session);
  if (outcome == OUTCOME_OK) outcome = start_builders(session);
  if (outcome == OUTCOME_OK) outcome = start_recorder(session);
  if (outcome == OUTCOME_OK && !request->backend->waits) {
    outcome = play_midi_open(request, session->player, session->builders, &session->midi);
  }
  return outcome;
}

/* ---- playing -------------------------------------------------------------------------------- */

static bool process(void *context, float *samples, uint32_t frames, double now, bool gap) {
  const LiveSession *const session = context;
  return player_process(session->player, samples, frames, now, gap);
}

/* Nothing is in a hurry here: the block waits for what comes within it, and for the disk. */
static bool prepare(void *context, uint32_t frames) {
  LiveSession *const session = context;
  const uint64_t position = player_position(session->player);
  cue_queue_feed(&session->queue, session->player, session->builders[0], position + frames);
  if (session->writer) take_writer_wait(session->writer, frames);
  log_writer_wait(session->log);
  return true;
}

static void feed(LiveSession *session) {
  if (session->request->backend->waits) return; /* its own thread does it */
  const double ahead = LOOK_AHEAD * session->request->model.sample_rate;
  cue_queue_feed(&session->queue, session->player, session->builders[0],
                 player_position(session->player) + (uint64_t)ahead);
}

/* Whether the device goes on asking, as seen by the user's thread. */
typedef struct Pulse {
  double seen;       /* when last looked [s] */
  double silent;     /* for how long it has not asked [s] */
  uint64_t position; /* how far it was */
} Pulse;

/* True while the device goes on asking; one that has been silent for STALL_TIME is gone, too. */
static bool is_alive(const LiveSession *session, Pulse *pulse) {
  const Backend *const backend = session->request->backend;
  const double now = stopwatch_seconds(CLOCK_MONOTONIC);
  const uint64_t position = player_position(session->player);
  /* a turn of this thread that took long, as when the program was suspended, counts as a short one
   */
  pulse->silent += fmin(now - pulse->seen, MOST_TURN);
  pulse->seen = now;
  if (position != pulse->position || backend->waits) pulse->silent = 0;
  pulse->position = position;
  return backend->is_running(session->stream) && pulse->silent < STALL_TIME;
}

/* Once the first block has been played, everything is known. */
static void announce(LiveSession *session) {
  const PlayRequest *const request = session->request;
  const BackendFacts *const facts = &session->facts;
  const uint32_t buffer = player_buffer(session->player);
  session->is_urgent = player_raise_priority(session->player);
  if (request->quiet || request->backend->waits) return;
  if (request->device.rate > 0 && facts->rate != request->device.rate) {
    note("'%s' runs at %.10g Hz, not at %.10g", facts->device, facts->rate, request->device.rate);
  }
  if (buffer != request->device.buffer) {
    note("'%s' asks for %u frames at once, not for %u", facts->device, (unsigned)buffer,
         (unsigned)request->device.buffer);
  }
  note("%s%s on '%s': %.10g Hz, %u frames at once, %.1f ms from a stroke to its sound",
       request->kit ? "kit " : "", request->preset, facts->device, facts->rate, (unsigned)buffer,
       1000 * live_session_latency(session));
  if (!session->is_urgent) {
    note(
      "the sound has no real-time priority, which this system does not permit: there may be gaps");
  }
}

/* Until there is a reason to stop. */
static Outcome take_turns(LiveSession *session, const LiveSessionTurn *turn) {
  Player *const player = session->player;
  Pulse pulse = {.seen = stopwatch_seconds(CLOCK_MONOTONIC)};
  bool announced = false;
  while (!player_is_over(player)) {
    feed(session);
    if (interrupt_caught() != 0) return (Outcome)(SIGNALLED + interrupt_caught());
    if (!turn->take(turn->context)) break;
    if (!is_alive(session, &pulse) && !player_is_over(player)) {
      session->is_lost = true;
      return fail("'%s' is gone: it asks for no more sound", session->facts.device);
    }
    if (!announced && pulse.position > 0) {
      announce(session);
      announced = true;
    }
  }
  return OUTCOME_OK;
}

Outcome live_session_run(LiveSession *session, const LiveSessionTurn *turn) {
  const BackendClient client = {.process = process, .prepare = prepare, .context = session};
  interrupt_catch();
  feed(session);
  const Outcome outcome = session->request->backend->start(session->stream, &client);
  session->is_lost = outcome != OUTCOME_OK;
  return outcome == OUTCOME_OK ? take_turns(session, turn) : outcome;
}

/* ---- looking -------------------------------------------------------------------------------- */

/* An event waits for one block, and then the device for what it holds back. */
double live_session_latency(const LiveSession *session) {
  const BackendFacts *const facts = &session->facts;
  return player_buffer(session->player) / facts->rate + facts->latency;
}

void live_session_status(LiveSession *session, PlayStatus *status) {
  *status = (PlayStatus){.buffer = player_buffer(session->player),
                         .latency = live_session_latency(session)};
  memcpy(status->device, session->facts.device, sizeof status->device);
  player_status(session->player, status);
  for (uint32_t i = 0; i < session->drum_count; i++) {
    PlayStatus own;
    model_builder_status(session->builders[i], i == 0 ? status : &own);
    if (i > 0) status->building |= own.building;
  }
  if (session->kit)
    (void)snprintf(status->preset, sizeof status->preset, "%s", session->request->preset);
  MidiInputStatus midi;
  play_midi_status(session->midi, &midi);
  status->dropped += midi.dropped;
  status->ignored_notes = play_midi_ignored(session->midi);
}

/* ---- closing -------------------------------------------------------------------------------- */

static Outcome finish_recording(LiveSession *session) {
  TakeWriter *const writer = session->writer;
  uint64_t kept = 0;
  session->writer = NULL;
  const Outcome outcome = take_writer_finish(writer, &kept);
  if (outcome == OUTCOME_OK) return outcome;
  session->unwritten = player_position(session->player) - kept;
  return outcome;
}

static Outcome finish_log(LiveSession *session) {
  LogWriter *const log = session->log;
  session->log = NULL;
  if (log) stop_builders(session); /* they add models */
  return log_writer_finish(log);
}

Outcome live_session_finish(LiveSession *session) {
  if (session->player) (void)player_halt(session->player, HALT_TIME);
  const Outcome recording = finish_recording(session), log = finish_log(session);
  return recording != OUTCOME_OK ? recording : log;
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

static void close_device(LiveSession *session, Outcome outcome) {
  Closing closing = {.backend = session->request->backend, .stream = session->stream};
  pthread_t thread;
  const double start = stopwatch_seconds(CLOCK_MONOTONIC);
  if (pthread_create(&thread, NULL, close_stream, &closing) != 0) {
    (void)close_stream(&closing);
    return;
  }
  while (!atomic_load(&closing.done)) {
    if (stopwatch_seconds(CLOCK_MONOTONIC) - start > CLOSE_TIME) {
      warn("'%s' does not let go; left as it is", session->facts.device);
      leave(outcome);
    }
    pause_briefly();
  }
  (void)pthread_join(thread, NULL);
}

void live_session_close(LiveSession *session, Outcome outcome) {
  (void)live_session_finish(session); /* nothing, unless opening failed */
  if (session->is_lost) leave(outcome);
  play_midi_close(session->midi);
  close_device(session, outcome);
  stop_builders(session);
  player_destroy(session->player);
  tabor_drum_destroy(session->drum); /* before swaps whose former drums they may still play */
  tabor_kit_destroy(session->kit);
  kit_threads_end(session->threads);
  for (uint32_t i = 0; i < session->drum_count; i++) model_builder_destroy(session->builders[i]);
  (void)pthread_mutex_destroy(&session->sending);
  cue_queue_free(&session->queue);
}
