/* SPDX-License-Identifier: MIT */
#include "plugin_host.h"

#include <dlfcn.h>
#include <lv2/midi/midi.h>
#include <lv2/patch/patch.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <cmocka.h>

#include "lv2/plugins.h"

#define MOST_URIS 256

/* ---- URIs ----------------------------------------------------------------------------------- */

static pthread_mutex_t uris_lock = PTHREAD_MUTEX_INITIALIZER;
static char *uris[MOST_URIS];
static uint32_t uri_count;

LV2_URID host_map(const char *uri) {
  uint32_t i = 0;
  (void)pthread_mutex_lock(&uris_lock);
  while (i < uri_count && strcmp(uris[i], uri) != 0) i++;
  if (i == uri_count && i < MOST_URIS) {
    uris[uri_count++] = strcpy(malloc(strlen(uri) + 1), uri);
  }
  (void)pthread_mutex_unlock(&uris_lock);
  return i + 1;
}

LV2_URID host_map_feature(LV2_URID_Map_Handle handle, const char *uri) {
  (void)handle;
  return host_map(uri);
}

const LV2_Descriptor *host_descriptor(const char *binary, const char *uri) {
  void *const library = dlopen(binary, RTLD_NOW | RTLD_LOCAL);
  if (!library) fail_msg("%s", dlerror());
  void *const symbol = dlsym(library, "lv2_descriptor");
  LV2_Descriptor_Function find;
  assert_non_null(symbol);
  memcpy(&find, &symbol, sizeof find);
  for (uint32_t i = 0;; i++) {
    const LV2_Descriptor *const descriptor = find(i);
    assert_non_null(descriptor);
    if (strcmp(descriptor->URI, uri) == 0) return descriptor;
  }
}

/* ---- a worker ------------------------------------------------------------------------------- */

static LV2_Worker_Status respond(LV2_Worker_Respond_Handle handle, uint32_t size,
                                 const void *data) {
  (void)handle;
  (void)size;
  (void)data;
  return LV2_WORKER_SUCCESS;
}

static void work(PluginHost *host) {
  const LV2_Worker_Interface *const worker =
    host->descriptor->extension_data(LV2_WORKER__interface);
  const uint32_t nothing = 0;
  (void)worker->work(host->handle, respond, NULL, sizeof nothing, &nothing);
}

static LV2_Worker_Status schedule(LV2_Worker_Schedule_Handle handle, uint32_t size,
                                  const void *data) {
  PluginHost *const host = handle;
  (void)size;
  (void)data;
  atomic_fetch_add(&host->asked, 1);
  if (host->worker == HOST_WORKER_REFUSES) return LV2_WORKER_ERR_NO_SPACE;
  if (host->worker == HOST_WORKER_AT_ONCE) work(host);
  return LV2_WORKER_SUCCESS;
}

static void pause_briefly(void) {
  const struct timespec moment = {.tv_nsec = 1000000};
  (void)nanosleep(&moment, NULL);
}

static void *work_all(void *context) {
  PluginHost *const host = context;
  while (!atomic_load(&host->stops)) {
    if (atomic_load(&host->done) == atomic_load(&host->asked)) {
      pause_briefly();
      continue;
    }
    work(host);
    atomic_fetch_add(&host->done, 1);
  }
  return NULL;
}

/* ---- a log ---------------------------------------------------------------------------------- */

static int say(LV2_Log_Handle handle, LV2_URID type, const char *format, va_list arguments) {
  PluginHost *const host = handle;
  (void)type;
  return vsnprintf(host->said, sizeof host->said, format, arguments);
}

static int say_all(LV2_Log_Handle handle, LV2_URID type, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const int length = say(handle, type, format, arguments);
  va_end(arguments);
  return length;
}

/* ---- an instance ---------------------------------------------------------------------------- */

Port host_port(const PluginHost *host, uint32_t number) { return port_at(host->kind, number); }

float *host_knob(PluginHost *host, uint32_t id) {
  return host->is_kit ? &host->kit_knobs[id] : &host->knobs[id];
}

static void connect_ports(PluginHost *host) {
  Port port;
  for (uint32_t i = 0; (port = host_port(host, i)).kind != PORT_NONE; i++) {
    void *data = NULL;
    switch (port.kind) {
    case PORT_EVENTS: data = &host->events; break;
    case PORT_INPUT: data = host->input[port.index]; break;
    case PORT_OUTPUT: data = host->sound[port.index]; break;
    case PORT_FREEWHEEL: data = &host->freewheel; break;
    case PORT_READY: data = &host->ready; break;
    case PORT_KNOB: data = host_knob(host, port.index); break;
    case PORT_NONE: break;
    }
    host->descriptor->connect_port(host->handle, i, data);
  }
}

void host_clear(PluginHost *host) {
  host->events.sequence = (LV2_Atom_Sequence){
    .atom = {.size = sizeof(LV2_Atom_Sequence_Body), .type = host_map(LV2_ATOM__Sequence)}};
}

static void set_knobs(PluginHost *host) {
  TaborDrumDef usual;
  assert_int_equal(tabor_drum_def_preset(&usual, DEFAULT_PRESET, NULL), TABOR_OK);
  for (uint32_t i = 0; i < KNOB_COUNT; i++) {
    host->knobs[i] = knob_range((KnobId)i, &usual).fallback;
  }
  host->knobs[KNOB_ROOM] = TABOR_ROOM_NONE;
  host->knobs[KNOB_LEVEL_PAIR] = 0;
  for (uint32_t i = 0; i < KIT_KNOB_COUNT; i++)
    host->kit_knobs[i] = kit_knob_range((KitKnobId)i).fallback;
}

PluginHost *host_open(const LV2_Descriptor *descriptor, HostWorker worker) {
  PluginHost *const host = calloc(1, sizeof *host);
  assert_non_null(host);
  host->descriptor = descriptor;
  host->kind = &instrument_kinds[lv2_plugin_find(descriptor->URI)->kind];
  host->is_kit = host->kind->id == INSTRUMENT_KIT;
  host->outputs = host->kind->channels;
  host->worker = worker;
  set_knobs(host);
  host->urids = (LV2_URID_Map){NULL, host_map_feature};
  host->scheduler = (LV2_Worker_Schedule){host, schedule};
  host->log = (LV2_Log_Log){host, say_all, say};
  const LV2_Feature map_feature = {LV2_URID__map, &host->urids},
                    log_feature = {LV2_LOG__log, &host->log},
                    work_feature = {LV2_WORKER__schedule, &host->scheduler};
  const bool has_worker = worker != HOST_WITHOUT_WORKER;
  const LV2_Feature *const features[] = {&map_feature, &log_feature,
                                         has_worker ? &work_feature : NULL, NULL};
  host->handle = descriptor->instantiate(descriptor, 48000, "/", features);
  assert_non_null(host->handle);
  host_clear(host);
  connect_ports(host);
  descriptor->activate(host->handle);
  if (worker == HOST_WORKER_THREAD) {
    assert_int_equal(pthread_create(&host->thread, NULL, work_all, host), 0);
  }
  return host;
}

void host_close(PluginHost *host) {
  atomic_store(&host->stops, true);
  if (host->worker == HOST_WORKER_THREAD) (void)pthread_join(host->thread, NULL);
  if (host->descriptor->deactivate) host->descriptor->deactivate(host->handle);
  host->descriptor->cleanup(host->handle);
  free(host);
}

/* ---- runs ----------------------------------------------------------------------------------- */

static void add_event(PluginHost *host, int64_t frame, const char *type, uint32_t size,
                      const void *bytes) {
  LV2_Atom_Sequence *const sequence = &host->events.sequence;
  uint8_t *const place = (uint8_t *)host->events.room + sizeof(LV2_Atom) + sequence->atom.size;
  const uint32_t padded = (uint32_t)(sizeof(LV2_Atom_Event) + size + 7) / 8 * 8;
  const LV2_Atom_Event event = {.time = {.frames = frame},
                                .body = {.size = size, .type = host_map(type)}};
  assert_true(sizeof(LV2_Atom) + sequence->atom.size + padded <= HOST_ROOM);
  memcpy(place, &event, sizeof event);
  memcpy(place + sizeof event, bytes, size);
  sequence->atom.size += padded;
}

void host_event(PluginHost *host, int64_t frame, uint32_t size, const void *bytes) {
  add_event(host, frame, LV2_MIDI__MidiEvent, size, bytes);
}

void host_set_path(PluginHost *host, int64_t frame, const char *uri, const char *path) {
  struct {
    LV2_Atom_Object_Body object;
    LV2_Atom_Property_Body property;
    LV2_URID uri, padding;
    LV2_Atom_Property_Body value;
    char path[512];
  } message = {
    .object = {.otype = host_map(LV2_PATCH__Set)},
    .property = {.key = host_map(LV2_PATCH__property),
                 .value = {.size = sizeof(LV2_URID), .type = host_map(LV2_ATOM__URID)}},
    .uri = host_map(uri),
    .value = {.key = host_map(LV2_PATCH__value),
              .value = {.size = (uint32_t)strlen(path) + 1, .type = host_map(LV2_ATOM__Path)}}};
  assert_true(strlen(path) < sizeof message.path);
  strcpy(message.path, path);
  add_event(host, frame, LV2_ATOM__Object,
            (uint32_t)(offsetof(__typeof__(message), path) + strlen(path) + 1), &message);
}

void host_note(PluginHost *host, int64_t frame, uint8_t key, uint8_t velocity) {
  host_event(host, frame, 3, (const uint8_t[]){0x99, key, velocity});
}

void host_run(PluginHost *host, uint32_t frames) {
  assert_true(frames <= HOST_BLOCK);
  host->descriptor->run(host->handle, frames);
  host->position += frames;
  host_clear(host);
}

void host_wait(PluginHost *host) {
  host->ready = 0;
  for (int i = 0; host->ready < 1; i++) {
    assert_true(i < 20000);
    host_run(host, 16);
    if (host->ready < 1) pause_briefly();
  }
}

void host_play(PluginHost *host, const HostMessage *messages, size_t count, uint32_t frames,
               uint32_t block, float *const *sound) {
  static uint64_t random = 7;
  size_t next = 0;
  for (uint32_t at = 0; at < frames;) {
    uint32_t run = block > 0 ? block : (uint32_t)pow(HOST_BLOCK, 1.1 * host_random(&random) - 0.1);
    if (run > frames - at) run = frames - at;
    for (; next < count && messages[next].frame < at + run; next++) {
      const MidiMessage *const message = &messages[next].message;
      const uint8_t bytes[] = {message->status, message->data[0], message->data[1]};
      host_event(host, (int64_t)messages[next].frame - at, 1u + midi_data_count(message->status),
                 bytes);
    }
    host_run(host, run);
    for (uint32_t i = 0; i < host->outputs; i++) {
      memcpy(sound[i] + at, host->sound[i], run * sizeof(float));
    }
    at += run;
  }
}

/* ---- states --------------------------------------------------------------------------------- */

HostProperty *host_property(HostState *state, const char *uri) {
  for (uint32_t i = 0; i < state->count; i++) {
    if (strcmp(state->properties[i].uri, uri) == 0) return &state->properties[i];
  }
  return NULL;
}

void host_set_property(HostState *state, const char *uri, const char *type, const void *value,
                       size_t size) {
  HostProperty *property = host_property(state, uri);
  if (!property) {
    assert_true(state->count < HOST_PROPERTIES);
    property = &state->properties[state->count++];
    *property = (HostProperty){.flags = LV2_STATE_IS_POD | LV2_STATE_IS_PORTABLE};
    (void)snprintf(property->uri, sizeof property->uri, "%s", uri);
  }
  free(property->value);
  property->value = malloc(size + 1);
  property->size = size;
  property->type = host_map(type);
  memcpy(property->value, value, size);
}

static LV2_State_Status store(LV2_State_Handle handle, uint32_t key, const void *value, size_t size,
                              uint32_t type, uint32_t flags) {
  assert_int_equal(flags, LV2_STATE_IS_POD | LV2_STATE_IS_PORTABLE);
  assert_true(key > 0 && key <= uri_count && type > 0 && type <= uri_count);
  host_set_property(handle, uris[key - 1], uris[type - 1], value, size);
  return LV2_STATE_SUCCESS;
}

static const void *retrieve(LV2_State_Handle handle, uint32_t key, size_t *size, uint32_t *type,
                            uint32_t *flags) {
  const HostProperty *const property = host_property(handle, uris[key - 1]);
  if (!property) return NULL;
  *size = property->size;
  *type = property->type;
  *flags = property->flags;
  return property->value;
}

static const LV2_State_Interface *states(const PluginHost *host) {
  const LV2_State_Interface *const found = host->descriptor->extension_data(LV2_STATE__interface);
  assert_non_null(found);
  return found;
}

void host_save(PluginHost *host, HostState *state) {
  const LV2_Feature *const none[] = {NULL};
  *state = (HostState){.count = 0};
  assert_int_equal(states(host)->save(host->handle, store, state, 0, none), LV2_STATE_SUCCESS);
}

LV2_State_Status host_restore(PluginHost *host, const HostState *state) {
  const LV2_Feature *const none[] = {NULL};
  HostState copy = *state;
  return states(host)->restore(host->handle, retrieve, &copy, 0, none);
}

void host_state_free(HostState *state) {
  for (uint32_t i = 0; i < state->count; i++) free(state->properties[i].value);
  state->count = 0;
}

/* ---- numbers -------------------------------------------------------------------------------- */

double host_peak(const float *samples, uint32_t count) {
  double peak = 0;
  for (uint32_t i = 0; i < count; i++) peak = fmax(peak, fabs((double)samples[i]));
  return peak;
}

double host_random(uint64_t *state) {
  *state = *state * 6364136223846793005u + 1442695040888963407u;
  return (double)(*state >> 11) * 0x1p-53;
}
