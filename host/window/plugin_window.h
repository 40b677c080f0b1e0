/* SPDX-License-Identifier: MIT */
/**
 * @file plugin_window.h
 * The window of an instrument, whatever its plugin format: what it shows of the drum or the kit,
 * strokes, controls, presets, two settings to compare, and undo. All functions are for the main
 * thread.
 */
#ifndef TABOR_WINDOW_PLUGIN_WINDOW_H
#define TABOR_WINDOW_PLUGIN_WINDOW_H

#include "plugin/instrument.h"
#include "window/window_size.h"

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
  /** Opens the host's menu of a knob at a place of the window; NULL: this format has none. */
  void (*menu)(void *shell, uint32_t id, int x, int y);
} PluginWindowShell;

typedef struct PluginWindow PluginWindow;

/** Creates one without a window. NULL if memory is short. */
PluginWindow *plugin_window_create(const PluginWindowShell *shell);
/** Ignores NULL. What was undone and compared is forgotten. */
void plugin_window_destroy(PluginWindow *window);

/* Size [px] of the next window, and of an open one. */
void plugin_window_resize(PluginWindow *window, uint32_t width, uint32_t height);
void plugin_window_size(const PluginWindow *window, uint32_t *width, uint32_t *height);
/** Gives it the size at @p scale, limited. */
void plugin_window_scale(PluginWindow *window, double scale);

/** Opens a hidden window inside @p parent (native_window_create()). False if there is one, no such
 * @p parent, no server, or too little memory. */
bool plugin_window_open(PluginWindow *window, uintptr_t parent);
bool plugin_window_is_open(const PluginWindow *window);
void plugin_window_close(PluginWindow *window);

/* Of an open window. */
uintptr_t plugin_window_id(const PluginWindow *window);
void plugin_window_show(PluginWindow *window, bool shown);
/** Takes what the mouse has done, and draws: every WINDOW_PERIOD. */
void plugin_window_update(PluginWindow *window);
/** Updates it from now on, for hosts that have no timers. False if this system's windows have none
 * either. */
bool plugin_window_update_itself(PluginWindow *window);
/** True if this system's windows have timers. */
bool plugin_window_has_timers(void);

#endif
