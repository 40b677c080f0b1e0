/* SPDX-License-Identifier: MIT */
#include "lv2/instrument.h"

#include <lv2/midi/midi.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lv2/uris.h"

/* ---- beginning ------------------------------------------------------------------------------ */

static void map_uris(Urids *urids, LV2_URID_Map *map) {
  urids->sequence = map->map(map->handle, LV2_ATOM__Sequence);
  urids->midi = map->map(map->handle, LV2_MIDI__MidiEvent);
  urids->atom_int = map->map(map->handle, LV2_ATOM__Int);
  urids->atom_float = map->map(map->handle, LV2_ATOM__Float);
  urids->atom_string = map->map(map->handle, LV2_ATOM__String);
  urids->version = map->map(map->handle, URI_STATE_VERSION);
  urids->definition = map->map(map->handle, URI_STATE_DEFINITION);
  for (uint32_t i = 0; i < KNOB_SEEN; i++) {
    char uri[128];
    (void)snprintf(uri, sizeof uri, "%s%s", URI_STATE_CONTROL, knobs[i].symbol);
    urids->controls[i] = map->map(map->handle, uri);
  }
}

static void say(void *context, const char *line) {
  Instrument *const instrument = context;
  (void)lv2_log_error(&instrument->host.logger, "Tabor: %s\n", line);
}

static void build_models(void *worker) { model_worker_work(worker); }

static void find_ranges(Instrument *instrument) {
  for (uint32_t i = 0; i < KNOB_COUNT; i++) {
    instrument->ranges[i] = knob_range_in(instrument->set, (KnobId)i, &instrument->worker.base);
  }
}

static bool open(Instrument *instrument, double rate) {
  const bool stereo = instrument->set != KNOBS_MULTI;
  instrument->size = sizeof *instrument;
  instrument->version = tabor_version();
  map_uris(&instrument->urids, instrument->host.map);
  instrument->worker.say = say;
  instrument->worker.context = instrument;
  if (!model_worker_begin(&instrument->worker, rate, stereo)) return false;
  find_ranges(instrument);
  if (!plugin_player_begin(&instrument->player, &instrument->worker, rate, stereo)) return false;
  if (!window_link_begin(&instrument->window)) return false;
  return instrument->host.schedule ||
         worker_thread_start(&instrument->thread, build_models, &instrument->worker);
}

static void cleanup(LV2_Handle handle) {
  Instrument *const instrument = handle;
  model_worker_cancel(&instrument->worker);
  worker_thread_stop(&instrument->thread);
  window_link_end(&instrument->window);
  plugin_player_end(&instrument->player);
  model_worker_end(&instrument->worker);
  free(instrument);
}

static KnobSet set_of(const LV2_Descriptor *descriptor) {
  if (descriptor == &instrument_effect) return KNOBS_EFFECT;
  return descriptor == &instrument_stereo ? KNOBS_STEREO : KNOBS_MULTI;
}

static LV2_Handle instantiate(const LV2_Descriptor *descriptor, double rate, const char *bundle,
                              const LV2_Feature *const *features) {
  (void)bundle;
  Instrument *const instrument = calloc(1, sizeof *instrument);
  if (!instrument) return NULL;
  if (!host_features_find(features, rate, "Tabor", &instrument->host)) {
    free(instrument);
    return NULL;
  }
  instrument->set = set_of(descriptor);
  if (open(instrument, rate)) return instrument;
  cleanup(instrument);
  return NULL;
}

static void connect_port(LV2_Handle handle, uint32_t number, void *data) {
  Instrument *const instrument = handle;
  const Port port = port_at(instrument->set, number);
  switch (port.kind) {
  case PORT_EVENTS: instrument->events = data; break;
  case PORT_INPUT: instrument->outputs.input[port.index] = data; break;
  case PORT_OUTPUT: instrument->outputs.channels[port.index] = data; break;
  case PORT_FREEWHEEL: instrument->freewheel = data; break;
  case PORT_READY: instrument->ready = data; break;
  case PORT_KNOB: instrument->knob_ports[port.index] = data; break;
  case PORT_NONE: break;
  }
}

static void activate(LV2_Handle handle) {
  Instrument *const instrument = handle;
  model_worker_resume(&instrument->worker);
  plugin_player_rest(&instrument->player);
}

static void deactivate(LV2_Handle handle) {
  Instrument *const instrument = handle;
  model_worker_cancel(&instrument->worker);
}

/* ---- knobs ---------------------------------------------------------------------------------- */

/* What is no number leaves the knob where it is: at first at its default. */
static float knob_value(const Instrument *instrument, uint32_t id) {
  const float *const port = instrument->knob_ports[id];
  const float last = instrument->player.seen[id];
  if (port && isfinite(*port)) return *port;
  return port && !isnan(last) ? last : instrument->ranges[id].fallback;
}

static void turn_knob(Instrument *instrument, KnobId id) REALTIME;
static void turn_knob(Instrument *instrument, KnobId id) {
  const KnobRange *const range = &instrument->ranges[id];
  const float value = knob_value(instrument, id);
  plugin_player_turn(&instrument->player, id, port_to_knob(range, value));
}

static void turn_knobs(void *shell) REALTIME;
static void turn_knobs(void *shell) {
  Instrument *const instrument = shell;
  KnobId id;
  turn_knob(instrument, KNOB_DRUM);
  for (uint32_t i = 0; (id = knob_at(instrument->set, i)) < KNOB_COUNT; i++) {
    turn_knob(instrument, id);
  }
}

/* ---- MIDI ----------------------------------------------------------------------------------- */

static bool find_event(void *shell, uint32_t frames, uint32_t *frame) REALTIME;
static bool find_event(void *shell, uint32_t frames, uint32_t *frame) {
  const Instrument *const instrument = shell;
  (void)frames;
  return midi_sequence_find(&instrument->messages, frame);
}

/* Knobs are ports here, which change between runs alone. */
static bool note_knobs(void *shell, uint32_t frame) REALTIME;
static bool note_knobs(void *shell, uint32_t frame) {
  (void)shell;
  (void)frame;
  return false;
}

/* A frame whose messages are taken, `ahead` of what was played. */
typedef struct Frame {
  PluginPlayer *player;
  uint32_t ahead;
} Frame;

static void take_message(void *context, const MidiMessage *message) REALTIME;
static void take_message(void *context, const MidiMessage *message) {
  const Frame *const frame = context;
  plugin_player_take(frame->player, message, frame->ahead);
}

static void take_frame(void *shell, uint32_t frame, uint32_t ahead) REALTIME;
static void take_frame(void *shell, uint32_t frame, uint32_t ahead) {
  Instrument *const instrument = shell;
  Frame taken = {.player = &instrument->player, .ahead = ahead};
  midi_sequence_take(&instrument->messages, frame, take_message, &taken);
}

/* ---- runs ----------------------------------------------------------------------------------- */

static void call_worker(Instrument *instrument) {
  const LV2_Worker_Schedule *const schedule = instrument->host.schedule;
  if (!schedule || !instrument->asks) return;
  const uint32_t nothing = 0;
  instrument->asks =
    schedule->schedule_work(schedule->handle, sizeof nothing, &nothing) != LV2_WORKER_SUCCESS;
}

static void run(LV2_Handle handle, uint32_t frames) {
  static const PluginEvents events = {
    .turn = turn_knobs, .find = find_event, .note_knobs = note_knobs, .take = take_frame};
  Instrument *const instrument = handle;
  PluginRun run = {.player = &instrument->player,
                   .outputs = &instrument->outputs,
                   .events = &events,
                   .shell = instrument,
                   .frames = frames,
                   .waits = instrument->freewheel && *instrument->freewheel > 0};
  instrument->messages =
    (MidiSequence){.sequence = sequence_begin(instrument->events, instrument->urids.sequence),
                   .midi = instrument->urids.midi,
                   .frames = frames};
  window_link_play(&instrument->window, &instrument->player);
  if (run.waits) {
    plugin_run_waiting(&run);
  } else if (plugin_run_live(&run)) {
    instrument->asks = true;
  }
  window_link_show(&instrument->window, &instrument->player, &instrument->outputs, frames);
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

#define PLUGIN(uri)                                                                                \
  {                                                                                                \
    .URI = (uri), .instantiate = instantiate, .connect_port = connect_port, .activate = activate,  \
    .run = run, .deactivate = deactivate, .cleanup = cleanup, .extension_data = extension_data     \
  }

const LV2_Descriptor instrument_stereo = PLUGIN(URI_DRUM);
const LV2_Descriptor instrument_multi = PLUGIN(URI_DRUM_MULTI);
const LV2_Descriptor instrument_effect = PLUGIN(URI_EFFECT);
