/* SPDX-License-Identifier: MIT */
/**
 * @file plugin_window.h
 * The window of an instance (drum_window.h), whatever its plugin format: what it shows of the drum, strokes, controls,
 * presets, two drums to compare, and undo. All functions are for the main thread.
 */
#ifndef TABOR_WINDOW_PLUGIN_WINDOW_H
#define TABOR_WINDOW_PLUGIN_WINDOW_H

#include "plugin/window_link.h"

/** Drum and knobs. */
typedef struct PluginDrum {
  SavedState saved;
  float values[KNOB_COUNT];
} PluginDrum;

/** The shell of a plugin format. */
typedef struct PluginWindowShell {
  void *instance;
  WindowLink *link;
  KnobSet set;
  const KnobRange *ranges;                /**< [KNOB_COUNT] */
  ModelWorker *(*worker)(void *instance); /**< NULL: there is no drum now */
  float (*value)(void *instance, KnobId id);
  void (*begin)(void *instance, KnobId id); /**< a hand takes the knob */
  void (*turn)(void *instance, KnobId id, double value);
  void (*end)(void *instance, KnobId id);
  void (*save)(void *instance, SavedState *saved);     /**< the drum as it is */
  void (*use)(void *instance, const PluginDrum *drum); /**< another drum, with its knobs */
  void (*choose)(void *instance,
                 const char *preset); /**< a built-in drum, and knobs as it has them */
  void (*play)(void *instance);       /**< a stroke waits for a block */
} PluginWindowShell;

typedef struct PluginWindow PluginWindow;

/** Creates one without a window. NULL if memory is short. */
PluginWindow *plugin_window_create(const PluginWindowShell *shell);
/** Ignores NULL. What was undone and compared is forgotten. */
void plugin_window_destroy(PluginWindow *window);

/** Size of the next window at @p scale, limited, and of an open one. */
void plugin_window_scale(PluginWindow *window, double scale);
void plugin_window_resize(PluginWindow *window, uint32_t width, uint32_t height);
void plugin_window_size(const PluginWindow *window, uint32_t *width, uint32_t *height);

/** Opens a hidden window inside @p parent, an id of X11. False if there is one, no server, or too little memory. */
bool plugin_window_open(PluginWindow *window, unsigned long parent);
bool plugin_window_is_open(const PluginWindow *window);
void plugin_window_close(PluginWindow *window);
void plugin_window_show(PluginWindow *window, bool shown);
/** Takes what the mouse has done, and draws: every WINDOW_PERIOD. */
void plugin_window_update(PluginWindow *window);
/** The id of the open window. */
unsigned long plugin_window_id(const PluginWindow *window);

#endif
