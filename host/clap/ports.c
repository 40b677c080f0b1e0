/* SPDX-License-Identifier: MIT */
#include "clap/ports.h"

#include <stdio.h>
#include <string.h>

#include "clap/extensions.h"

/* ---- sound ---------------------------------------------------------------------------------- */

#define LONGEST_RING 12.0 /* [s] within which a drum has died away */
#define FALL 1.5          /* times the 60 dB decay of a room until it has fallen by 90 dB */

/* The outputs behind the pair. */
static const struct {
  const char *name;
  PluginMic mic;
} singles[] = {{"Top", PLUGIN_TOP},
               {"Bottom", PLUGIN_BOTTOM},
               {"Near", PLUGIN_NEAR},
               {"Far", PLUGIN_FAR},
               {"Inside", PLUGIN_INSIDE}};

#define INPUT_ID 100u /* of the effect's input; outputs count from 0 */
#define SINGLES (sizeof singles / sizeof singles[0])

static uint32_t audio_count(const clap_plugin_t *plugin, bool is_input) {
  if (is_input) return instance_of(plugin)->set == KNOBS_EFFECT;
  return instance_of(plugin)->stereo ? 1 : 1 + SINGLES;
}

static bool get_audio(const clap_plugin_t *plugin, uint32_t index, bool is_input,
                      clap_audio_port_info_t *info) {
  if (index >= audio_count(plugin, is_input)) return false;
  memset(info, 0, sizeof *info);
  const char *const name = is_input ? "Sound in" : index == 0 ? "Stereo" : singles[index - 1].name;
  info->id = index + (is_input ? INPUT_ID : 0);
  (void)snprintf(info->name, sizeof info->name, "%s", name);
  info->flags = index == 0 ? CLAP_AUDIO_PORT_IS_MAIN : 0;
  info->channel_count = index == 0 ? 2 : 1;
  info->port_type = index == 0 ? CLAP_PORT_STEREO : CLAP_PORT_MONO;
  info->in_place_pair = CLAP_INVALID_ID;
  return true;
}

const clap_plugin_audio_ports_t instance_audio_ports = {.count = audio_count, .get = get_audio};

/* A mono input plays on both sides. */
static void connect_input(const clap_process_t *process, PluginOutputs *outputs) REALTIME;
static void connect_input(const clap_process_t *process, PluginOutputs *outputs) {
  if (process->audio_inputs_count == 0) return;
  const clap_audio_buffer_t *const buffer = &process->audio_inputs[0];
  if (!buffer->data32 || buffer->channel_count == 0) return;
  outputs->input[0] = buffer->data32[0];
  outputs->input[1] = buffer->data32[buffer->channel_count > 1 ? 1 : 0];
}

void ports_connect(const Instance *instance, const clap_process_t *process,
                   PluginOutputs *outputs) {
  const uint32_t left = instance->stereo ? 0 : PLUGIN_LEFT;
  memset(outputs, 0, sizeof *outputs);
  if (instance->set == KNOBS_EFFECT) connect_input(process, outputs);
  outputs->channels[left] = extension_channel(process, 0, 0);
  outputs->channels[left + 1] = extension_channel(process, 0, 1);
  for (uint32_t i = 0; !instance->stereo && i < SINGLES; i++) {
    outputs->channels[singles[i].mic] = extension_channel(process, i + 1, 0);
  }
}

static uint32_t get_latency(const clap_plugin_t *plugin) {
  (void)plugin;
  return 0;
}

const clap_plugin_latency_t instance_latency = {.get = get_latency};

static uint32_t get_tail(const clap_plugin_t *plugin) {
  static const double decays[] = {0, 0.3, 0.6, 1.5}; /* of a TaborRoomKind [s] */
  const Instance *const instance = instance_of(plugin);
  const uint32_t kind = (uint32_t)atomic_load(&instance->values[KNOB_ROOM]);
  const double own = (double)atomic_load(&instance->room_decay);
  const double decay = kind > 0 && own > 0 ? own : decays[kind];
  return (uint32_t)((LONGEST_RING + FALL * decay) * instance->rate);
}

const clap_plugin_tail_t instance_tail = {.get = get_tail};

static bool set_mode(const clap_plugin_t *plugin, clap_plugin_render_mode mode) {
  atomic_store(&instance_of(plugin)->is_offline, mode == CLAP_RENDER_OFFLINE);
  return mode == CLAP_RENDER_OFFLINE || mode == CLAP_RENDER_REALTIME;
}

const clap_plugin_render_t instance_render = {
  .has_hard_realtime_requirement = extension_has_deadline, .set = set_mode};
