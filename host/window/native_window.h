/* SPDX-License-Identifier: MIT */
/**
 * @file native_window.h
 * A window inside another program's window, drawn by cairo: native_window_x11.c has those of X11,
 * native_window_windows.c those of Windows.
 *
 * All functions are for one thread.
 */
#ifndef TABOR_WINDOW_NATIVE_WINDOW_H
#define TABOR_WINDOW_NATIVE_WINDOW_H

#include <cairo.h>
#include <stdbool.h>
#include <stdint.h>

#include "base/keys.h"

/** How a place is touched. */
typedef struct NativeTouch {
  bool is_fine;  /**< Shift is held: by small steps */
  bool is_again; /**< the second of two quick presses at one place */
} NativeTouch;

/** What happens in a window. Places are in pixels of the window, from its upper left corner. */
typedef struct NativeHandler {
  void *context;
  void (*draw)(void *context, cairo_t *cairo, uint32_t width, uint32_t height);
  void (*press)(void *context, double x, double y, NativeTouch touch);
  void (*drag)(void *context, double x, double y,
               NativeTouch touch); /**< while the button is held */
  void (*release)(void *context);
  void (*menu)(void *context, double x, double y);  /**< the right button */
  void (*hover)(void *context, double x, double y); /**< no button is held; negative: it has left */
  void (*scroll)(void *context, double x, double y, int steps,
                 NativeTouch touch); /**< up: 1, down: -1 */
  void (*key)(void *context, Key key, bool has_shift);
  void (*tick)(void *context); /**< see native_window_start_ticks() */
} NativeHandler;

typedef struct NativeWindow NativeWindow;

/** Creates a hidden window inside @p parent, an id of X11 or a HWND. NULL if there is no such
 * window, no server, or memory is short. */
NativeWindow *native_window_create(uintptr_t parent, uint32_t width, uint32_t height,
                                   const NativeHandler *handler);
/** Ignores NULL. */
void native_window_destroy(NativeWindow *window);
/** An id of X11 or a HWND. */
uintptr_t native_window_id(const NativeWindow *window);
void native_window_show(NativeWindow *window, bool shown);
void native_window_resize(NativeWindow *window, uint32_t width, uint32_t height);
/** Tells the handler what has happened since the last call. */
void native_window_take_events(NativeWindow *window);
/** Draws the window if it is shown. */
void native_window_draw(NativeWindow *window);

/** True if windows of this system can call a handler's tick() by themselves. Those of X11 cannot:
 * their host has a loop of its own. */
bool native_window_has_ticks(void);
/** From now on the host's loop calls the handler's tick() every @p period [ms]. False if it will
 * not. */
bool native_window_start_ticks(NativeWindow *window, uint32_t period);

#endif
