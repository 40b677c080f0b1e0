/* SPDX-License-Identifier: MIT */
/**
 * @file x11_window.h
 * A window inside another program's window, on X11, drawn by cairo. It has its own connection to
 * the server, through XCB: an error of the server, as when the outer window is gone already, comes
 * as an event and does no harm.
 *
 * All functions are for one thread.
 */
#ifndef TABOR_WINDOW_X11_WINDOW_H
#define TABOR_WINDOW_X11_WINDOW_H

#include <cairo.h>
#include <stdbool.h>
#include <stdint.h>

#include "base/keys.h"

/** How a place is touched. */
typedef struct X11Touch {
  bool is_fine;  /**< Shift is held: by small steps */
  bool is_again; /**< the second of two quick presses at one place */
} X11Touch;

/** What happens in a window. Places are in pixels of the window, from its upper left corner. */
typedef struct X11Handler {
  void *context;
  void (*draw)(void *context, cairo_t *cairo, uint32_t width, uint32_t height);
  void (*press)(void *context, double x, double y, X11Touch touch);
  void (*drag)(void *context, double x, double y, X11Touch touch); /**< while the button is held */
  void (*release)(void *context);
  void (*menu)(void *context, double x, double y);  /**< the right button */
  void (*hover)(void *context, double x, double y); /**< no button is held; negative: it has left */
  void (*scroll)(void *context, double x, double y, int steps,
                 X11Touch touch); /**< up: 1, down: -1 */
  void (*key)(void *context, Key key, bool has_shift);
} X11Handler;

typedef struct X11Window X11Window;

/** Creates a hidden window inside @p parent, an id of X11. NULL if there is no server, or memory is
 * short. */
X11Window *x11_window_create(unsigned long parent, uint32_t width, uint32_t height,
                             const X11Handler *handler);
/** Ignores NULL. */
void x11_window_destroy(X11Window *window);
unsigned long x11_window_id(const X11Window *window);
void x11_window_show(X11Window *window, bool shown);
void x11_window_resize(X11Window *window, uint32_t width, uint32_t height);
/** Tells the handler what has happened since the last call. */
void x11_window_take_events(X11Window *window);
/** Draws the window if it is shown. */
void x11_window_draw(X11Window *window);

#endif
