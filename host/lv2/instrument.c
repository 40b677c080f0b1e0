/* SPDX-License-Identifier: MIT */
#include "lv2/instrument.h"

#include <lv2/core/lv2.h>
#include <lv2/core/lv2_util.h>
#include <lv2/midi/midi.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "lv2/sequence.h"
#include "lv2/uris.h"

#define LEAST_RATE 22050 /* [Hz] */
#define MOST_RATE 192000 /* [Hz] */
#define GLANCE 5000000   /* [ns] after which a thread of its own looks for work */
#define PAUSE 1000000    /* [ns] for another thread that is at work already */

/* ---- beginning ------------------------------------------------------------------------------ */

static void map_uris(Urids *urids, LV2_URID_Map *map) {
  urids->sequence = map->map(map->handle, LV2_ATOM__Sequence);
  urids->midi = map->map(map->handle, LV2_MIDI__MidiEvent);
  urids->atom_int = map->map(map->handle, LV2_ATOM__Int);
  urids->atom_float = map->map(map->handle, LV2_ATOM__Float);
  urids->atom_string = map->map(map->handle, LV2_ATOM__String);
  urids->version = map->map(map->handle, URI_STATE_VERSION);
  urids->definition = map->map(map->handle, URI_STATE_DEFINITION);
  for (uint32_t i = 0; i < KNOB_KEYS; i++) {
    char uri[128];
    (void)snprintf(uri, sizeof uri, "%s%s", URI_STATE_CONTROL, knobs[i].symbol);
    urids->controls[i] = map->map(map->handle, uri);
  }
}

static void sleep_for(long nanoseconds) {
  const struct timespec moment = {.tv_nsec = nanoseconds};
  (void)nanosleep(&moment, NULL);
}

/* Where the host has no worker. A thread that waited to be woken would have to be woken by a system call. */
static void *look_for_work(void *handle) {
  Instrument *const instrument = handle;
  while (!atomic_load(&instrument->stops)) {
    model_worker_work(&instrument->worker);
    sleep_for(GLANCE);
  }
  return NULL;
}

static void say(void *context, const char *line) {
  Instrument *const instrument = context;
  (void)lv2_log_error(&instrument->logger, "Tabor: %s\n", line);
}

static bool open(Instrument *instrument, double rate, bool stereo, LV2_URID_Map *map) {
  map_uris(&instrument->urids, map);
  instrument->worker.say = say;
  instrument->worker.context = instrument;
  if (!model_worker_begin(&instrument->worker, rate, stereo)) return false;
  for (uint32_t i = 0; i < KNOB_COUNT; i++) {
    instrument->ranges[i] = knob_range((KnobId)i, &instrument->worker.base);
  }
  if (!plugin_player_begin(&instrument->player, &instrument->worker, rate, stereo)) return false;
  if (instrument->schedule) return true;
  instrument->has_thread =
    pthread_create(&instrument->thread, NULL, look_for_work, instrument) == 0;
  return instrument->has_thread;
}

static void cleanup(LV2_Handle handle) {
  Instrument *const instrument = handle;
  atomic_store(&instrument->stops, true);
  if (instrument->has_thread) (void)pthread_join(instrument->thread, NULL);
  plugin_player_end(&instrument->player);
  model_worker_end(&instrument->worker);
  free(instrument);
}

static LV2_Handle instantiate(const LV2_Descriptor *descriptor, double rate, const char *bundle,
                              const LV2_Feature *const *features) {
  (void)bundle;
  LV2_URID_Map *map = NULL;
  Instrument *const instrument = calloc(1, sizeof *instrument);
  if (!instrument) return NULL;
  const char *const missing =
    lv2_features_query(features, LV2_LOG__log, &instrument->logger.log, false, LV2_URID__map, &map,
                       true, LV2_WORKER__schedule, &instrument->schedule, false, NULL);
  lv2_log_logger_set_map(&instrument->logger, map);
  const bool has_rate = rate >= LEAST_RATE && rate <= MOST_RATE; /* there are models for it */
  if (missing) {
    (void)lv2_log_error(&instrument->logger, "Tabor: the host lacks %s\n", missing);
  } else if (!has_rate) {
    (void)lv2_log_error(&instrument->logger, "Tabor: a sample rate of %g Hz; allowed: %d to %d\n",
                        rate, LEAST_RATE, MOST_RATE);
  }
  if (missing || !has_rate) {
    free(instrument);
    return NULL;
  }
  if (open(instrument, rate, strcmp(descriptor->URI, URI_DRUM) == 0, map)) return instrument;
  cleanup(instrument);
  return NULL;
}

static void connect_port(LV2_Handle handle, uint32_t number, void *data) {
  Instrument *const instrument = handle;
  const Port port = port_at(instrument->player.stereo, number);
  switch (port.kind) {
  case PORT_EVENTS: instrument->events = data; break;
  case PORT_OUTPUT: instrument->outputs.channels[port.index] = data; break;
  case PORT_FREEWHEEL: instrument->freewheel = data; break;
  case PORT_READY: instrument->ready = data; break;
  case PORT_KNOB: instrument->knob_ports[port.index] = data; break;
  case PORT_NONE: break;
  }
}

static void activate(LV2_Handle handle) {
  Instrument *const instrument = handle;
  plugin_player_rest(&instrument->player);
}

/* ---- knobs ---------------------------------------------------------------------------------- */

/* What is no number leaves the knob where it is: at first at its default. */
static float knob_value(const Instrument *instrument, uint32_t id) {
  const float *const port = instrument->knob_ports[id];
  const float last = instrument->player.seen[id];
  if (port && isfinite(*port)) return *port;
  return port && !isnan(last) ? last : instrument->ranges[id].fallback;
}

static void read_knobs(Instrument *instrument) {
  KnobId id;
  for (uint32_t i = 0; (id = knob_at(instrument->player.stereo, i)) < KNOB_COUNT; i++) {
    const KnobRange *const range = &instrument->ranges[id];
    const float value = knob_value(instrument, id);
    plugin_player_turn(&instrument->player, id,
                       fminf(fmaxf(value, range->minimum), range->maximum));
  }
}

/* ---- MIDI ----------------------------------------------------------------------------------- */

/* All messages of an event that go with notes, or all others. */
static void take_event(Instrument *instrument, const LV2_Atom_Event *event, bool notes,
                       uint32_t ahead) {
  const uint8_t *const bytes = (const uint8_t *)(event + 1);
  MidiStream stream = {0};
  MidiMessage message;
  if (event->body.type != instrument->urids.midi) return;
  for (uint32_t i = 0; i < event->body.size; i++) {
    if (!midi_stream_take(&stream, bytes[i], &message)) continue;
    if (midi_goes_with_notes(&message) == notes) {
      plugin_player_take(&instrument->player, &message, ahead);
    }
  }
}

/* Its frame in a run: not past its end, not before @p at. */
static uint32_t frame_of(const LV2_Atom_Event *event, uint32_t at, uint32_t frames) {
  const int64_t frame = event->time.frames;
  if (frame <= at) return at;
  return frame < frames ? (uint32_t)frame : frames - (frames > 0);
}

/* What a run is about. */
typedef struct Run {
  Sequence sequence;
  uint32_t at, frames; /* played so far, and all */
  bool waits;          /* for every model: the host renders, and is in no hurry */
} Run;

static Run begin_run(const Instrument *instrument, uint32_t frames, bool waits) {
  return (Run){.sequence = sequence_begin(instrument->events, instrument->urids.sequence),
               .frames = frames,
               .waits = waits};
}

/* All events of frame @p frame: controllers before notes. */
static void take_frame(Instrument *instrument, Run *run, uint32_t frame) {
  const Sequence first = run->sequence;
  const LV2_Atom_Event *event;
  plugin_player_begin_frame(&instrument->player);
  for (int notes = 0; notes <= 1; notes++) {
    run->sequence = first;
    while ((event = sequence_event(&run->sequence)) &&
           frame_of(event, frame, run->frames) == frame) {
      take_event(instrument, event, notes == 1, frame - run->at);
      sequence_step(&run->sequence);
    }
  }
}

/* ---- runs ----------------------------------------------------------------------------------- */

static void play_until(Instrument *instrument, Run *run, uint32_t end) {
  while (run->at < end) {
    run->at +=
      plugin_player_play(&instrument->player, &instrument->outputs, run->at, end - run->at);
  }
}

/* Plays with everything that comes. False where the run has to wait for another model; then it is to be called
 * again. */
static bool go_on(Instrument *instrument, Run *run) {
  PluginPlayer *const player = &instrument->player;
  const LV2_Atom_Event *event;
  uint32_t frame = run->at;
  while ((event = sequence_event(&run->sequence)) != NULL) {
    frame = frame_of(event, frame, run->frames);
    if (plugin_player_is_full(player)) play_until(instrument, run, frame);
    take_frame(instrument, run, frame);
    if (!plugin_player_has_choice(player)) continue;
    play_until(instrument, run, frame);
    plugin_player_choose(player);
    if (run->waits) return false;
  }
  play_until(instrument, run, run->frames);
  return true;
}

/* Knobs are read once a restored drum has landed: it brings what they said. True if somebody has to work. */
static bool keep_up(Instrument *instrument) {
  plugin_player_receive(&instrument->player);
  read_knobs(instrument);
  return plugin_player_ask(&instrument->player);
}

static bool run_live(Instrument *instrument, uint32_t frames) REALTIME;
static bool run_live(Instrument *instrument, uint32_t frames) {
  Run run = begin_run(instrument, frames, false);
  const bool asks = keep_up(instrument);
  (void)go_on(instrument, &run);
  return asks;
}

static void wait_for_model(Instrument *instrument) {
  for (;;) {
    (void)keep_up(instrument);
    if (plugin_player_is_settled(&instrument->player)) return;
    model_worker_work(&instrument->worker);
    if (!model_worker_reply(&instrument->worker)) sleep_for(PAUSE); /* another thread is at it */
  }
}

static void run_waiting(Instrument *instrument, uint32_t frames) {
  Run run = begin_run(instrument, frames, true);
  do {
    wait_for_model(instrument);
  } while (!go_on(instrument, &run));
}

static void call_worker(Instrument *instrument) {
  const LV2_Worker_Schedule *const schedule = instrument->schedule;
  if (!schedule || !instrument->asks) return;
  const uint32_t nothing = 0;
  instrument->asks =
    schedule->schedule_work(schedule->handle, sizeof nothing, &nothing) != LV2_WORKER_SUCCESS;
}

static void run(LV2_Handle handle, uint32_t frames) {
  Instrument *const instrument = handle;
  if (instrument->freewheel && *instrument->freewheel > 0) {
    run_waiting(instrument, frames);
  } else if (run_live(instrument, frames)) {
    instrument->asks = true;
  }
  call_worker(instrument);
  if (!instrument->ready) return;
  *instrument->ready = plugin_player_is_ready(&instrument->player) ? 1 : 0;
}

/* ---- extensions ----------------------------------------------------------------------------- */

static LV2_Worker_Status work(LV2_Handle handle, LV2_Worker_Respond_Function respond,
                              LV2_Worker_Respond_Handle respond_handle, uint32_t size,
                              const void *data) {
  (void)respond;
  (void)respond_handle;
  (void)size;
  (void)data;
  Instrument *const instrument = handle;
  model_worker_work(&instrument->worker);
  return LV2_WORKER_SUCCESS;
}

/* The reply is looked for in the next run. */
static LV2_Worker_Status work_response(LV2_Handle handle, uint32_t size, const void *body) {
  (void)handle;
  (void)size;
  (void)body;
  return LV2_WORKER_SUCCESS;
}

static const void *extension_data(const char *uri) {
  static const LV2_Worker_Interface worker = {.work = work, .work_response = work_response};
  if (strcmp(uri, LV2_WORKER__interface) == 0) return &worker;
  return strcmp(uri, LV2_STATE__interface) == 0 ? &instrument_state : NULL;
}

LV2_SYMBOL_EXPORT const LV2_Descriptor *lv2_descriptor(uint32_t index) {
#define PLUGIN(uri)                                                                                \
  {                                                                                                \
    .URI = (uri), .instantiate = instantiate, .connect_port = connect_port, .activate = activate,  \
    .run = run, .cleanup = cleanup, .extension_data = extension_data                               \
  }
  static const LV2_Descriptor plugins[] = {PLUGIN(URI_DRUM), PLUGIN(URI_DRUM_MULTI)};
  return index < sizeof plugins / sizeof plugins[0] ? &plugins[index] : NULL;
}
