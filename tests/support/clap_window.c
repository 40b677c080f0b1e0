/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "clap_window.h"

#include <ctype.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <time.h>

#include <cmocka.h>

#include "window_checks.h"

#ifdef _WIN32
#  define NATIVE_API CLAP_WINDOW_API_WIN32
#  define OTHER_API CLAP_WINDOW_API_X11
#  define NATIVE_ID(window) .win32 = (void *)(window)
#  define HAS_TIMERS 1 /* windows have some of their own */
#else
#  define NATIVE_API CLAP_WINDOW_API_X11
#  define OTHER_API CLAP_WINDOW_API_WIN32
#  define NATIVE_ID(window) .x11 = (window)
#  define HAS_TIMERS 0
#endif

Desktop server;

void open_window(Opened *opened, double scale) {
  const clap_plugin_t *const plugin = opened->host->plugin;
  uint32_t width = 0, height = 0;
  opened->gui = clap_host_extension(opened->host, CLAP_EXT_GUI);
  assert_true(opened->gui->is_api_supported(plugin, NATIVE_API, false));
  assert_false(opened->gui->is_api_supported(plugin, NATIVE_API, true));
  assert_false(opened->gui->is_api_supported(plugin, OTHER_API, false));
  assert_true(opened->gui->create(plugin, NATIVE_API, false));
  assert_true(opened->gui->set_scale(plugin, scale));
  assert_true(opened->gui->get_size(plugin, &width, &height));
  assert_int_equal(width, lround(scale * WIDTH));
  assert_int_equal(height, lround(scale * HEIGHT));
  opened->outer = desktop_window(&server, (uint16_t)width, (uint16_t)height);
  const clap_window_t parent = {.api = NATIVE_API, NATIVE_ID(opened->outer)};
  assert_true(opened->gui->set_parent(plugin, &parent));
  assert_true(opened->gui->show(plugin));
  assert_int_equal(opened->host->timers, 1);
  opened->inner = desktop_inner(&server, opened->outer);
  assert_true(opened->inner != 0);
}

/* For a host that only lets messages through. */
static void it_draws_itself(const clap_plugin_t *plugin, const clap_plugin_gui_t *gui) {
  static const struct timespec moment = {.tv_nsec = 10000000};
  const DesktopWindow outer = desktop_window(&server, WIDTH, HEIGHT);
  const clap_window_t parent = {.api = NATIVE_API, NATIVE_ID(outer)};
  assert_true(gui->set_parent(plugin, &parent));
  assert_true(gui->show(plugin));
  uint32_t color = 0;
  for (int i = 0; i < 500 && color == 0; i++) {
    (void)nanosleep(&moment, NULL);
    desktop_settle(&server);
    color = desktop_pixel(&server, desktop_inner(&server, outer), CONTROL_X + 2, STRAINER_Y);
  }
  assert_true(color != 0);
  gui->destroy(plugin);
  desktop_close(&server, outer);
}

void scan_window(const char *id) {
  ClapHost *const host = clap_host_scan(&clap_entry, id);
  const clap_plugin_gui_t *const gui = clap_host_extension(host, CLAP_EXT_GUI);
  assert_true(gui->is_api_supported(host->plugin, NATIVE_API, false));
  assert_false(gui->is_api_supported(host->plugin, NATIVE_API, true));
  assert_int_equal(gui->create(host->plugin, NATIVE_API, false), HAS_TIMERS);
  if (HAS_TIMERS) it_draws_itself(host->plugin, gui);
  clap_host_close(host);
}

void close_window(Opened *opened) {
  opened->gui->destroy(opened->host->plugin);
  assert_int_equal(opened->host->timers, 0);
  desktop_close(&server, opened->outer);
}

void close_host(Opened *opened) {
  close_window(opened);
  clap_host_close(opened->host);
}

/* A look of the window at what has happened, as the host's timer brings it. */
void tick(const Opened *opened) {
  const clap_plugin_timer_support_t *const timer =
    clap_host_extension(opened->host, CLAP_EXT_TIMER_SUPPORT);
  timer->on_timer(opened->host->plugin, 0);
}

void click(const Opened *opened, int x, int y) {
  desktop_click(&server, opened->inner, x, y);
  tick(opened);
}

void double_click(const Opened *opened, int x, int y) {
  desktop_double_click(&server, opened->inner, x, y);
  tick(opened);
}

void wheel(const Opened *opened, int x, int y, int steps) {
  desktop_wheel(&server, opened->inner, x, y, steps);
  tick(opened);
}

void press_key(const Opened *opened, const char *name) {
  desktop_key(&server, opened->inner, name, 0);
  tick(opened);
}

/* Keysyms of digits and letters are called as they are; capitals take Shift. */
void type_text(const Opened *opened, const char *text) {
  static const struct {
    char letter;
    const char *name;
  } names[] = {{'.', "period"}, {'-', "minus"}, {' ', "space"}, {'/', "slash"}};
  for (; *text; text++) {
    const char own[] = {*text, '\0'};
    const char *name = own;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
      if (names[i].letter == *text) name = names[i].name;
    desktop_key(&server, opened->inner, name, isupper((unsigned char)*text) ? DESKTOP_SHIFT : 0);
  }
  tick(opened);
}

void drag(const Opened *opened, int x, int y, int to_x, int to_y) {
  desktop_drag(&server, opened->inner, x, y, to_x, to_y);
  tick(opened);
}
