/* SPDX-License-Identifier: MIT */
/**
 * @file kit_plugin_window.h
 * The window of an instance of Tabor Kit (kit_window.h), whatever its plugin format: kits, strokes, controls, two settings
 * to compare, and undo. All functions are for the main thread.
 */
#ifndef TABOR_WINDOW_KIT_PLUGIN_WINDOW_H
#define TABOR_WINDOW_KIT_PLUGIN_WINDOW_H

#include "window/plugin_window.h"

typedef struct KitPluginWindow KitPluginWindow;

/** Creates one without a window. NULL if memory is short. */
KitPluginWindow *kit_plugin_window_create(const PluginWindowShell *shell);

/** What is done with a KitPluginWindow. */
extern const WindowKind kit_plugin_window_kind;

#endif
