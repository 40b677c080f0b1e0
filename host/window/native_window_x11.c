/* SPDX-License-Identifier: MIT */
/* Each window has its own connection to the server, through XCB: an error of the server, as when
 * the outer window is gone already, comes as an event and does no harm. */
#include "window/native_window.h"

#include <cairo-xcb.h>
#include <stdlib.h>

#include "window/x11_keyboard.h"

enum { LEFT = 1, RIGHT = 3, UP = 4, DOWN = 5 }; /* buttons of X11 */
enum { SOON = 400, NEAR = 4 }; /* [ms], [pixels] of two presses that are one double click */

struct NativeWindow {
  NativeHandler handler;
  xcb_connection_t *connection;
  xcb_window_t id;
  cairo_surface_t *surface;
  X11Keyboard *keyboard; /* NULL: keys mean nothing */
  uint32_t width, height;
  bool shown, held;
  xcb_button_press_event_t pressed; /* the last one, unless it was the second of two */
};

static xcb_screen_t *first_screen(xcb_connection_t *connection, int number) {
  xcb_screen_iterator_t at = xcb_setup_roots_iterator(xcb_get_setup(connection));
  while (number-- > 0 && at.rem > 1) xcb_screen_next(&at);
  return at.rem > 0 ? at.data : NULL;
}

static xcb_visualtype_t *visual_of(xcb_screen_t *screen) {
  xcb_depth_iterator_t depth = xcb_screen_allowed_depths_iterator(screen);
  for (; depth.rem > 0; xcb_depth_next(&depth)) {
    xcb_visualtype_iterator_t visual = xcb_depth_visuals_iterator(depth.data);
    for (; visual.rem > 0; xcb_visualtype_next(&visual)) {
      if (visual.data->visual_id == screen->root_visual) return visual.data;
    }
  }
  return NULL;
}

/* With the root's depth and visual, whatever the outer window has; so it needs a border pixel of
 * its own. */
static bool open_window(NativeWindow *window, uintptr_t parent) {
  int number = 0;
  window->connection = xcb_connect(NULL, &number);
  if (xcb_connection_has_error(window->connection)) return false;
  xcb_screen_t *const screen = first_screen(window->connection, number);
  xcb_visualtype_t *const visual = screen ? visual_of(screen) : NULL;
  if (!visual) return false;
  const uint32_t colors = xcb_generate_id(window->connection);
  xcb_create_colormap(window->connection, XCB_COLORMAP_ALLOC_NONE, colors, screen->root,
                      visual->visual_id);
  const uint32_t values[] = {0,
                             XCB_EVENT_MASK_BUTTON_PRESS | XCB_EVENT_MASK_BUTTON_RELEASE |
                               XCB_EVENT_MASK_POINTER_MOTION | XCB_EVENT_MASK_LEAVE_WINDOW |
                               XCB_EVENT_MASK_KEY_PRESS,
                             colors};
  window->id = xcb_generate_id(window->connection);
  const xcb_void_cookie_t made = xcb_create_window_checked(
    window->connection, screen->root_depth, window->id, (xcb_window_t)parent, 0, 0,
    (uint16_t)window->width, (uint16_t)window->height, 0, XCB_WINDOW_CLASS_INPUT_OUTPUT,
    visual->visual_id, XCB_CW_BORDER_PIXEL | XCB_CW_EVENT_MASK | XCB_CW_COLORMAP, values);
  xcb_generic_error_t *const error = xcb_request_check(window->connection, made);
  const bool is_made = error == NULL; /* not without such an outer window */
  free(error);
  if (!is_made) return false;
  window->keyboard = x11_keyboard_create(window->connection);
  window->surface = cairo_xcb_surface_create(window->connection, window->id, visual,
                                             (int)window->width, (int)window->height);
  xcb_flush(window->connection);
  return cairo_surface_status(window->surface) == CAIRO_STATUS_SUCCESS;
}

NativeWindow *native_window_create(uintptr_t parent, uint32_t width, uint32_t height,
                                   const NativeHandler *handler) {
  NativeWindow *const window = calloc(1, sizeof *window);
  if (!window) return NULL;
  window->handler = *handler;
  window->width = width;
  window->height = height;
  if (open_window(window, parent)) return window;
  native_window_destroy(window);
  return NULL;
}

void native_window_destroy(NativeWindow *window) {
  if (!window) return;
  if (window->surface) {
    cairo_device_t *const device =
      cairo_device_reference(cairo_surface_get_device(window->surface));
    cairo_surface_finish(window->surface);
    cairo_surface_destroy(window->surface);
    cairo_device_finish(
      device); /* or cairo takes the next connection at this address for this one */
    cairo_device_destroy(device);
    xcb_destroy_window(window->connection, window->id);
  }
  x11_keyboard_destroy(window->keyboard);
  xcb_disconnect(window->connection);
  free(window);
}

uintptr_t native_window_id(const NativeWindow *window) { return window->id; }

void native_window_show(NativeWindow *window, bool shown) {
  window->shown = shown;
  if (shown) {
    xcb_map_window(window->connection, window->id);
  } else {
    xcb_unmap_window(window->connection, window->id);
  }
  xcb_flush(window->connection);
}

void native_window_resize(NativeWindow *window, uint32_t width, uint32_t height) {
  const uint32_t size[] = {width, height};
  window->width = width;
  window->height = height;
  xcb_configure_window(window->connection, window->id,
                       XCB_CONFIG_WINDOW_WIDTH | XCB_CONFIG_WINDOW_HEIGHT, size);
  cairo_xcb_surface_set_size(window->surface, (int)width, (int)height);
  xcb_flush(window->connection);
}

/* Whether it is the second of two; it is then no first one of the next two. */
static bool is_second(NativeWindow *window, const xcb_button_press_event_t *event) {
  const xcb_button_press_event_t *const before = &window->pressed;
  const bool is_near =
    abs(event->event_x - before->event_x) <= NEAR && abs(event->event_y - before->event_y) <= NEAR;
  const bool is_again = before->response_type != 0 && is_near && event->time - before->time <= SOON;
  window->pressed = is_again ? (xcb_button_press_event_t){0} : *event;
  return is_again;
}

static NativeTouch touch_of(uint16_t state) {
  return (NativeTouch){.is_fine = (state & XCB_MOD_MASK_SHIFT) != 0};
}

/* A click asks for the keys, which a host's own window has at first. */
static void take_press(NativeWindow *window, const xcb_button_press_event_t *event) {
  const NativeHandler *const handler = &window->handler;
  const double x = event->event_x, y = event->event_y;
  NativeTouch touch = touch_of(event->state);
  if (event->detail == UP || event->detail == DOWN) {
    handler->scroll(handler->context, x, y, event->detail == UP ? 1 : -1, touch);
  } else if (event->detail == RIGHT) {
    handler->menu(handler->context, x, y);
  } else if (event->detail == LEFT) {
    (void)xcb_set_input_focus(window->connection, XCB_INPUT_FOCUS_PARENT, window->id, event->time);
    window->held = true;
    touch.is_again = is_second(window, event);
    handler->press(handler->context, x, y, touch);
  }
}

static void take_motion(const NativeWindow *window, const xcb_motion_notify_event_t *event) {
  const NativeHandler *const handler = &window->handler;
  if (window->held) {
    handler->drag(handler->context, event->event_x, event->event_y, touch_of(event->state));
  } else {
    handler->hover(handler->context, event->event_x, event->event_y);
  }
}

static void take_event(NativeWindow *window, const xcb_generic_event_t *event) {
  const NativeHandler *const handler = &window->handler;
  switch (event->response_type & 0x7f) {
  case XCB_BUTTON_PRESS: take_press(window, (const xcb_button_press_event_t *)event); break;
  case XCB_BUTTON_RELEASE:
    if (((const xcb_button_release_event_t *)event)->detail == LEFT && window->held) {
      window->held = false;
      handler->release(handler->context);
    }
    break;
  case XCB_MOTION_NOTIFY: take_motion(window, (const xcb_motion_notify_event_t *)event); break;
  case XCB_LEAVE_NOTIFY:
    if (!window->held) handler->hover(handler->context, -1, -1);
    break;
  case XCB_KEY_PRESS: {
    const xcb_key_press_event_t *const pressed = (const xcb_key_press_event_t *)event;
    const Key key = x11_keyboard_key(window->keyboard, pressed);
    if (key != KEY_UNKNOWN)
      handler->key(handler->context, key, (pressed->state & XCB_MOD_MASK_SHIFT) != 0);
    break;
  }
  default: break;
  }
}

void native_window_take_events(NativeWindow *window) {
  xcb_generic_event_t *event;
  while ((event = xcb_poll_for_event(window->connection)) != NULL) {
    take_event(window, event);
    free(event);
  }
}

/* In one piece, so that nothing flickers. */
void native_window_draw(NativeWindow *window) {
  if (!window->shown || xcb_connection_has_error(window->connection)) return;
  cairo_t *const cairo = cairo_create(window->surface);
  cairo_push_group(cairo);
  window->handler.draw(window->handler.context, cairo, window->width, window->height);
  cairo_pop_group_to_source(cairo);
  cairo_paint(cairo);
  cairo_destroy(cairo);
  cairo_surface_flush(window->surface);
  xcb_flush(window->connection);
}

bool native_window_has_ticks(void) { return false; }

bool native_window_start_ticks(NativeWindow *window, uint32_t period) {
  (void)window;
  (void)period;
  return false;
}
