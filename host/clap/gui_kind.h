/* SPDX-License-Identifier: MIT */
/**
 * @file gui_kind.h
 * What the window of a kind of plugin does: that of one drum (drum_gui.c) and that of a kit (kit_gui.c). All is for the
 * main thread; see window/plugin_window.h.
 */
#ifndef TABOR_CLAP_GUI_KIND_H
#define TABOR_CLAP_GUI_KIND_H

#include <stdbool.h>
#include <stdint.h>

typedef struct GuiKind {
  void *(*create)(void *instance);
  void (*destroy)(void *window);
  void (*scale)(void *window, double scale);
  void (*resize)(void *window, uint32_t width, uint32_t height);
  void (*size)(const void *window, uint32_t *width, uint32_t *height);
  bool (*open)(void *window, unsigned long parent);
  bool (*is_open)(const void *window);
  void (*close)(void *window);
  void (*show)(void *window, bool shown);
  void (*update)(void *window);
} GuiKind;

extern const GuiKind gui_drum, gui_kit;

#endif
