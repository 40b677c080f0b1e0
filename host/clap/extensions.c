/* SPDX-License-Identifier: MIT */
#include "clap/extensions.h"

#include <stdio.h>
#include <string.h>

const void *extension_find(const Extension *all, size_t count, const char *id) {
  for (size_t i = 0; i < count; i++) {
    if (strcmp(id, all[i].id) == 0) return all[i].extension;
  }
  return NULL;
}

static uint32_t note_count(const clap_plugin_t *plugin, bool is_input) {
  (void)plugin;
  return is_input ? 1 : 0;
}

static bool get_notes(const clap_plugin_t *plugin, uint32_t index, bool is_input,
                      clap_note_port_info_t *info) {
  if (index >= note_count(plugin, is_input)) return false;
  memset(info, 0, sizeof *info);
  info->supported_dialects = CLAP_NOTE_DIALECT_CLAP | CLAP_NOTE_DIALECT_MIDI;
  info->preferred_dialect = CLAP_NOTE_DIALECT_CLAP;
  (void)snprintf(info->name, sizeof info->name, "Notes");
  return true;
}

const clap_plugin_note_ports_t extension_note_input = {.count = note_count, .get = get_notes};

bool extension_has_deadline(const clap_plugin_t *plugin) {
  (void)plugin;
  return false;
}

float *extension_channel(const clap_process_t *block, uint32_t port, uint32_t channel) {
  if (port >= block->audio_outputs_count) return NULL;
  clap_audio_buffer_t *const buffer = &block->audio_outputs[port];
  buffer->constant_mask = 0;
  return buffer->data32 && channel < buffer->channel_count ? buffer->data32[channel] : NULL;
}
