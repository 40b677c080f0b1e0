/* SPDX-License-Identifier: MIT */
/* What goes in and comes out of Tabor Kit: an input of notes, whose names follow the kit, the mix, and a stereo output
 * for each of the first drums. Render mode and tail are here, too. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "clap/extensions.h"
#include "clap/kit_instance.h"

/* ---- sound ---------------------------------------------------------------------------------- */

#define LONGEST_RING 20.0 /* [s] within which all drums and a hall have died away */

static uint32_t audio_count(const clap_plugin_t *plugin, bool is_input) {
  (void)plugin;
  return is_input ? 0 : 1 + KIT_KNOB_DRUMS;
}

static bool get_audio(const clap_plugin_t *plugin, uint32_t index, bool is_input,
                      clap_audio_port_info_t *info) {
  if (index >= audio_count(plugin, is_input)) return false;
  memset(info, 0, sizeof *info);
  info->id = index;
  (void)snprintf(info->name, sizeof info->name, index == 0 ? "Mix" : "Drum %u", index);
  info->flags = index == 0 ? CLAP_AUDIO_PORT_IS_MAIN : 0;
  info->channel_count = 2;
  info->port_type = CLAP_PORT_STEREO;
  info->in_place_pair = CLAP_INVALID_ID;
  return true;
}

const clap_plugin_audio_ports_t kit_audio_ports = {.count = audio_count, .get = get_audio};

void kit_ports_connect(const clap_process_t *block, KitPluginOutputs *outputs) {
  for (uint32_t side = 0; side < 2; side++) {
    outputs->mix[side] = extension_channel(block, 0, side);
    for (uint32_t i = 0; i < KIT_KNOB_DRUMS; i++) {
      outputs->drum[i][side] = extension_channel(block, 1 + i, side);
    }
  }
}

static uint32_t get_tail(const clap_plugin_t *plugin) {
  return (uint32_t)(LONGEST_RING * kit_instance_of(plugin)->rate);
}

const clap_plugin_tail_t kit_tail = {.get = get_tail};

static bool set_mode(const clap_plugin_t *plugin, clap_plugin_render_mode mode) {
  atomic_store(&kit_instance_of(plugin)->is_offline, mode == CLAP_RENDER_OFFLINE);
  return mode == CLAP_RENDER_OFFLINE || mode == CLAP_RENDER_REALTIME;
}

const clap_plugin_render_t kit_render = {.has_hard_realtime_requirement = extension_has_deadline,
                                         .set = set_mode};

/* ---- notes ---------------------------------------------------------------------------------- */

/* The kit of the knob; NULL if memory is short. */
static const TaborKitDef *named_kit(KitInstance *instance) {
  const float kit = atomic_load(&instance->values[KIT_KNOB_KIT]);
  const unsigned own = own_kit_version(&instance->own);
  const bool is_named = instance->named_kit == kit && instance->named_own == own;
  if (instance->named && is_named) return instance->named;
  if (!instance->named) instance->named = malloc(sizeof *instance->named);
  instance->named_kit = kit;
  instance->named_own = own;
  if (instance->named) (void)kit_knob_kit(kit, &instance->own, instance->named, NULL);
  return instance->named;
}

/* What each note plays, by the map of the knob; all by `names` of its notes. Returns their number. */
static uint32_t name_notes(KitInstance *instance, clap_note_name_t names[MIDI_VALUES]) {
  static const char *const strokes[] = {"",     "",      " rimshot", " cross-stick",
                                        " rim", " buzz", " sweep"};
  const uint32_t map = (uint32_t)atomic_load(&instance->values[KIT_KNOB_NOTES]);
  const TaborKitDef *const kit = named_kit(instance);
  KitMapNote table[MIDI_VALUES];
  uint32_t count = 0;
  kit_map_table(map > 0 ? &kit_maps[map - 1u] : NULL, table);
  for (uint32_t note = 0; kit && note < MIDI_VALUES; note++) {
    for (uint32_t i = 0; i < kit->drum_count; i++) {
      const MidiStroke stroke = kit_midi_stroke(&kit->drum[i], &table[note]);
      if (stroke == MIDI_STROKE_NONE) continue;
      names[count] = (clap_note_name_t){.port = -1, .key = (int16_t)note, .channel = -1};
      (void)snprintf(names[count].name, sizeof names[count].name, "%s%s", kit->drum[i].name,
                     strokes[stroke]);
      count++;
      break;
    }
  }
  return count;
}

static uint32_t name_count(const clap_plugin_t *plugin) {
  clap_note_name_t names[MIDI_VALUES];
  return name_notes(kit_instance_of(plugin), names);
}

static bool get_name(const clap_plugin_t *plugin, uint32_t index, clap_note_name_t *name) {
  clap_note_name_t names[MIDI_VALUES];
  if (index >= name_notes(kit_instance_of(plugin), names)) return false;
  *name = names[index];
  return true;
}

const clap_plugin_note_name_t kit_note_names = {.count = name_count, .get = get_name};
