/* SPDX-License-Identifier: MIT */
#include "clap/kit_instance.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "clap/extensions.h"
#include "clap/gui.h"
#include "clap/note_events.h"
#include "clap/presets.h"
#include "plugin/model_worker.h"

/* ---- beginning and end ---------------------------------------------------------------------- */

static void say(void *context, const char *line) { kit_instance_say(context, line); }

static bool init(const clap_plugin_t *plugin) {
  KitInstance *const instance = kit_instance_of(plugin);
  const clap_host_t *const host = instance->host;
  instance->log = host->get_extension(host, CLAP_EXT_LOG);
  instance->params = host->get_extension(host, CLAP_EXT_PARAMS);
  instance->note_names = host->get_extension(host, CLAP_EXT_NOTE_NAME);
  return true;
}

static void work(void *worker) { kit_worker_work(worker); }

static void close(KitInstance *instance) {
  if (!instance->is_open) return;
  instance->is_open = false;
  kit_worker_cancel(&instance->worker);
  worker_thread_stop(&instance->thread);
  kit_plugin_player_end(&instance->player);
  kit_worker_end(&instance->worker);
}

static bool open(KitInstance *instance, double rate) {
  kit_worker_begin(&instance->worker, rate, &instance->own, say, instance);
  kit_plugin_player_begin(&instance->player, &instance->worker);
  instance->is_open = worker_thread_start(&instance->thread, work, &instance->worker);
  return instance->is_open;
}

static void end_links(KitInstance *instance) {
  gui_link_end(&instance->link);
  kit_window_link_end(&instance->window);
}

static void destroy(const clap_plugin_t *plugin) {
  KitInstance *const instance = kit_instance_of(plugin);
  gui_end(plugin);
  close(instance);
  end_links(instance);
  own_kit_end(&instance->own);
  free(instance->named);
  free(instance);
}

static bool begin_rate(KitInstance *instance, double rate) {
  char line[96];
  close(instance);
  instance->rate = rate;
  if (rate >= MODEL_WORKER_LEAST_RATE && rate <= MODEL_WORKER_MOST_RATE)
    return open(instance, rate);
  (void)snprintf(line, sizeof line, "silent at a sample rate of %g Hz; from %d to %d Hz it sounds",
                 rate, MODEL_WORKER_LEAST_RATE, MODEL_WORKER_MOST_RATE);
  kit_instance_say(instance, line);
  return true;
}

/* The kit is there before the first block. */
static bool activate(const clap_plugin_t *plugin, double rate, uint32_t least, uint32_t most) {
  KitInstance *const instance = kit_instance_of(plugin);
  static const KitPluginOutputs none;
  (void)least;
  (void)most;
  if (instance->is_open && rate == instance->rate) {
    kit_worker_resume(&instance->worker);
    kit_plugin_player_rest(&instance->player);
  } else if (!begin_rate(instance, rate)) {
    return false;
  }
  if (!instance->is_open) return true;
  kit_plugin_player_begin_block(&instance->player, &none);
  kit_plugin_player_export(&instance->player, atomic_load(&instance->is_offline));
  kit_parameters_turn(instance);
  kit_plugin_player_wait(&instance->player);
  return true;
}

static void deactivate(const clap_plugin_t *plugin) {
  KitInstance *const instance = kit_instance_of(plugin);
  if (instance->is_open) kit_worker_cancel(&instance->worker);
}

static bool start_processing(const clap_plugin_t *plugin) {
  (void)plugin;
  return true;
}

static void stop_processing(const clap_plugin_t *plugin) { (void)plugin; }

static void reset(const clap_plugin_t *plugin) {
  KitInstance *const instance = kit_instance_of(plugin);
  if (instance->is_open) kit_plugin_player_rest(&instance->player);
}

/* ---- blocks --------------------------------------------------------------------------------- */

/* Events of one frame of a block: from `event` to before `end`. */
typedef struct Frame {
  EventList *list;
  uint32_t event, end, at;
} Frame;

static Frame frame_at(EventList *list, uint32_t event, uint32_t at) REALTIME;
static Frame frame_at(EventList *list, uint32_t event, uint32_t at) {
  const clap_event_header_t *next = event_list_at(list, event);
  Frame frame = {.list = list, .event = event, .end = event, .at = at};
  if (next) frame.at = event_list_frame(list, next, at);
  while (next && event_list_frame(list, next, frame.at) == frame.at) {
    next = event_list_at(list, ++frame.end);
  }
  return frame;
}

static bool note_knobs(KitInstance *instance, const Frame *frame) REALTIME;
static bool note_knobs(KitInstance *instance, const Frame *frame) {
  bool any = false;
  for (uint32_t i = frame->event; i < frame->end; i++) {
    if (kit_parameters_take(instance, event_list_at(frame->list, i))) any = true;
  }
  return any;
}

/* A knob turns where the block has been played to. */
static void turn_knobs(KitInstance *instance, const Frame *frame) REALTIME;
static void turn_knobs(KitInstance *instance, const Frame *frame) {
  if (!note_knobs(instance, frame)) return;
  kit_plugin_player_play(&instance->player, frame->at);
  kit_parameters_turn(instance);
}

/* Silences, with the keys of notes that must not begin any more. */
static void choke(KitInstance *instance, const Frame *frame, uint32_t choked[MIDI_VALUES]) REALTIME;
static void choke(KitInstance *instance, const Frame *frame, uint32_t choked[MIDI_VALUES]) {
  for (uint32_t i = frame->event; i < frame->end; i++) {
    const clap_event_header_t *const event = event_list_at(frame->list, i);
    note_event_choke(event, i + 1u, choked);
    if (!note_event_is_choke(event)) continue;
    const int16_t key = ((const clap_event_note_t *)event)->key;
    kit_plugin_player_choke(&instance->player, key >= 0 && key < MIDI_VALUES ? key : -1, frame->at);
  }
}

static void take_event(KitInstance *instance, const Frame *frame, uint32_t number, bool notes,
                       const uint32_t choked[MIDI_VALUES]) REALTIME;
static void take_event(KitInstance *instance, const Frame *frame, uint32_t number, bool notes,
                       const uint32_t choked[MIDI_VALUES]) {
  const clap_event_header_t *const event = event_list_at(frame->list, number);
  MidiMessage messages[NOTE_EVENT_MESSAGES];
  uint32_t count = note_event_is_choke(event) ? 0 : note_event_messages(event, messages);
  const MidiMessage *const last = count > 0 ? &messages[count - 1] : NULL;
  if (last && midi_kind(last) == MIDI_NOTE_ON && number < choked[last->data[0]]) count = 0;
  for (uint32_t i = 0; i < count; i++) {
    if (midi_goes_with_notes(&messages[i]) != notes) continue;
    kit_plugin_player_take(&instance->player, &messages[i], frame->at);
  }
  if (notes) event_list_end_note(frame->list, event);
}

/* Silences first, then controllers, then notes. */
static void take_frame(KitInstance *instance, const Frame *frame) REALTIME;
static void take_frame(KitInstance *instance, const Frame *frame) {
  uint32_t choked[MIDI_VALUES] = {0};
  choke(instance, frame, choked);
  for (int notes = 0; notes <= 1; notes++) {
    for (uint32_t i = frame->event; i < frame->end; i++) {
      take_event(instance, frame, i, notes == 1, choked);
    }
  }
}

/* At one frame first knobs, then messages. A host that renders waits for what a knob has built. */
static void play(KitInstance *instance, EventList *list) {
  KitPluginPlayer *const player = &instance->player;
  const bool waits = atomic_load(&instance->is_offline);
  kit_plugin_player_export(player, waits);
  Frame frame = {.list = list};
  kit_parameters_turn(instance);
  do {
    if (waits) kit_plugin_player_wait(player);
    kit_plugin_player_keep_up(player);
    frame = frame_at(list, frame.end, frame.at);
    if (frame.end == frame.event) break;
    turn_knobs(instance, &frame);
    if (waits) kit_plugin_player_wait(player);
    take_frame(instance, &frame);
  } while (frame.end < list->count);
  kit_plugin_player_play(player, list->frames);
}

/* The host turns knobs all the same. */
static clap_process_status play_silence(KitInstance *instance, EventList *list,
                                        const KitPluginOutputs *outputs) REALTIME;
static clap_process_status play_silence(KitInstance *instance, EventList *list,
                                        const KitPluginOutputs *outputs) {
  for (uint32_t i = 0; i < list->count; i++) {
    (void)kit_parameters_take(instance, event_list_at(list, i));
  }
  for (uint32_t side = 0; side < 2; side++) {
    if (outputs->mix[side]) memset(outputs->mix[side], 0, list->frames * sizeof(float));
    for (uint32_t i = 0; i < KIT_KNOB_DRUMS; i++) {
      if (outputs->drum[i][side]) memset(outputs->drum[i][side], 0, list->frames * sizeof(float));
    }
  }
  return CLAP_PROCESS_SLEEP;
}

static clap_process_status process(const clap_plugin_t *plugin, const clap_process_t *block) {
  KitInstance *const instance = kit_instance_of(plugin);
  KitPluginPlayer *const player = &instance->player;
  EventList list = event_list_of(block);
  KitPluginOutputs outputs;
  kit_ports_connect(block, &outputs);
  gui_link_report(&instance->link, block->out_events);
  if (!instance->is_open) return play_silence(instance, &list, &outputs);
  kit_plugin_player_begin_block(player, &outputs);
  kit_window_link_play(&instance->window, player);
  play(instance, &list);
  kit_window_link_show(&instance->window, player, &outputs, list.frames);
  return kit_plugin_player_is_settled(player) && kit_plugin_player_is_silent(player)
           ? CLAP_PROCESS_SLEEP
           : CLAP_PROCESS_CONTINUE;
}

/* ---- extensions ----------------------------------------------------------------------------- */

static void on_main_thread(const clap_plugin_t *plugin) {
  const KitInstance *const instance = kit_instance_of(plugin);
  if (instance->note_names) instance->note_names->changed(instance->host);
}

static const void *get_extension(const clap_plugin_t *plugin, const char *id) {
  (void)plugin;
  static const Extension all[] = {{CLAP_EXT_PARAMS, &kit_params},
                                  {CLAP_EXT_STATE, &kit_state},
                                  {CLAP_EXT_AUDIO_PORTS, &kit_audio_ports},
                                  {CLAP_EXT_NOTE_PORTS, &extension_note_input},
                                  {CLAP_EXT_NOTE_NAME, &kit_note_names},
                                  {CLAP_EXT_TAIL, &kit_tail},
                                  {CLAP_EXT_PRESET_LOAD, &kit_preset_load},
                                  {CLAP_EXT_PRESET_LOAD_COMPAT, &kit_preset_load},
                                  {CLAP_EXT_RENDER, &kit_render}};
  const void *const window = gui_extension(id);
  return window ? window : extension_find(all, sizeof all / sizeof all[0], id);
}

const clap_plugin_t *kit_instance_create(const clap_plugin_descriptor_t *descriptor,
                                         const clap_host_t *host) {
  KitInstance *const instance = calloc(1, sizeof *instance);
  if (!instance) return NULL;
  instance->host = host;
  for (uint32_t i = 0; i < KIT_KNOB_COUNT; i++) {
    atomic_init(&instance->values[i], kit_knobs[i].fallback);
  }
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
  if (own_kit_begin(&instance->own)) {
    if (gui_link_begin(&instance->link) && kit_window_link_begin(&instance->window))
      return &instance->plugin;
    end_links(instance);
    own_kit_end(&instance->own);
  }
  free(instance);
  return NULL;
}
