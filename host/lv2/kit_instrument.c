/* SPDX-License-Identifier: MIT */
#include "lv2/kit_instrument.h"

#include <lv2/midi/midi.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "lv2/kit_ports.h"
#include "lv2/uris.h"

/* ---- beginning and end ---------------------------------------------------------------------- */

static void say(void *context, const char *line) { kit_instrument_say(context, line); }

static void load_own_kit(KitInstrument *kit) {
  char message[2 * TABOR_TEXT_SIZE];
  if (!own_kit_work(&kit->own, message, sizeof message)) kit_instrument_say(kit, message);
}

static void work(void *instance) {
  KitInstrument *const kit = instance;
  load_own_kit(kit);
  kit_worker_work(&kit->worker);
}

static bool open(KitInstrument *kit, double rate) {
  LV2_URID_Map *const map = kit->host.map;
  kit->sequence = map->map(map->handle, LV2_ATOM__Sequence);
  kit->midi = map->map(map->handle, LV2_MIDI__MidiEvent);
  kit->file = map->map(map->handle, URI_KIT_FILE);
  kit->state = map->map(map->handle, URI_STATE_KIT);
  kit->atom_string = map->map(map->handle, LV2_ATOM__String);
  kit->set_path = set_path_urids(map);
  kit_worker_begin(&kit->worker, rate, &kit->own, say, kit);
  kit_plugin_player_begin(&kit->player, &kit->worker);
  return kit_window_link_begin(&kit->window) && worker_thread_start(&kit->thread, work, kit);
}

static void cleanup(LV2_Handle handle) {
  KitInstrument *const kit = handle;
  kit_worker_cancel(&kit->worker);
  worker_thread_stop(&kit->thread);
  kit_plugin_player_end(&kit->player);
  kit_worker_end(&kit->worker);
  kit_window_link_end(&kit->window);
  own_kit_end(&kit->own);
  free(kit);
}

static LV2_Handle instantiate(const LV2_Descriptor *descriptor, double rate, const char *bundle,
                              const LV2_Feature *const *features) {
  (void)descriptor;
  (void)bundle;
  KitInstrument *const kit = calloc(1, sizeof *kit);
  if (!kit) return NULL;
  kit->size = sizeof *kit;
  kit->version = tabor_version();
  if (!host_features_find(features, rate, "Tabor Kit", &kit->host) || !own_kit_begin(&kit->own)) {
    free(kit);
    return NULL;
  }
  if (open(kit, rate)) return kit;
  cleanup(kit);
  return NULL;
}

static void connect_output(KitPluginOutputs *outputs, uint32_t channel, float *data) {
  const uint32_t pair = channel / 2, side = channel % 2;
  if (pair == 0) {
    outputs->mix[side] = data;
  } else {
    outputs->drum[pair - 1][side] = data;
  }
}

static void connect_port(LV2_Handle handle, uint32_t number, void *data) {
  KitInstrument *const kit = handle;
  const Port port = kit_port_at(number);
  switch (port.kind) {
  case PORT_EVENTS: kit->events = data; break;
  case PORT_OUTPUT: connect_output(&kit->outputs, port.index, data); break;
  case PORT_FREEWHEEL: kit->freewheel = data; break;
  case PORT_READY: kit->ready = data; break;
  case PORT_KNOB: kit->knob_ports[port.index] = data; break;
  case PORT_INPUT: /* the kit has none */
  case PORT_NONE: break;
  }
}

static void activate(LV2_Handle handle) {
  KitInstrument *const kit = handle;
  kit_worker_resume(&kit->worker);
  kit_plugin_player_rest(&kit->player);
}

static void deactivate(LV2_Handle handle) {
  KitInstrument *const kit = handle;
  kit_worker_cancel(&kit->worker);
}

/* ---- runs ----------------------------------------------------------------------------------- */

/* What is no number leaves the knob where it is: at first at its default. */
static void turn_knobs(KitInstrument *kit) REALTIME;
static void turn_knobs(KitInstrument *kit) {
  for (uint32_t i = 0; i < KIT_KNOB_COUNT; i++) {
    const KitKnobId id = (KitKnobId)i;
    const float *const port = kit->knob_ports[i];
    if (!port || !isfinite(*port)) continue;
    kit_plugin_player_turn(&kit->player, id, kit_knob_clamp(id, (double)*port));
  }
}

/* A frame whose messages are taken. */
typedef struct Frame {
  KitPluginPlayer *player;
  uint32_t at;
} Frame;

static void take_message(void *context, const MidiMessage *message) REALTIME;
static void take_message(void *context, const MidiMessage *message) {
  const Frame *const frame = context;
  kit_plugin_player_take(frame->player, message, frame->at);
}

static void play(KitInstrument *kit, uint32_t frames) REALTIME;
static void play(KitInstrument *kit, uint32_t frames) {
  Frame frame = {.player = &kit->player};
  MidiSequence messages = {
    .sequence = sequence_begin(kit->events, kit->sequence), .midi = kit->midi, .frames = frames};
  while (midi_sequence_find(&messages, &frame.at)) {
    midi_sequence_take(&messages, frame.at, take_message, &frame);
  }
  kit_plugin_player_play(&kit->player, frames);
}

/* Files that the host sets, whatever their frames. */
static void ask_for_kits(KitInstrument *kit) REALTIME;
static void ask_for_kits(KitInstrument *kit) {
  Sequence sequence = sequence_begin(kit->events, kit->sequence);
  const LV2_Atom_Event *event;
  size_t length;
  for (; (event = sequence_event(&sequence)); sequence_step(&sequence)) {
    const char *const path = set_path_read(event, &kit->set_path, kit->file, &length);
    if (path) (void)own_kit_ask(&kit->own, path, length);
  }
}

/* A host that renders waits for what it has asked for. */
static void wait(KitInstrument *kit) {
  load_own_kit(kit);
  kit_plugin_player_wait(&kit->player);
}

/* Knobs are ports, which change between runs alone. */
static void run(LV2_Handle handle, uint32_t frames) {
  KitInstrument *const kit = handle;
  kit_plugin_player_begin_block(&kit->player, &kit->outputs);
  turn_knobs(kit);
  const bool exports = kit->freewheel && *kit->freewheel > 0;
  kit_plugin_player_export(&kit->player, exports);
  ask_for_kits(kit);
  if (exports) wait(kit);
  kit_plugin_player_keep_up(&kit->player);
  kit_window_link_play(&kit->window, &kit->player);
  play(kit, frames);
  kit_window_link_show(&kit->window, &kit->player, &kit->outputs, frames);
  if (kit->ready) *kit->ready = kit_plugin_player_is_settled(&kit->player) ? 1 : 0;
}

static const void *extension_data(const char *uri) {
  return strcmp(uri, LV2_STATE__interface) == 0 ? &kit_instrument_state : NULL;
}

const LV2_Descriptor kit_instrument = {.URI = URI_KIT,
                                       .instantiate = instantiate,
                                       .connect_port = connect_port,
                                       .activate = activate,
                                       .run = run,
                                       .deactivate = deactivate,
                                       .cleanup = cleanup,
                                       .extension_data = extension_data};
