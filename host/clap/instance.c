/* SPDX-License-Identifier: MIT */
#include "clap/instance.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "clap/extensions.h"
#include "clap/gui.h"
#include "clap/instance_drum.h"
#include "clap/instance_state.h"
#include "clap/note_events.h"
#include "clap/parameters.h"
#include "clap/ports.h"
#include "clap/presets.h"

/* ---- beginning and end ---------------------------------------------------------------------- */

static void say(void *context, const char *line) { instance_say(context, line); }

static bool init(const clap_plugin_t *plugin) {
  Instance *const instance = instance_of(plugin);
  const clap_host_t *const host = instance->host;
  instance->log = host->get_extension(host, CLAP_EXT_LOG);
  instance->params = host->get_extension(host, CLAP_EXT_PARAMS);
  return true;
}

/* ---- drum and models ------------------------------------------------------------------------ */

static void work(void *worker) { model_worker_work(worker); }

static void free_all(Instance *instance) {
  model_worker_cancel(&instance->worker);
  worker_thread_stop(&instance->thread);
  plugin_player_end(&instance->player);
  model_worker_end(&instance->worker);
}

static void close(Instance *instance) {
  SavedState saved;
  if (!instance->is_open) return;
  instance_save(instance, &saved);
  instance->is_open = false;
  free_all(instance);
  instance_restore(instance, &saved);
}

static bool open(Instance *instance, double rate) {
  memset(&instance->worker, 0, sizeof instance->worker);
  memset(&instance->player, 0, sizeof instance->player);
  instance->worker.say = say;
  instance->worker.context = instance;
  if (!model_worker_begin(&instance->worker, rate, instance->stereo)) return false;
  if (instance->is_saved) model_worker_restore(&instance->worker, &instance->saved);
  instance->is_open =
    plugin_player_begin(&instance->player, &instance->worker, rate, instance->stereo) &&
    worker_thread_start(&instance->thread, work, &instance->worker);
  if (!instance->is_open) free_all(instance);
  return instance->is_open;
}

static void end_links(Instance *instance) {
  gui_link_end(&instance->link);
  window_link_end(&instance->window);
}

static void destroy(const clap_plugin_t *plugin) {
  Instance *const instance = instance_of(plugin);
  gui_end(plugin);
  close(instance);
  end_links(instance);
  free(instance);
}

/* ---- blocks --------------------------------------------------------------------------------- */

static const clap_event_header_t *event_at(const Instance *instance, uint32_t number) REALTIME;
static const clap_event_header_t *event_at(const Instance *instance, uint32_t number) {
  return event_list_at(&instance->list, number);
}

static uint32_t frame_of(const Instance *instance, const clap_event_header_t *event,
                         uint32_t at) REALTIME;
static uint32_t frame_of(const Instance *instance, const clap_event_header_t *event, uint32_t at) {
  return event_list_frame(&instance->list, event, at);
}

static bool find_event(void *shell, uint32_t frames, uint32_t *frame) REALTIME;
static bool find_event(void *shell, uint32_t frames, uint32_t *frame) {
  const Instance *const instance = shell;
  const clap_event_header_t *const event = event_at(instance, instance->event);
  (void)frames;
  if (event) *frame = frame_of(instance, event, *frame);
  return event != NULL;
}

static bool note_knobs(void *shell, uint32_t frame) REALTIME;
static bool note_knobs(void *shell, uint32_t frame) {
  Instance *const instance = shell;
  const clap_event_header_t *event;
  bool any = false;
  for (uint32_t i = instance->event; (event = event_at(instance, i)); i++) {
    if (frame_of(instance, event, frame) != frame) break;
    if (parameters_take(instance, event)) any = true;
  }
  return any;
}

/* Silence acts before all notes of its frame, so those that it ends must not begin. */
static bool is_choked(const Instance *instance, const MidiMessage *message) REALTIME;
static bool is_choked(const Instance *instance, const MidiMessage *message) {
  return midi_kind(message) == MIDI_NOTE_ON && instance->event < instance->choked[message->data[0]];
}

static void take_event(Instance *instance, const clap_event_header_t *event, bool notes,
                       uint32_t ahead) REALTIME;
static void take_event(Instance *instance, const clap_event_header_t *event, bool notes,
                       uint32_t ahead) {
  MidiMessage messages[NOTE_EVENT_MESSAGES];
  uint32_t count = note_event_messages(event, messages);
  if (count > 0 && is_choked(instance, &messages[count - 1])) count = 0;
  for (uint32_t i = 0; i < count; i++) {
    if (midi_goes_with_notes(&messages[i]) != notes) continue;
    plugin_player_take(&instance->player, &messages[i], ahead);
  }
  if (notes) event_list_end_note(&instance->list, event);
}

static void find_chokes(Instance *instance, uint32_t frame) REALTIME;
static void find_chokes(Instance *instance, uint32_t frame) {
  const clap_event_header_t *event;
  memset(instance->choked, 0, sizeof instance->choked);
  for (uint32_t i = instance->event; (event = event_at(instance, i)); i++) {
    if (frame_of(instance, event, frame) != frame) break;
    note_event_choke(event, i, instance->choked);
  }
}

/* Controllers before notes. */
static void take_frame(void *shell, uint32_t frame, uint32_t ahead) REALTIME;
static void take_frame(void *shell, uint32_t frame, uint32_t ahead) {
  Instance *const instance = shell;
  const uint32_t first = instance->event;
  const clap_event_header_t *event;
  find_chokes(instance, frame);
  for (int notes = 0; notes <= 1; notes++) {
    instance->event = first;
    while ((event = event_at(instance, instance->event)) &&
           frame_of(instance, event, frame) == frame) {
      take_event(instance, event, notes == 1, ahead);
      instance->event++;
    }
  }
}

static const PluginEvents run_events = {
  .turn = parameters_turn, .find = find_event, .note_knobs = note_knobs, .take = take_frame};

/* A host does not call an effect that sleeps until its input changes. */
static bool is_fed(const PluginOutputs *outputs, uint32_t frames) REALTIME;
static bool is_fed(const PluginOutputs *outputs, uint32_t frames) {
  for (uint32_t side = 0; side < 2 && outputs->input[0]; side++) {
    for (uint32_t i = 0; i < frames; i++) {
      if (outputs->channels[side] && outputs->channels[side][i] != 0) return true;
    }
  }
  return false;
}

static clap_process_status status_of(const Instance *instance,
                                     const PluginOutputs *outputs) REALTIME;
static clap_process_status status_of(const Instance *instance, const PluginOutputs *outputs) {
  const PluginPlayer *const player = &instance->player;
  return plugin_player_is_settled(player) && plugin_player_is_silent(player) &&
             !is_fed(outputs, instance->list.frames)
           ? CLAP_PROCESS_SLEEP
           : CLAP_PROCESS_CONTINUE;
}

/* The host turns knobs all the same. */
static clap_process_status play_silence(Instance *instance, const PluginOutputs *outputs) REALTIME;
static clap_process_status play_silence(Instance *instance, const PluginOutputs *outputs) {
  for (uint32_t i = 0; i < instance->list.count; i++) {
    (void)parameters_take(instance, event_at(instance, i));
  }
  for (uint32_t i = 0; i < PLUGIN_MICS; i++) {
    if (!outputs->channels[i]) continue;
    memset(outputs->channels[i], 0, instance->list.frames * sizeof(float));
  }
  return CLAP_PROCESS_SLEEP;
}

static clap_process_status process(const clap_plugin_t *plugin, const clap_process_t *block) {
  Instance *const instance = instance_of(plugin);
  PluginOutputs outputs;
  ports_connect(instance, block, &outputs);
  instance->list = event_list_of(block);
  instance->event = 0;
  gui_link_report(&instance->link, block->out_events);
  if (!instance->is_open) return play_silence(instance, &outputs);
  window_link_play(&instance->window, &instance->player);
  PluginRun run = {.player = &instance->player,
                   .outputs = &outputs,
                   .events = &run_events,
                   .shell = instance,
                   .frames = block->frames_count,
                   .waits = atomic_load(&instance->is_offline)};
  if (run.waits) {
    plugin_run_waiting(&run);
  } else {
    (void)plugin_run_live(&run);
  }
  window_link_show(&instance->window, &instance->player, &outputs, block->frames_count);
  return status_of(instance, &outputs);
}

static void silence_rate(Instance *instance, double rate) {
  char line[96];
  (void)snprintf(line, sizeof line, "silent at a sample rate of %g Hz; from %d to %d Hz it sounds",
                 rate, MODEL_WORKER_LEAST_RATE, MODEL_WORKER_MOST_RATE);
  instance_say(instance, line);
}

static bool begin_rate(Instance *instance, double rate) {
  close(instance);
  instance->rate = rate;
  if (!(rate >= MODEL_WORKER_LEAST_RATE && rate <= MODEL_WORKER_MOST_RATE)) {
    silence_rate(instance, rate);
    return true;
  }
  return open(instance, rate);
}

/* The first drum, or one that was loaded, is there before the first block. */
static bool activate(const clap_plugin_t *plugin, double rate, uint32_t least, uint32_t most) {
  Instance *const instance = instance_of(plugin);
  const PluginRun run = {.player = &instance->player, .events = &run_events, .shell = instance};
  (void)least;
  (void)most;
  const bool is_there = instance->is_open && rate == instance->rate;
  if (is_there) {
    model_worker_resume(&instance->worker);
    plugin_player_rest(&instance->player);
  }
  if (!is_there && !begin_rate(instance, rate)) return false;
  if (!instance->is_open || plugin_player_is_restored(&instance->player)) return true;
  plugin_player_export(&instance->player, atomic_load(&instance->is_offline));
  plugin_run_wait(&run);
  return true;
}

static void deactivate(const clap_plugin_t *plugin) {
  Instance *const instance = instance_of(plugin);
  if (instance->is_open) model_worker_cancel(&instance->worker);
}

static bool start_processing(const clap_plugin_t *plugin) {
  (void)plugin;
  return true;
}

static void stop_processing(const clap_plugin_t *plugin) { (void)plugin; }

static void reset(const clap_plugin_t *plugin) {
  Instance *const instance = instance_of(plugin);
  if (instance->is_open) plugin_player_rest(&instance->player);
}

static void on_main_thread(const clap_plugin_t *plugin) {
  Instance *const instance = instance_of(plugin);
  if (atomic_exchange(&instance->has_moved, false)) parameters_tell(instance);
}

/* ---- extensions ----------------------------------------------------------------------------- */

static const void *get_extension(const clap_plugin_t *plugin, const char *id) {
  (void)plugin;
  static const Extension all[] = {{CLAP_EXT_PARAMS, &instance_params},
                                  {CLAP_EXT_STATE, &instance_state},
                                  {CLAP_EXT_AUDIO_PORTS, &instance_audio_ports},
                                  {CLAP_EXT_NOTE_PORTS, &extension_note_input},
                                  {CLAP_EXT_LATENCY, &instance_latency},
                                  {CLAP_EXT_TAIL, &instance_tail},
                                  {CLAP_EXT_RENDER, &instance_render},
                                  {CLAP_EXT_PRESET_LOAD, &instance_preset_load},
                                  {CLAP_EXT_PRESET_LOAD_COMPAT, &instance_preset_load},
                                  {CLAP_EXT_REMOTE_CONTROLS, &instance_remote_controls},
                                  {CLAP_EXT_REMOTE_CONTROLS_COMPAT, &instance_remote_controls}};
  const void *const window = gui_extension(id);
  return window ? window : extension_find(all, sizeof all / sizeof all[0], id);
}

static bool begin(Instance *instance) {
  if (tabor_drum_def_preset(&instance->saved.def, DEFAULT_PRESET, NULL) != TABOR_OK) return false;
  for (uint32_t i = 0; i < KNOB_COUNT; i++) {
    instance->ranges[i] = knob_range_in(instance->set, (KnobId)i, &instance->saved.def);
    instance->values[i] = instance->ranges[i].fallback;
    if (i < KNOB_SEEN) instance->saved.seen[i] = instance->ranges[i].fallback;
  }
  return true;
}

const clap_plugin_t *instance_create(const clap_plugin_descriptor_t *descriptor,
                                     const clap_host_t *host, KnobSet set) {
  Instance *const instance = calloc(1, sizeof *instance);
  if (!instance) return NULL;
  instance->host = host;
  instance->set = set;
  instance->stereo = set != KNOBS_MULTI;
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
  if (begin(instance) && gui_link_begin(&instance->link) && window_link_begin(&instance->window))
    return &instance->plugin;
  end_links(instance);
  free(instance);
  return NULL;
}
