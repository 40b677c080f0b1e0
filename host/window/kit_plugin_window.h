/* SPDX-License-Identifier: MIT */
/**
 * @file kit_plugin_window.h
 * The window of an instance of Tabor Kit (kit_window.h), whatever its plugin format: kits, strokes, controls, two settings
 * to compare, and undo. All functions are for the main thread.
 */
#ifndef TABOR_WINDOW_KIT_PLUGIN_WINDOW_H
#define TABOR_WINDOW_KIT_PLUGIN_WINDOW_H

#include "plugin/kit_window_link.h"

/** The shell of a plugin format. */
typedef struct KitPluginWindowShell {
  void *instance;
  KitWindowLink *link;
  float (*value)(void *instance, KitKnobId id);
  void (*begin)(void *instance, KitKnobId id); /**< a hand takes the knob */
  void (*turn)(void *instance, KitKnobId id, double value);
  void (*end)(void *instance, KitKnobId id);
  void (*use)(void *instance, const float values[KIT_KNOB_COUNT]); /**< all knobs at once */
  void (*play)(void *instance); /**< a stroke waits for a block */
} KitPluginWindowShell;

typedef struct KitPluginWindow KitPluginWindow;

/** Creates one without a window. NULL if memory is short. */
KitPluginWindow *kit_plugin_window_create(const KitPluginWindowShell *shell);
/** Ignores NULL. What was undone and compared is forgotten. */
void kit_plugin_window_destroy(KitPluginWindow *window);

/** Size of the next window at @p scale, limited, and of an open one. */
void kit_plugin_window_scale(KitPluginWindow *window, double scale);
void kit_plugin_window_resize(KitPluginWindow *window, uint32_t width, uint32_t height);
void kit_plugin_window_size(const KitPluginWindow *window, uint32_t *width, uint32_t *height);

/** Opens a hidden window inside @p parent, an id of X11. False if there is one, no server, or too little memory. */
bool kit_plugin_window_open(KitPluginWindow *window, unsigned long parent);
bool kit_plugin_window_is_open(const KitPluginWindow *window);
void kit_plugin_window_close(KitPluginWindow *window);
void kit_plugin_window_show(KitPluginWindow *window, bool shown);
/** Takes what the mouse has done, and draws: every WINDOW_PERIOD. */
void kit_plugin_window_update(KitPluginWindow *window);

#endif
