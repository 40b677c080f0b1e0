/* SPDX-License-Identifier: MIT */
/**
 * @file kit_instance.h
 * An instance of the CLAP plugin Tabor Kit. kit_instance.c creates, runs and destroys it; kit_parameters.c,
 * kit_ports.c and kit_state.c have its extensions.
 */
#ifndef TABOR_CLAP_KIT_INSTANCE_H
#define TABOR_CLAP_KIT_INSTANCE_H

#include <stdio.h>

#include "clap/event_list.h"
#include "clap/gui_link.h"
#include "plugin/kit_window_link.h"
#include "plugin/worker_thread.h"

#define ID_KIT "tabor.kit"

typedef struct KitInstance {
  clap_plugin_t plugin;
  const clap_host_t *host;
  const clap_host_log_t *log; /**< or NULL, as the next two */
  const clap_host_params_t *params;
  const clap_host_note_name_t *note_names;
  _Atomic float values[KIT_KNOB_COUNT];
  atomic_bool is_offline; /**< the host renders, and is in no hurry */

  /* main thread */
  bool is_open; /**< changes only while no block is played */
  double rate;
  TaborKitDef *named; /**< the kit whose notes have names, or NULL */
  float named_kit;    /**< value of its knob */
  unsigned named_own; /**< version of the own kit, if that is it */
  OwnKit own;
  GuiLink link; /**< its window */
  KitWindowLink window;

  /* while it is open */
  KitWorker worker;
  WorkerThread thread;
  KitPluginPlayer player;
} KitInstance;

static inline KitInstance *kit_instance_of(const clap_plugin_t *plugin) {
  return plugin->plugin_data;
}

/** Writes an error line to the host's log. Any thread but the audio thread. */
static inline void kit_instance_say(KitInstance *instance, const char *line) {
  char text[2 * TABOR_TEXT_SIZE + 16];
  (void)snprintf(text, sizeof text, "Tabor Kit: %s", line);
  if (instance->log) instance->log->log(instance->host, CLAP_LOG_ERROR, text);
}

/** MAIN. Creates an instance of the plugin that @p descriptor describes; NULL if memory is short. */
const clap_plugin_t *kit_instance_create(const clap_plugin_descriptor_t *descriptor,
                                         const clap_host_t *host);
extern const clap_plugin_params_t kit_params;
extern const clap_plugin_audio_ports_t kit_audio_ports;
extern const clap_plugin_note_name_t kit_note_names;
extern const clap_plugin_render_t kit_render;
extern const clap_plugin_tail_t kit_tail;
extern const clap_plugin_state_t kit_state;

/** Notes the value that @p event brings. False: it brings none. */
bool kit_parameters_take(KitInstance *instance, const clap_event_header_t *event) REALTIME;
/** MAIN. Tells the host that knobs and kit are others, by a preset or a state. */
void kit_parameters_tell(KitInstance *instance);
/** AUDIO. Turns the player's knobs to the values that were noted. */
void kit_parameters_turn(KitInstance *instance) REALTIME;
/** AUDIO. Finds where the channels of @p block go. */
void kit_ports_connect(const clap_process_t *block, KitPluginOutputs *outputs) REALTIME;

#endif
