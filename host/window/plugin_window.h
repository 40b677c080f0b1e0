/* SPDX-License-Identifier: MIT */
/**
 * @file plugin_window.h
 * The window of an instance (drum_window.h), whatever its plugin format: what it shows of the drum, strokes, controls,
 * presets, two drums to compare, and undo. All functions are for the main thread.
 */
#ifndef TABOR_WINDOW_PLUGIN_WINDOW_H
#define TABOR_WINDOW_PLUGIN_WINDOW_H

#include "plugin/instrument.h"
#include "window/window_kind.h"

/** The shell of a plugin format. */
typedef struct PluginWindowShell {
  void *shell;
  Instrument *instrument;
  float (*value)(void *shell, uint32_t id);
  void (*begin)(void *shell, uint32_t id); /**< a hand takes the knob */
  void (*turn)(void *shell, uint32_t id, double value);
  void (*end)(void *shell, uint32_t id);
  void (*use)(void *shell, const InstrumentSetting *setting); /**< another drum, with its knobs */
  /** A built-in drum or kit, or one of a file, and knobs as it has them. */
  void (*choose)(void *shell, const char *name, bool is_file);
  void (*play)(void *shell); /**< a stroke waits for a block */
} PluginWindowShell;

typedef struct PluginWindow PluginWindow;

/** Creates one without a window. NULL if memory is short. */
PluginWindow *plugin_window_create(const PluginWindowShell *shell);

/** What is done with a PluginWindow. */
extern const WindowKind plugin_window_kind;

#endif
