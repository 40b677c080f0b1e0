/* SPDX-License-Identifier: MIT */
/**
 * @file kit_plugin_window.h
 * The window of an instance of Tabor Kit (kit_window.h), whatever its plugin format: kits, strokes, controls, two settings
 * to compare, and undo. All functions are for the main thread.
 */
#ifndef TABOR_WINDOW_KIT_PLUGIN_WINDOW_H
#define TABOR_WINDOW_KIT_PLUGIN_WINDOW_H

#include "plugin/kit_window_link.h"
#include "window/window_kind.h"

/** The shell of a plugin format. */
typedef struct KitPluginWindowShell {
  void *instance;
  KitWindowLink *link;
  OwnKit *own;
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

/** What is done with a KitPluginWindow. */
extern const WindowKind kit_plugin_window_kind;

#endif
