/* SPDX-License-Identifier: MIT */
/**
 * @file instance.h
 * An instance of a CLAP plugin: an instrument (plugin/instrument.h) in a host. instance.c creates,
 * runs and destroys it; the other files of this folder have its extensions.
 */
#ifndef TABOR_CLAP_INSTANCE_H
#define TABOR_CLAP_INSTANCE_H

#include <clap/clap.h>

#include "clap/event_list.h"
#include "clap/gui_link.h"
#include "plugin/instrument.h"
#include "plugin/worker_thread.h"

#define ID_DRUM "tabor.drum"             /**< the plugin with a stereo output */
#define ID_DRUM_MULTI "tabor.drum-multi" /**< the plugin with an output per microphone */
#define ID_KIT "tabor.kit"               /**< the plugin that plays drum kits */
#define ID_EFFECT "tabor.effect"         /**< the drum before a loudspeaker */

typedef struct Instance {
  clap_plugin_t plugin;
  const clap_host_t *host;
  const clap_host_log_t *log; /**< or NULL, as the next three */
  const clap_host_params_t *params;
  const clap_host_note_name_t *note_names;
  const clap_host_thread_pool_t *threads;
  KitPool pool; /**< them */
  Instrument *instrument;
  WorkerThread thread;   /**< while the instrument is open */
  GuiLink link;          /**< main thread: its window */
  atomic_bool is_called; /**< on_main_thread() has been asked for, and has not come yet */

  /* audio thread: the block */
  EventList list;
  uint32_t event; /**< the next one */
} Instance;

static inline Instance *instance_of(const clap_plugin_t *plugin) { return plugin->plugin_data; }
static inline Instrument *instrument_of(const clap_plugin_t *plugin) {
  return instance_of(plugin)->instrument;
}

/** MAIN. Creates an instance of the plugin that @p descriptor describes; NULL if memory is short.
 */
const clap_plugin_t *instance_create(const clap_plugin_descriptor_t *descriptor,
                                     const clap_host_t *host, const InstrumentKind *kind);

#endif
