/* SPDX-License-Identifier: MIT */
#include "clap/instance.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "clap/gui.h"
#include "clap/host_calls.h"
#include "clap/note_events.h"
#include "clap/parameters.h"
#include "clap/ports.h"
#include "clap/presets.h"
#include "clap/state.h"
#include "plugin/plugin_run.h"

/* ---- beginning and end ---------------------------------------------------------------------- */

static void say(void *context, const char *line) {
  const Instance *const instance = context;
  char text[INSTRUMENT_MESSAGE + 32];
  (void)snprintf(text, sizeof text, "%s: %s", instance->instrument->kind->name, line);
  if (instance->log) instance->log->log(instance->host, CLAP_LOG_ERROR, text);
}

/* A KitPool's. CLAP has this call for the audio thread; the compiler cannot know that of a pointer.
 */
static bool run_parts(void *context, uint32_t parts) {
  const Instance *const instance = context;
  return instance->threads->request_exec(instance->host, parts);
}

static void play_part(const clap_plugin_t *plugin, uint32_t part) {
  Instrument *const instrument = instrument_of(plugin);
  if (instrument->kind->calls->play_part) instrument->kind->calls->play_part(instrument, part);
}

static bool init(const clap_plugin_t *plugin) {
  Instance *const instance = instance_of(plugin);
  const clap_host_t *const host = instance->host;
  instance->log = host->get_extension(host, CLAP_EXT_LOG);
  instance->params = host->get_extension(host, CLAP_EXT_PARAMS);
  instance->note_names = host->get_extension(host, CLAP_EXT_NOTE_NAME);
  instance->threads = host->get_extension(host, CLAP_EXT_THREAD_POOL);
  instance->pool = (KitPool){.run = run_parts, .context = instance};
  if (instance->threads) instance->instrument->pool = &instance->pool;
  return true;
}

static void close(Instance *instance) {
  Instrument *const instrument = instance->instrument;
  if (!instrument->is_open) return;
  builder_cancel(instrument->builder);
  worker_thread_stop(&instance->thread);
  instrument_close(instrument);
}

static bool open(Instance *instance, double rate) {
  Instrument *const instrument = instance->instrument;
  close(instance);
  if (!instrument_open(instrument, rate)) return false;
  if (!instrument->is_open) return true; /* and is silent */
  if (worker_thread_start(&instance->thread, instrument_work, instrument)) return true;
  instrument_close(instrument);
  return false;
}

static void destroy(const clap_plugin_t *plugin) {
  Instance *const instance = instance_of(plugin);
  gui_end(plugin);
  close(instance);
  gui_link_end(&instance->link);
  instrument_destroy(instance->instrument);
  free(instance);
}

/* What the knobs ask for, or a session that was loaded, is there before the first block. */
static bool activate(const clap_plugin_t *plugin, double rate, uint32_t least, uint32_t most) {
  Instrument *const instrument = instrument_of(plugin);
  const InstrumentCalls *const calls = instrument->kind->calls;
  const bool is_there = instrument->is_open && rate == instrument->rate;
  (void)least;
  (void)most;
  if (!is_there && !open(instance_of(plugin), rate)) return false;
  if (!instrument->is_open) return true;
  if (is_there) {
    builder_resume(instrument->builder);
    calls->rest(instrument);
  }
  if (!calls->is_there(instrument)) plugin_run_prepare(instrument);
  return true;
}

static void deactivate(const clap_plugin_t *plugin) {
  Instrument *const instrument = instrument_of(plugin);
  if (instrument->is_open) builder_cancel(instrument->builder);
}

static bool start_processing(const clap_plugin_t *plugin) {
  (void)plugin;
  return true;
}

static void stop_processing(const clap_plugin_t *plugin) { (void)plugin; }

static void reset(const clap_plugin_t *plugin) {
  Instrument *const instrument = instrument_of(plugin);
  if (instrument->is_open) instrument->kind->calls->rest(instrument);
}

/* ---- the host's main thread ----------------------------------------------------------------- */

/* CLAP declares these calls thread-safe: hosts only note what they are asked for. The compiler
 * cannot know that of a pointer. */
typedef void RequestFn(const clap_host_t *host) REALTIME;

static void call_main_thread(Instance *instance) REALTIME {
  const Instrument *const instrument = instance->instrument;
  const bool has_news = atomic_load(&instrument->has_moved) || atomic_load(&instrument->is_renamed);
  if (!has_news || atomic_exchange(&instance->is_called, true)) return;
  RequestFn *const request = (RequestFn *)instance->host->request_callback;
  request(instance->host);
}

static void on_main_thread(const clap_plugin_t *plugin) {
  Instance *const instance = instance_of(plugin);
  atomic_store(&instance->is_called, false);
  if (atomic_exchange(&instance->instrument->has_moved, false)) host_rescan(instance);
  if (atomic_exchange(&instance->instrument->is_renamed, false) && instance->note_names)
    instance->note_names->changed(instance->host);
}

/* ---- blocks --------------------------------------------------------------------------------- */

static const clap_event_header_t *event_at(const Instance *instance, uint32_t number) REALTIME {
  return event_list_at(&instance->list, number);
}

/* True for event number @p number if it acts at the frame. */
static bool acts_at(const Instance *instance, uint32_t number, uint32_t frame) REALTIME {
  const clap_event_header_t *const event = event_at(instance, number);
  return event && event_list_frame(&instance->list, event, frame) == frame;
}

static bool find_event(void *shell, uint32_t *frame) REALTIME {
  const Instance *const instance = shell;
  const clap_event_header_t *const event = event_at(instance, instance->event);
  if (event) *frame = event_list_frame(&instance->list, event, *frame);
  return event != NULL;
}

static bool note_knobs(void *shell, uint32_t frame) REALTIME {
  Instance *const instance = shell;
  bool any = false;
  for (uint32_t i = instance->event; acts_at(instance, i, frame); i++) {
    if (parameters_take(instance, event_at(instance, i))) any = true;
  }
  return any;
}

/* Silence acts before all notes of its frame, so those that it ends must not begin: `choked` has
 * the number of the last event that chokes a key, 0 if none, from 1. */
static bool is_choked(const MidiMessage *message, uint32_t number,
                      const uint32_t choked[MIDI_VALUES]) REALTIME {
  return midi_kind(message) == MIDI_NOTE_ON && number < choked[message->data[0]];
}

static void take_event(Instance *instance, uint32_t frame, bool notes,
                       const uint32_t choked[MIDI_VALUES]) REALTIME {
  const clap_event_header_t *const event = event_at(instance, instance->event);
  MidiMessage messages[NOTE_EVENT_MESSAGES];
  uint32_t count = note_event_messages(event, messages);
  if (count > 0 && is_choked(&messages[count - 1], instance->event, choked)) count = 0;
  for (uint32_t i = 0; i < count; i++) {
    if (midi_goes_with_notes(&messages[i]) != notes) continue;
    instance->instrument->kind->calls->take(instance->instrument, &messages[i], frame);
  }
  if (notes) event_list_end_note(&instance->list, event);
}

static void choke(Instance *instance, uint32_t frame, uint32_t choked[MIDI_VALUES]) REALTIME {
  Instrument *const instrument = instance->instrument;
  for (uint32_t i = instance->event; acts_at(instance, i, frame); i++) {
    const clap_event_header_t *const event = event_at(instance, i);
    if (!note_event_is_choke(event)) continue;
    const int16_t key = ((const clap_event_note_t *)event)->key;
    note_event_choke(event, i + 1u, choked);
    instrument->kind->calls->choke(instrument, key >= 0 && key < MIDI_VALUES ? key : -1, frame);
  }
}

/* Silences first, then controllers, then notes. */
static void take_frame(void *shell, uint32_t frame) REALTIME {
  Instance *const instance = shell;
  const uint32_t first = instance->event;
  uint32_t choked[MIDI_VALUES] = {0};
  choke(instance, frame, choked);
  for (int notes = 0; notes <= 1; notes++) {
    for (instance->event = first; acts_at(instance, instance->event, frame); instance->event++)
      take_event(instance, frame, notes == 1, choked);
  }
}

static const PluginEvents run_events = {
  .find = find_event, .note_knobs = note_knobs, .take = take_frame};

/* A host does not call an effect that sleeps until its input changes. */
static bool is_fed(const Instance *instance) REALTIME {
  const PluginBuffers *const buffers = &instance->instrument->buffers;
  for (uint32_t side = 0; side < 2 && buffers->input[0]; side++) {
    for (uint32_t i = 0; i < instance->list.frames; i++) {
      if (buffers->channels[side] && buffers->channels[side][i] != 0) return true;
    }
  }
  return false;
}

static clap_process_status status_of(const Instance *instance) REALTIME {
  const Instrument *const instrument = instance->instrument;
  return instrument_is_settled(instrument) && instrument->kind->calls->is_silent(instrument) &&
             !is_fed(instance)
           ? CLAP_PROCESS_SLEEP
           : CLAP_PROCESS_CONTINUE;
}

/* The host turns knobs all the same. */
static clap_process_status play_silence(Instance *instance) REALTIME {
  for (uint32_t i = 0; i < instance->list.count; i++) {
    (void)parameters_take(instance, event_at(instance, i));
  }
  for (uint32_t i = 0; i < PLUGIN_CHANNELS; i++) {
    float *const channel = instance->instrument->buffers.channels[i];
    if (channel) memset(channel, 0, instance->list.frames * sizeof(float));
  }
  return CLAP_PROCESS_SLEEP;
}

static clap_process_status process(const clap_plugin_t *plugin, const clap_process_t *block) {
  Instance *const instance = instance_of(plugin);
  Instrument *const instrument = instance->instrument;
  ports_connect(instrument, block);
  instance->list = event_list_of(block);
  instance->event = 0;
  gui_link_report(&instance->link, block->out_events);
  if (!instrument->is_open) return play_silence(instance);
  PluginRun run = {.instrument = instrument,
                   .events = &run_events,
                   .shell = instance,
                   .frames = block->frames_count,
                   .waits = atomic_load(&instrument->is_offline)};
  instrument_begin_block(instrument);
  window_link_play(instrument);
  if (run.waits) {
    plugin_run_waiting(&run);
  } else {
    (void)plugin_run_live(&run);
  }
  window_link_show(instrument, block->frames_count);
  call_main_thread(instance);
  return status_of(instance);
}

/* ---- extensions ----------------------------------------------------------------------------- */

static const clap_plugin_thread_pool_t thread_pool = {.exec = play_part};

static const void *get_extension(const clap_plugin_t *plugin, const char *id) {
  (void)plugin;
  static const struct {
    const char *id;
    const void *extension;
  } all[] = {{CLAP_EXT_PARAMS, &parameters_extension},
             {CLAP_EXT_STATE, &state_extension},
             {CLAP_EXT_STATE_CONTEXT, &state_context_extension},
             {CLAP_EXT_AUDIO_PORTS, &ports_audio},
             {CLAP_EXT_NOTE_PORTS, &ports_notes},
             {CLAP_EXT_NOTE_NAME, &ports_note_names},
             {CLAP_EXT_LATENCY, &ports_latency},
             {CLAP_EXT_TAIL, &ports_tail},
             {CLAP_EXT_RENDER, &ports_render},
             {CLAP_EXT_THREAD_POOL, &thread_pool},
             {CLAP_EXT_PRESET_LOAD, &presets_load},
             {CLAP_EXT_PRESET_LOAD_COMPAT, &presets_load},
             {CLAP_EXT_REMOTE_CONTROLS, &parameters_remote_controls},
             {CLAP_EXT_REMOTE_CONTROLS_COMPAT, &parameters_remote_controls}};
  for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) {
    if (strcmp(id, all[i].id) == 0) return all[i].extension;
  }
  return gui_extension(id);
}

static bool begin(Instance *instance, const InstrumentKind *kind) {
  instance->instrument = instrument_create(kind);
  if (!instance->instrument) return false;
  instance->instrument->say = say;
  instance->instrument->context = instance;
  instance->instrument->has_movable_knobs = true;
  return gui_link_begin(&instance->link);
}

const clap_plugin_t *instance_create(const clap_plugin_descriptor_t *descriptor,
                                     const clap_host_t *host, const InstrumentKind *kind) {
  Instance *const instance = calloc(1, sizeof *instance);
  if (!instance) return NULL;
  instance->host = host;
  instance->plugin = (clap_plugin_t){.desc = descriptor,
                                     .plugin_data = instance,
                                     .init = init,
                                     .destroy = destroy,
                                     .activate = activate,
                                     .deactivate = deactivate,
                                     .start_processing = start_processing,
                                     .stop_processing = stop_processing,
                                     .reset = reset,
                                     .process = process,
                                     .get_extension = get_extension,
                                     .on_main_thread = on_main_thread};
  if (begin(instance, kind)) return &instance->plugin;
  gui_link_end(&instance->link);
  instrument_destroy(instance->instrument);
  free(instance);
  return NULL;
}
