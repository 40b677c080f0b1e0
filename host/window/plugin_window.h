/* SPDX-License-Identifier: MIT */
/**
 * @file plugin_window.h
 * The window of an instance (drum_window.h), whatever its plugin format: what it shows of the drum, strokes, controls,
 * presets, two drums to compare, and undo. All functions are for the main thread.
 */
#ifndef TABOR_WINDOW_PLUGIN_WINDOW_H
#define TABOR_WINDOW_PLUGIN_WINDOW_H

#include "plugin/window_link.h"
#include "window/window_kind.h"

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

/** What is done with a PluginWindow. */
extern const WindowKind plugin_window_kind;

#endif
