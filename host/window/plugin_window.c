/* SPDX-License-Identifier: MIT */
#include "window/plugin_window.h"

#include <stdlib.h>

#include "window/picture.h"
#include "window/plugin_window_state.h"

static const double FIRST_SPEED = 4.5; /* [m/s] */

/* ---- beginning and end ---------------------------------------------------------------------- */

PluginWindow *plugin_window_create(const PluginWindowShell *shell) {
  PluginWindow *const window = calloc(1, sizeof *window);
  if (!window) return NULL;
  window->shell = *shell;
  window->history = (History){.size = sizeof(WindowSetting),
                              .context = window,
                              .note = plugin_window_note,
                              .use = plugin_window_use,
                              .drop = plugin_window_forget};
  window->pages.kind = shell->instrument->kind;
  window->scene.is_kit = shell->instrument->kind->id == INSTRUMENT_KIT;
  window->scene.speed = FIRST_SPEED;
  window->scene.mic = WINDOW_NO_MIC;
  window->scene.focus = window->scene.typed_at = WINDOW_NO_CONTROL;
  window->definition = calloc(1, sizeof *window->definition);
  if (!window->definition || !history_begin(&window->history)) {
    plugin_window_destroy(window);
    return NULL;
  }
  window_size(1, &window->width, &window->height);
  plugin_window_note_looks(window);
  return window;
}

void plugin_window_destroy(PluginWindow *window) {
  if (!window) return;
  plugin_window_close(window);
  history_end(&window->history);
  control_pages_end(&window->pages);
  free(window->definition);
  free(window);
}

/* ---- sizes ---------------------------------------------------------------------------------- */

void plugin_window_resize(PluginWindow *window, uint32_t width, uint32_t height) {
  window->width = width;
  window->height = height;
  if (window->outside) native_window_resize(window->outside, width, height);
}

void plugin_window_size(const PluginWindow *window, uint32_t *width, uint32_t *height) {
  *width = window->width;
  *height = window->height;
}

void plugin_window_scale(PluginWindow *window, double scale) {
  uint32_t width, height;
  window_size(scale, &width, &height);
  plugin_window_resize(window, width, height);
}

/* ---- while it is open ----------------------------------------------------------------------- */

static void draw(void *opened, cairo_t *cairo, uint32_t width, uint32_t height) {
  const PluginWindow *const window = opened;
  picture_draw(&window->scene, cairo, painting_scale(width, height));
}

static void tick(void *opened) { plugin_window_update(opened); }

bool plugin_window_open(PluginWindow *window, uintptr_t parent) {
  const NativeHandler handler = {.context = window,
                                 .draw = draw,
                                 .press = plugin_window_press,
                                 .drag = plugin_window_drag,
                                 .release = plugin_window_release,
                                 .menu = plugin_window_menu,
                                 .hover = plugin_window_hover,
                                 .scroll = plugin_window_scroll,
                                 .key = plugin_window_key,
                                 .tick = tick};
  if (window->outside) return false;
  window->outside = native_window_create(parent, window->width, window->height, &handler);
  if (!window->outside) return false;
  plugin_window_note_looks(window);
  plugin_window_look(window);
  return true;
}

bool plugin_window_is_open(const PluginWindow *window) { return window->outside != NULL; }

void plugin_window_close(PluginWindow *window) {
  if (!window->outside) return;
  atomic_store(&window->shell.instrument->window.is_shown, false);
  plugin_window_release(window);
  plugin_window_drop_view(window);
  native_window_destroy(window->outside);
  window->outside = NULL;
}

uintptr_t plugin_window_id(const PluginWindow *window) { return native_window_id(window->outside); }

void plugin_window_show(PluginWindow *window, bool shown) {
  atomic_store(&window->shell.instrument->window.is_shown, shown);
  native_window_show(window->outside, shown);
}

/* The name of a drum changes with a program change, too, of which nobody tells. */
void plugin_window_update(PluginWindow *window) {
  WindowLink *const link = &window->shell.instrument->window;
  if (!window->outside || window->is_updating || !plugin_window_take_view(window)) return;
  window->is_updating = true;
  if (atomic_exchange(&link->is_stale, false)) {
    plugin_window_drop_view(window);
    plugin_window_note_looks(window);
  }
  native_window_take_events(window->outside);
  plugin_window_look(window);
  native_window_draw(window->outside);
  plugin_window_lend_view(window);
  window->is_updating = false;
}

bool plugin_window_update_itself(PluginWindow *window) {
  return native_window_start_ticks(window->outside, WINDOW_PERIOD);
}

bool plugin_window_has_timers(void) { return native_window_has_ticks(); }
