/* SPDX-License-Identifier: MIT */
/**
 * @file window_of.h
 * The window that shows an instrument.
 */
#ifndef TABOR_WINDOW_WINDOW_OF_H
#define TABOR_WINDOW_WINDOW_OF_H

#include "window/plugin_window.h"

/** MAIN. Creates one without a window, of the kind *kind. NULL if memory is short. */
void *window_of(const PluginWindowShell *shell, const WindowKind **kind);

#endif
