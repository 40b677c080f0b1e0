/* SPDX-License-Identifier: MIT */
/**
 * @file window_kind.h
 * What shells of plugin formats do with a window, whichever it is: that of one drum (plugin_window.h) and that of a kit
 * (kit_plugin_window.h). `window` is what the create function of the kind has returned. All is for the main thread.
 */
#ifndef TABOR_WINDOW_WINDOW_KIND_H
#define TABOR_WINDOW_WINDOW_KIND_H

#include <stdbool.h>

#include "window/window_size.h"

typedef struct WindowKind {
  /** Ignores NULL. What was undone and compared is forgotten. */
  void (*destroy)(void *window);

  /* Size [px] of the next window, and of an open one. */
  void (*resize)(void *window, uint32_t width, uint32_t height);
  void (*size)(const void *window, uint32_t *width, uint32_t *height);

  /** Opens a hidden window inside @p parent, an id of X11. False if there is one, no server, or too little memory. */
  bool (*open)(void *window, unsigned long parent);
  bool (*is_open)(const void *window);
  void (*close)(void *window);

  /* Of an open window. */
  unsigned long (*id)(const void *window);
  void (*show)(void *window, bool shown);
  /** Takes what the mouse has done, and draws: every WINDOW_PERIOD. */
  void (*update)(void *window);
} WindowKind;

/** Gives a window the size at @p scale, limited. */
static inline void window_scale(const WindowKind *kind, void *window, double scale) {
  uint32_t width, height;
  window_size(scale, &width, &height);
  kind->resize(window, width, height);
}

#endif
