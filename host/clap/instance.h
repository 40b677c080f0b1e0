/* SPDX-License-Identifier: MIT */
/**
 * @file instance.h
 * An instance of a CLAP plugin. instance.c creates, runs and destroys it; the other files of this folder have its
 * extensions.
 *
 * Drum, models and thread are there from the first activation on, until it is activated at another sample rate or
 * destroyed. Its knobs and, on the main thread, the drum that was saved last are there from beginning to end. At a sample
 * rate that the engine has no models for it is silent, and the host's log has the reason.
 */
#ifndef TABOR_CLAP_INSTANCE_H
#define TABOR_CLAP_INSTANCE_H

#include <clap/clap.h>

#include "clap/event_list.h"
#include "clap/gui_link.h"
#include "plugin/plugin_run.h"
#include "plugin/window_link.h"
#include "plugin/worker_thread.h"

#define ID_DRUM "tabor.drum"             /**< the plugin with a stereo output */
#define ID_DRUM_MULTI "tabor.drum-multi" /**< the plugin with an output per microphone */
#define ID_EFFECT "tabor.effect"         /**< the drum before a loudspeaker */

typedef struct Instance {
  clap_plugin_t plugin;
  const clap_host_t *host;
  const clap_host_log_t *log;       /**< or NULL */
  const clap_host_params_t *params; /**< or NULL */
  KnobSet set;
  bool stereo; /**< a pair, not an output per microphone */
  KnobRange ranges[KNOB_COUNT];
  _Atomic float values[KNOB_COUNT];      /**< of the knobs, in their own units */
  _Atomic float modulations[KNOB_COUNT]; /**< in the units of parameters */
  _Atomic float room_decay;              /**< of the drum's definition [s], 0: by kind */
  atomic_bool is_offline;                /**< the host renders, and is in no hurry */
  atomic_bool has_moved;                 /**< a knob has, of which the host does not know */

  /* main thread */
  SavedState saved; /**< the drum, while the instance is not open */
  bool is_saved;    /**< it is not the default one */
  bool is_open;     /**< changes only while no block is played */
  double rate;
  GuiLink link; /**< its window */
  WindowLink window;

  /* while it is open */
  ModelWorker worker;
  WorkerThread thread;
  PluginPlayer player;

  /* audio thread: the block */
  EventList list;
  uint32_t event; /**< the next one */
  /** Number of the last event that chokes a key at this frame, 0 if none: notes before it do not begin. */
  uint32_t choked[MIDI_VALUES];
} Instance;

static inline Instance *instance_of(const clap_plugin_t *plugin) { return plugin->plugin_data; }

/** MAIN. Creates an instance of the plugin that @p descriptor describes; NULL if memory is short. */
const clap_plugin_t *instance_create(const clap_plugin_descriptor_t *descriptor,
                                     const clap_host_t *host, KnobSet set);

#endif
