/* SPDX-License-Identifier: MIT */
#include "clap/ports.h"

#include <stdio.h>
#include <string.h>

/* ---- sound ---------------------------------------------------------------------------------- */

#define INPUT_ID 100u /* of an effect's input; outputs count from 0 */

static uint32_t audio_count(const clap_plugin_t *plugin, bool is_input) {
  const InstrumentKind *const kind = instrument_of(plugin)->kind;
  return is_input ? kind->has_input : kind->output_count;
}

static bool get_audio(const clap_plugin_t *plugin, uint32_t index, bool is_input,
                      clap_audio_port_info_t *info) {
  const InstrumentOutput input = {.name = "Sound in", .channels = 2};
  if (index >= audio_count(plugin, is_input)) return false;
  const InstrumentOutput *const port =
    is_input ? &input : &instrument_of(plugin)->kind->outputs[index];
  memset(info, 0, sizeof *info);
  info->id = index + (is_input ? INPUT_ID : 0);
  (void)snprintf(info->name, sizeof info->name, "%s", port->name);
  info->flags = index == 0 ? CLAP_AUDIO_PORT_IS_MAIN : 0;
  info->channel_count = port->channels;
  info->port_type = port->channels == 2 ? CLAP_PORT_STEREO : CLAP_PORT_MONO;
  info->in_place_pair = CLAP_INVALID_ID;
  return true;
}

const clap_plugin_audio_ports_t ports_audio = {.count = audio_count, .get = get_audio};

/* A mono input plays on both sides. */
static void connect_input(const clap_process_t *block, PluginBuffers *buffers) REALTIME {
  if (block->audio_inputs_count == 0) return;
  const clap_audio_buffer_t *const buffer = &block->audio_inputs[0];
  if (!buffer->data32 || buffer->channel_count == 0) return;
  buffers->input[0] = buffer->data32[0];
  buffers->input[1] = buffer->data32[buffer->channel_count > 1 ? 1 : 0];
}

static float *channel_of(const clap_process_t *block, uint32_t port, uint32_t channel) REALTIME {
  if (port >= block->audio_outputs_count) return NULL;
  clap_audio_buffer_t *const buffer = &block->audio_outputs[port];
  buffer->constant_mask = 0;
  return buffer->data32 && channel < buffer->channel_count ? buffer->data32[channel] : NULL;
}

void ports_connect(Instrument *instrument, const clap_process_t *block) {
  const InstrumentKind *const kind = instrument->kind;
  PluginBuffers *const buffers = &instrument->buffers;
  memset(buffers, 0, sizeof *buffers);
  if (kind->has_input) connect_input(block, buffers);
  for (uint32_t i = 0; i < kind->output_count; i++) {
    const InstrumentOutput *const port = &kind->outputs[i];
    for (uint32_t side = 0; side < port->channels; side++)
      buffers->channels[port->first + side] = channel_of(block, i, side);
  }
}

static uint32_t get_latency(const clap_plugin_t *plugin) {
  (void)plugin;
  return 0;
}

const clap_plugin_latency_t ports_latency = {.get = get_latency};

static uint32_t get_tail(const clap_plugin_t *plugin) {
  const Instrument *const instrument = instrument_of(plugin);
  return (uint32_t)(instrument->kind->calls->tail(instrument) * instrument->rate);
}

const clap_plugin_tail_t ports_tail = {.get = get_tail};

static bool has_deadline(const clap_plugin_t *plugin) {
  (void)plugin;
  return false;
}

static bool set_mode(const clap_plugin_t *plugin, clap_plugin_render_mode mode) {
  atomic_store(&instrument_of(plugin)->is_offline, mode == CLAP_RENDER_OFFLINE);
  return mode == CLAP_RENDER_OFFLINE || mode == CLAP_RENDER_REALTIME;
}

const clap_plugin_render_t ports_render = {.has_hard_realtime_requirement = has_deadline,
                                           .set = set_mode};

/* ---- notes ---------------------------------------------------------------------------------- */

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

const clap_plugin_note_ports_t ports_notes = {.count = note_count, .get = get_notes};

/* The name at @p index of those that notes have; returns their number, up to that one. */
static uint32_t find_name(Instrument *instrument, uint32_t index, clap_note_name_t *name) {
  const InstrumentCalls *const calls = instrument->kind->calls;
  uint32_t count = 0;
  for (uint32_t note = 0; calls->name_note && note < MIDI_VALUES && count <= index; note++) {
    *name = (clap_note_name_t){.port = -1, .key = (int16_t)note, .channel = -1};
    if (calls->name_note(instrument, note, name->name, sizeof name->name)) count++;
  }
  return count;
}

static uint32_t name_count(const clap_plugin_t *plugin) {
  clap_note_name_t name;
  return find_name(instrument_of(plugin), MIDI_VALUES, &name);
}

static bool get_name(const clap_plugin_t *plugin, uint32_t index, clap_note_name_t *name) {
  return find_name(instrument_of(plugin), index, name) > index;
}

const clap_plugin_note_name_t ports_note_names = {.count = name_count, .get = get_name};
