/* SPDX-License-Identifier: MIT */
#include "clap_host.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "platform/shared_library.h"

/* ---- what the plugin asks of its host ------------------------------------------------------- */

static void say(const clap_host_t *host, clap_log_severity severity, const char *line) {
  ClapHost *const own = host->host_data;
  (void)severity;
  (void)snprintf(own->said, sizeof own->said, "%s", line);
}

static void rescan(const clap_host_t *host, clap_param_rescan_flags flags) {
  ((ClapHost *)host->host_data)->rescans += flags == CLAP_PARAM_RESCAN_VALUES;
}

static void clear(const clap_host_t *host, clap_id id, clap_param_clear_flags flags) {
  (void)host;
  (void)id;
  (void)flags;
}

static void request(const clap_host_t *host) { (void)host; }

static void request_callback(const clap_host_t *host) {
  ((ClapHost *)host->host_data)->callbacks++;
}

static void request_block(const clap_host_t *host) { ((ClapHost *)host->host_data)->requests++; }

static void refuse(const clap_host_t *host, uint32_t kind, const char *location, const char *key,
                   int32_t number, const char *why) {
  ClapHost *const own = host->host_data;
  (void)kind;
  (void)location;
  (void)key;
  (void)number;
  (void)snprintf(own->refused, sizeof own->refused, "%s", why);
}

static void note_preset(const clap_host_t *host, uint32_t kind, const char *location,
                        const char *key) {
  ClapHost *const own = host->host_data;
  const bool is_file = kind == CLAP_PRESET_DISCOVERY_LOCATION_FILE;
  assert_int_equal(location != NULL, is_file);
  (void)snprintf(own->loaded, sizeof own->loaded, "%s", is_file ? location : key);
}

static bool start_timer(const clap_host_t *host, uint32_t period, clap_id *id) {
  ClapHost *const own = host->host_data;
  assert_in_range(period, 1, 100);
  *id = own->timers++;
  return true;
}

static bool stop_timer(const clap_host_t *host, clap_id id) {
  ClapHost *const own = host->host_data;
  assert_true(id < own->timers);
  own->timers--;
  return true;
}

static bool can_popup(const clap_host_t *host) {
  (void)host;
  return true;
}

static bool popup(const clap_host_t *host, const clap_context_menu_target_t *target, int32_t screen,
                  int32_t x, int32_t y) {
  ClapHost *const own = host->host_data;
  (void)screen, (void)x, (void)y;
  assert_int_equal(target->kind, CLAP_CONTEXT_MENU_TARGET_KIND_PARAM);
  own->menus++;
  own->menu_of = target->id;
  return true;
}

static void exec(void *context, uint32_t task) {
  const ClapHost *const own = context;
  const clap_plugin_thread_pool_t *const pool = clap_host_extension(own, CLAP_EXT_THREAD_POOL);
  pool->exec(own->plugin, task);
}

static bool request_exec(const clap_host_t *host, uint32_t count) {
  ClapHost *const own = host->host_data;
  if (own->refuses_threads) return false;
  host_threads_run(own->threads, exec, own, count);
  return true;
}

static const void *extension(const clap_host_t *host, const char *id) {
  static const clap_host_timer_support_t timers = {start_timer, stop_timer};
  static const clap_host_log_t log = {.log = say};
  static const clap_host_params_t params = {rescan, clear, request};
  static const clap_host_preset_load_t presets = {refuse, note_preset};
  static const clap_host_thread_pool_t pool = {request_exec};
  static const clap_host_context_menu_t menus = {.can_popup = can_popup, .popup = popup};
  const bool has_threads = ((const ClapHost *)host->host_data)->threads != NULL;
  if (strcmp(id, CLAP_EXT_LOG) == 0) return &log;
  if (strcmp(id, CLAP_EXT_CONTEXT_MENU) == 0) return &menus;
  if (strcmp(id, CLAP_EXT_PARAMS) == 0) return &params;
  if (strcmp(id, CLAP_EXT_TIMER_SUPPORT) == 0) return &timers;
  if (strcmp(id, CLAP_EXT_THREAD_POOL) == 0) return has_threads ? &pool : NULL;
  return strcmp(id, CLAP_EXT_PRESET_LOAD) == 0 ? &presets : NULL;
}

static const void *no_extension(const clap_host_t *host, const char *id) {
  (void)host;
  (void)id;
  return NULL;
}

const clap_plugin_entry_t *clap_host_entry(const char *binary) {
  const clap_plugin_entry_t *entry = NULL;
  void *const library = shared_library_open(binary);
  if (!library) fail_msg("%s cannot be loaded", binary);
  shared_library_find(library, "clap_entry", &entry);
  assert_non_null(entry);
  assert_true(entry->init(binary));
  return entry;
}

bool clap_host_has_sound_files(void) {
  void *const library = shared_library_sndfile();
  if (library) shared_library_close(library);
  return library != NULL;
}

/* ---- an instance ---------------------------------------------------------------------------- */

static void find_ports(ClapHost *host) {
  const clap_plugin_audio_ports_t *const ports = clap_host_extension(host, CLAP_EXT_AUDIO_PORTS);
  host->port_count = ports->count(host->plugin, false);
  host->has_input = ports->count(host->plugin, true) == 1;
  assert_true(host->port_count <= CLAP_PORTS);
  for (uint32_t i = 0; i < host->port_count; i++) {
    clap_audio_port_info_t info;
    assert_true(ports->get(host->plugin, i, false, &info));
    host->widths[i] = info.channel_count;
  }
}

typedef const void *ExtensionFn(const clap_host_t *host, const char *id);

static ClapHost *open_with(const clap_plugin_entry_t *entry, const char *id, ExtensionFn *of_host,
                           HostThreads *threads) {
  const clap_plugin_factory_t *const factory = entry->get_factory(CLAP_PLUGIN_FACTORY_ID);
  ClapHost *const host = calloc(1, sizeof *host);
  assert_non_null(factory);
  assert_non_null(host);
  host->host = (clap_host_t){.clap_version = CLAP_VERSION_INIT,
                             .host_data = host,
                             .name = "test",
                             .vendor = "",
                             .url = "",
                             .version = "1",
                             .get_extension = of_host,
                             .request_restart = request,
                             .request_process = request_block,
                             .request_callback = request_callback};
  host->threads = threads;
  host->stereo = strcmp(id, ID_DRUM) == 0;
  host->plugin = factory->create_plugin(factory, &host->host, id);
  assert_non_null(host->plugin);
  assert_true(host->plugin->init(host->plugin));
  find_ports(host);
  return host;
}

ClapHost *clap_host_open(const clap_plugin_entry_t *entry, const char *id) {
  return open_with(entry, id, extension, NULL);
}

ClapHost *clap_host_open_threaded(const clap_plugin_entry_t *entry, const char *id,
                                  HostThreads *threads) {
  return open_with(entry, id, extension, threads);
}

ClapHost *clap_host_scan(const clap_plugin_entry_t *entry, const char *id) {
  return open_with(entry, id, no_extension, NULL);
}

void clap_host_activate(ClapHost *host) {
  assert_true(host->plugin->activate(host->plugin, 48000, 1, CLAP_BLOCK));
  assert_true(host->plugin->start_processing(host->plugin));
  host->is_active = true;
}

void clap_host_deactivate(ClapHost *host) {
  host->plugin->stop_processing(host->plugin);
  host->plugin->deactivate(host->plugin);
  host->is_active = false;
}

void clap_host_close(ClapHost *host) {
  if (host->is_active) clap_host_deactivate(host);
  host->plugin->destroy(host->plugin);
  free(host);
}

const void *clap_host_extension(const ClapHost *host, const char *id) {
  const void *const found = host->plugin->get_extension(host->plugin, id);
  assert_non_null(found);
  return found;
}

void clap_host_render(ClapHost *host, bool offline) {
  const clap_plugin_render_t *const render = clap_host_extension(host, CLAP_EXT_RENDER);
  assert_true(render->set(host->plugin, offline ? CLAP_RENDER_OFFLINE : CLAP_RENDER_REALTIME));
}

/* ---- events --------------------------------------------------------------------------------- */

clap_id clap_host_id(KnobId knob) {
  clap_id id = 0;
  while (knob_ports[id] != knob) id++;
  return id;
}

double clap_host_pitch(double hertz) {
  TaborDrumDef usual;
  assert_int_equal(tabor_drum_def_preset(&usual, DEFAULT_PRESET, NULL), TABOR_OK);
  const KnobRange range = knob_range(KNOB_BATTER_PITCH, &usual);
  return knob_position(&range, hertz);
}

static ClapEvent *add(ClapHost *host, uint32_t time, uint16_t type, size_t size) {
  assert_true(host->event_count < CLAP_EVENTS);
  ClapEvent *const event = &host->events[host->event_count++];
  memset(event, 0, sizeof *event);
  event->header = (clap_event_header_t){.size = (uint32_t)size, .time = time, .type = type};
  return event;
}

void clap_host_set_id(ClapHost *host, uint32_t time, clap_id id, double value) {
  ClapEvent *const event = add(host, time, CLAP_EVENT_PARAM_VALUE, sizeof event->value);
  event->value.param_id = id;
  event->value.note_id = event->value.port_index = event->value.channel = event->value.key = -1;
  event->value.value = value;
}

void clap_host_set(ClapHost *host, uint32_t time, KnobId knob, double value) {
  clap_host_set_id(host, time, clap_host_id(knob), value);
}

void clap_host_modulate(ClapHost *host, uint32_t time, KnobId knob, double amount) {
  ClapEvent *const event = add(host, time, CLAP_EVENT_PARAM_MOD, sizeof event->modulation);
  event->modulation.param_id = clap_host_id(knob);
  event->modulation.note_id = event->modulation.port_index = -1;
  event->modulation.channel = event->modulation.key = -1;
  event->modulation.amount = amount;
}

void clap_host_midi(ClapHost *host, uint32_t time, const MidiMessage *message) {
  ClapEvent *const event = add(host, time, CLAP_EVENT_MIDI, sizeof event->midi);
  const uint8_t bytes[] = {message->status, message->data[0], message->data[1]};
  memcpy(event->midi.data, bytes, sizeof bytes);
}

void clap_host_note(ClapHost *host, uint32_t time, uint16_t type, int16_t key, double velocity) {
  ClapEvent *const event = add(host, time, type, sizeof event->note);
  event->note.note_id = -1;
  event->note.channel = 9;
  event->note.key = key;
  event->note.velocity = velocity;
}

void clap_host_express(ClapHost *host, uint32_t time, clap_note_expression what, int16_t key,
                       double value) {
  ClapEvent *const event = add(host, time, CLAP_EVENT_NOTE_EXPRESSION, sizeof event->expression);
  event->expression.expression_id = what;
  event->expression.note_id = -1;
  event->expression.channel = 9;
  event->expression.key = key;
  event->expression.value = value;
}

static uint32_t count_events(const clap_input_events_t *list) {
  return ((const ClapHost *)list->ctx)->event_count;
}

static const clap_event_header_t *get_event(const clap_input_events_t *list, uint32_t index) {
  return &((const ClapHost *)list->ctx)->events[index].header;
}

static bool push_event(const clap_output_events_t *list, const clap_event_header_t *event) {
  ClapHost *const host = list->ctx;
  host->ended += event->type == CLAP_EVENT_NOTE_END;
  host->gestures += event->type == CLAP_EVENT_PARAM_GESTURE_BEGIN;
  if (event->type == CLAP_EVENT_PARAM_VALUE) {
    const clap_event_param_value_t *const value = (const clap_event_param_value_t *)event;
    host->turns++;
    host->turned = value->param_id;
    host->turned_to = value->value;
  }
  return true;
}

void clap_host_flush(ClapHost *host) {
  const clap_plugin_params_t *const params = clap_host_extension(host, CLAP_EXT_PARAMS);
  const clap_input_events_t in = {host, count_events, get_event};
  const clap_output_events_t out = {host, push_event};
  params->flush(host->plugin, &in, &out);
  host->event_count = 0;
}

double clap_host_value(const ClapHost *host, KnobId knob) {
  const clap_plugin_params_t *const params = clap_host_extension(host, CLAP_EXT_PARAMS);
  double value = NAN;
  assert_true(params->get_value(host->plugin, clap_host_id(knob), &value));
  return value;
}

/* ---- blocks --------------------------------------------------------------------------------- */

void clap_host_run(ClapHost *host, uint32_t frames) {
  const clap_input_events_t in = {host, count_events, get_event};
  const clap_output_events_t out = {host, push_event};
  float *channels[CLAP_CHANNELS];
  clap_audio_buffer_t outputs[CLAP_PORTS];
  uint32_t next = 0;
  for (uint32_t i = 0; i < CLAP_CHANNELS; i++) channels[i] = host->sound[i];
  for (uint32_t i = 0; i < host->port_count; i++) {
    outputs[i] = (clap_audio_buffer_t){.data32 = &channels[next], .channel_count = host->widths[i]};
    next += host->widths[i];
  }
  float *inputs[2] = {host->input[0], host->input[1]};
  clap_audio_buffer_t input = {.data32 = inputs, .channel_count = 2};
  const clap_process_t block = {.steady_time = -1,
                                .frames_count = frames,
                                .audio_inputs = host->has_input ? &input : NULL,
                                .audio_inputs_count = host->has_input,
                                .audio_outputs = outputs,
                                .audio_outputs_count = host->port_count,
                                .in_events = &in,
                                .out_events = &out};
  assert_true(frames <= CLAP_BLOCK);
  host->status = host->plugin->process(host->plugin, &block);
  assert_int_not_equal(host->status, CLAP_PROCESS_ERROR);
  host->event_count = 0;
}

/* ---- states --------------------------------------------------------------------------------- */

/* A few bytes at once, as hosts may. */
static uint64_t part_of(uint64_t size) { return size < 61 ? size : 61; }

static int64_t write_state(const clap_ostream_t *stream, const void *bytes, uint64_t size) {
  ClapState *const state = stream->ctx;
  const uint64_t part = part_of(size);
  assert_true(state->size + part <= CLAP_STATE);
  memcpy(state->bytes + state->size, bytes, part);
  state->size += part;
  return (int64_t)part;
}

static int64_t read_state(const clap_istream_t *stream, void *bytes, uint64_t size) {
  ClapState *const state = stream->ctx;
  const uint64_t left = state->size - state->at;
  const uint64_t part = part_of(size < left ? size : left);
  memcpy(bytes, state->bytes + state->at, part);
  state->at += part;
  return (int64_t)part;
}

void clap_host_save(ClapHost *host, ClapState *state) {
  const clap_plugin_state_t *const states = clap_host_extension(host, CLAP_EXT_STATE);
  const clap_ostream_t stream = {state, write_state};
  state->size = state->at = 0;
  assert_true(states->save(host->plugin, &stream));
}

bool clap_host_load_in(ClapHost *host, ClapState *state, uint32_t context) {
  const clap_plugin_state_context_t *const states =
    clap_host_extension(host, CLAP_EXT_STATE_CONTEXT);
  const clap_istream_t stream = {state, read_state};
  state->at = 0;
  return states->load(host->plugin, &stream, context);
}

bool clap_host_load(ClapHost *host, ClapState *state) {
  const clap_plugin_state_t *const states = clap_host_extension(host, CLAP_EXT_STATE);
  const clap_istream_t stream = {state, read_state};
  state->at = 0;
  return states->load(host->plugin, &stream);
}
