/* SPDX-License-Identifier: MIT */
#include "lv2/instance.h"

#include <lv2/midi/midi.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plugin/plugin_run.h"

/* ---- beginning and end ---------------------------------------------------------------------- */

static void map_controls(Urids *urids, LV2_URID_Map *map, const InstrumentKind *kind) {
  for (uint32_t i = 0; i < kind->seen_count; i++) {
    char uri[128];
    (void)snprintf(uri, sizeof uri, "%s%s", URI_STATE_CONTROL, kind->knobs[i].symbol);
    urids->controls[i] = map->map(map->handle, uri);
  }
}

static void map_uris(Urids *urids, LV2_URID_Map *map, const Lv2Plugin *plugin) {
  urids->sequence = map->map(map->handle, LV2_ATOM__Sequence);
  urids->midi = map->map(map->handle, LV2_MIDI__MidiEvent);
  urids->atom_int = map->map(map->handle, LV2_ATOM__Int);
  urids->atom_float = map->map(map->handle, LV2_ATOM__Float);
  urids->atom_string = map->map(map->handle, LV2_ATOM__String);
  urids->file = map->map(map->handle, plugin->file);
  urids->version = map->map(map->handle, URI_STATE_VERSION);
  urids->text = map->map(map->handle, plugin->text);
  urids->set_path = set_path_urids(map);
  map_controls(urids, map, &instrument_kinds[plugin->kind]);
}

static void say(void *context, const char *line) { instance_say(context, line); }

static bool open(Instance *instance, double rate) {
  instance->instrument = instrument_create(&instrument_kinds[instance->plugin->kind]);
  if (!instance->instrument) return false;
  instance->instrument->say = say;
  instance->instrument->context = instance;
  map_uris(&instance->urids, instance->host.map, instance->plugin);
  return instrument_open(instance->instrument, rate) &&
         (instance->host.schedule ||
          worker_thread_start(&instance->thread, instrument_work, instance->instrument));
}

static void cleanup(LV2_Handle handle) {
  Instance *const instance = handle;
  Instrument *const instrument = instance->instrument;
  if (instrument && instrument->is_open) builder_cancel(instrument->builder);
  worker_thread_stop(&instance->thread);
  instrument_destroy(instrument);
  free(instance);
}

static LV2_Handle instantiate(const LV2_Descriptor *descriptor, double rate, const char *bundle,
                              const LV2_Feature *const *features) {
  (void)bundle;
  Instance *const instance = calloc(1, sizeof *instance);
  if (!instance) return NULL;
  instance->size = sizeof *instance;
  instance->version = tabor_version();
  instance->plugin = lv2_plugin_find(descriptor->URI);
  const char *const name = instrument_kinds[instance->plugin->kind].name;
  if (!host_features_find(features, rate, name, &instance->host)) {
    free(instance);
    return NULL;
  }
  if (open(instance, rate)) return instance;
  cleanup(instance);
  return NULL;
}

static void connect_port(LV2_Handle handle, uint32_t number, void *data) {
  Instance *const instance = handle;
  const Port port = port_at(instance->instrument->kind, number);
  switch (port.kind) {
  case PORT_EVENTS: instance->events = data; break;
  case PORT_INPUT: instance->buffers.input[port.index] = data; break;
  case PORT_OUTPUT: instance->buffers.channels[port.index] = data; break;
  case PORT_FREEWHEEL: instance->freewheel = data; break;
  case PORT_READY: instance->ready = data; break;
  case PORT_KNOB: instance->knob_ports[port.index] = data; break;
  case PORT_NONE: break;
  }
}

static void activate(LV2_Handle handle) {
  Instrument *const instrument = ((Instance *)handle)->instrument;
  builder_resume(instrument->builder);
  instrument->kind->calls->rest(instrument);
}

static void deactivate(LV2_Handle handle) {
  Instrument *const instrument = ((Instance *)handle)->instrument;
  builder_cancel(instrument->builder);
}

/* ---- knobs and files ------------------------------------------------------------------------ */

/* A port that holds no number leaves the knob where it is, at first at its default. */
static void read_knobs(Instance *instance) REALTIME {
  Instrument *const instrument = instance->instrument;
  for (uint32_t i = 0; i < instrument->kind->knob_count; i++) {
    const float *const port = instance->knob_ports[i];
    if (!port || !isfinite(*port)) continue;
    const float value = port_to_knob(&instrument->ranges[i], *port);
    atomic_store(&instrument->values[i],
                 instrument->kind->knobs[i].choices ? roundf(value) : value);
  }
}

/* Whatever their frames. */
static void ask_for_files(Instance *instance) REALTIME {
  Sequence sequence = sequence_begin(instance->events, instance->urids.sequence);
  const LV2_Atom_Event *event;
  size_t length;
  for (; (event = sequence_event(&sequence)); sequence_step(&sequence)) {
    const Urids *const urids = &instance->urids;
    const char *const path = set_path_read(event, &urids->set_path, urids->file, &length);
    if (path && instrument_ask_file(instance->instrument, path, length)) instance->asks = true;
  }
}

/* ---- runs ----------------------------------------------------------------------------------- */

static bool find_event(void *shell, uint32_t *frame) REALTIME {
  const Instance *const instance = shell;
  return midi_sequence_find(&instance->messages, frame);
}

/* A frame whose messages are taken. */
typedef struct Frame {
  Instrument *instrument;
  uint32_t frame;
} Frame;

static void take_message(void *context, const MidiMessage *message) REALTIME {
  const Frame *const taken = context;
  taken->instrument->kind->calls->take(taken->instrument, message, taken->frame);
}

static void take_frame(void *shell, uint32_t frame) REALTIME {
  Instance *const instance = shell;
  Frame taken = {.instrument = instance->instrument, .frame = frame};
  midi_sequence_take(&instance->messages, frame, take_message, &taken);
}

static void call_worker(Instance *instance) {
  const LV2_Worker_Schedule *const schedule = instance->host.schedule;
  if (!schedule || !instance->asks) return;
  const uint32_t nothing = 0;
  instance->asks =
    schedule->schedule_work(schedule->handle, sizeof nothing, &nothing) != LV2_WORKER_SUCCESS;
}

/* Knobs are ports, which change between runs alone. */
static void run(LV2_Handle handle, uint32_t frames) {
  static const PluginEvents events = {.find = find_event, .take = take_frame};
  Instance *const instance = handle;
  Instrument *const instrument = instance->instrument;
  PluginRun run = {.instrument = instrument,
                   .events = &events,
                   .shell = instance,
                   .frames = frames,
                   .waits = instance->freewheel && *instance->freewheel > 0};
  instance->messages =
    (MidiSequence){.sequence = sequence_begin(instance->events, instance->urids.sequence),
                   .midi = instance->urids.midi,
                   .frames = frames};
  instrument->buffers = instance->buffers;
  read_knobs(instance);
  ask_for_files(instance);
  instrument_begin_block(instrument);
  window_link_play(instrument);
  if (run.waits) {
    plugin_run_waiting(&run);
  } else if (plugin_run_live(&run)) {
    instance->asks = true;
  }
  window_link_show(instrument, frames);
  call_worker(instance);
  if (instance->ready) *instance->ready = instrument->kind->calls->is_ready(instrument) ? 1 : 0;
}

/* ---- extensions ----------------------------------------------------------------------------- */

static LV2_Worker_Status work(LV2_Handle handle, LV2_Worker_Respond_Function respond,
                              LV2_Worker_Respond_Handle respond_handle, uint32_t size,
                              const void *data) {
  (void)respond;
  (void)respond_handle;
  (void)size;
  (void)data;
  instrument_work(((Instance *)handle)->instrument);
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
  return strcmp(uri, LV2_STATE__interface) == 0 ? &instance_state : NULL;
}

#define PLUGIN(uri)                                                                                \
  {                                                                                                \
    .URI = (uri), .instantiate = instantiate, .connect_port = connect_port, .activate = activate,  \
    .run = run, .deactivate = deactivate, .cleanup = cleanup, .extension_data = extension_data     \
  }

const LV2_Descriptor instance_descriptors[INSTRUMENT_KINDS] = {
  PLUGIN(URI_DRUM), PLUGIN(URI_DRUM_MULTI), PLUGIN(URI_KIT), PLUGIN(URI_EFFECT)};
