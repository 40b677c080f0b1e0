/* SPDX-License-Identifier: MIT */
/**
 * @file gui_kind.h
 * The windows of the two kinds of plugins: of one drum (drum_gui.c) and of a kit (kit_gui.c).
 */
#ifndef TABOR_CLAP_GUI_KIND_H
#define TABOR_CLAP_GUI_KIND_H

#include "window/window_kind.h"

typedef struct GuiKind {
  const WindowKind *window;
  void *(*create)(void *instance); /**< NULL if memory is short */
} GuiKind;

extern const GuiKind gui_drum, gui_kit;

#endif
