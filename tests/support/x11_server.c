/* SPDX-License-Identifier: MIT */
#include "x11_server.h"

#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <xkbcommon/xkbcommon.h>

#include <cmocka.h>

static void run_server(int out) {
  char number[16];
  (void)prctl(PR_SET_PDEATHSIG, SIGTERM); /* with a test that crashes it ends, too */
  (void)snprintf(number, sizeof number, "%d", out);
  (void)execlp("Xvfb", "Xvfb", "-displayfd", number, "-screen", "0", "1600x1200x24", "-nolisten",
               "tcp", (char *)NULL);
  _exit(127);
}

bool x11_server_start(X11Server *server) {
  int ends[2], number = 0;
  char line[32] = "", display[40];
  assert_int_equal(pipe(ends), 0);
  server->process = fork();
  assert_true(server->process >= 0);
  if (server->process == 0) run_server(ends[1]);
  (void)close(ends[1]);
  const ssize_t length = read(ends[0], line, sizeof line - 1);
  (void)close(ends[0]);
  if (length <= 0) { /* it ended without a word */
    (void)waitpid(server->process, NULL, 0);
    return false;
  }
  (void)snprintf(display, sizeof display, ":%d", atoi(line));
  assert_int_equal(setenv("DISPLAY", display, 1), 0);
  server->connection = xcb_connect(display, &number);
  assert_int_equal(xcb_connection_has_error(server->connection), 0);
  server->screen = xcb_setup_roots_iterator(xcb_get_setup(server->connection)).data;
  return true;
}

void x11_server_stop(X11Server *server) {
  xcb_disconnect(server->connection);
  (void)kill(server->process, SIGTERM);
  (void)waitpid(server->process, NULL, 0);
}

int x11_server_run(X11Server *server, int (*tests)(void)) {
  if (!x11_server_start(server)) {
    print_message("SKIPPED: no X server: needs xvfb\n");
    return 0;
  }
  const int failed = tests();
  x11_server_stop(server);
  return failed;
}

static void ask(X11Server *server) {
  free(
    xcb_get_input_focus_reply(server->connection, xcb_get_input_focus(server->connection), NULL));
}

/* Everything that was asked for has been done and, by the second answer, told to other clients. */
static void settle(X11Server *server) {
  ask(server);
  ask(server);
}

xcb_window_t x11_server_window(X11Server *server, uint16_t width, uint16_t height) {
  const xcb_window_t window = xcb_generate_id(server->connection);
  xcb_create_window(server->connection, XCB_COPY_FROM_PARENT, window, server->screen->root, 0, 0,
                    width, height, 0, XCB_WINDOW_CLASS_INPUT_OUTPUT, server->screen->root_visual, 0,
                    NULL);
  xcb_map_window(server->connection, window);
  settle(server);
  return window;
}

void x11_server_close(X11Server *server, xcb_window_t window) {
  xcb_destroy_window(server->connection, window);
  settle(server);
}

xcb_window_t x11_server_inner(X11Server *server, xcb_window_t window) {
  xcb_query_tree_reply_t *const tree =
    xcb_query_tree_reply(server->connection, xcb_query_tree(server->connection, window), NULL);
  assert_non_null(tree);
  const xcb_window_t inner =
    xcb_query_tree_children_length(tree) > 0 ? xcb_query_tree_children(tree)[0] : 0;
  free(tree);
  return inner;
}

void x11_server_point(X11Server *server, xcb_window_t window, uint8_t type, uint8_t button, int x,
                      int y) {
  union {
    xcb_button_press_event_t event; /* all three kinds have these fields */
    char bytes[32];
  } sent = {.event = {.response_type = type,
                      .detail = button,
                      .time = server->time,
                      .root = server->screen->root,
                      .event = window,
                      .event_x = (int16_t)x,
                      .event_y = (int16_t)y,
                      .same_screen = 1}};
  xcb_send_event(server->connection, false, window, 0, sent.bytes);
  settle(server);
}

void x11_server_click(X11Server *server, xcb_window_t window, int x, int y) {
  server->time += 1000;
  x11_server_point(server, window, XCB_BUTTON_PRESS, 1, x, y);
  x11_server_point(server, window, XCB_BUTTON_RELEASE, 1, x, y);
}

void x11_server_wheel(X11Server *server, xcb_window_t window, int x, int y, int steps) {
  for (int i = 0; i < abs(steps); i++)
    x11_server_point(server, window, XCB_BUTTON_PRESS, steps > 0 ? 4 : 5, x, y);
}

void x11_server_double_click(X11Server *server, xcb_window_t window, int x, int y) {
  x11_server_click(server, window, x, y);
  server->time += 100 - 1000;
  x11_server_click(server, window, x, y);
}

/* The code of the key that has the symbol on its first or second level. */
static xcb_keycode_t code_of(X11Server *server, xcb_keysym_t symbol) {
  const xcb_setup_t *const setup = xcb_get_setup(server->connection);
  const uint8_t count = (uint8_t)(setup->max_keycode - setup->min_keycode + 1);
  xcb_get_keyboard_mapping_reply_t *const mapping = xcb_get_keyboard_mapping_reply(
    server->connection, xcb_get_keyboard_mapping(server->connection, setup->min_keycode, count),
    NULL);
  assert_non_null(mapping);
  const xcb_keysym_t *const symbols = xcb_get_keyboard_mapping_keysyms(mapping);
  const int length = xcb_get_keyboard_mapping_keysyms_length(mapping);
  int at = 0;
  while (at < length && (symbols[at] != symbol || at % mapping->keysyms_per_keycode > 1)) at++;
  assert_true(at < length);
  const int code = setup->min_keycode + at / mapping->keysyms_per_keycode;
  free(mapping);
  return (xcb_keycode_t)code;
}

void x11_server_key(X11Server *server, xcb_window_t window, const char *name, uint16_t state) {
  const xcb_keysym_t symbol = xkb_keysym_from_name(name, XKB_KEYSYM_NO_FLAGS);
  union {
    xcb_key_press_event_t event;
    char bytes[32];
  } sent = {.event = {.response_type = XCB_KEY_PRESS,
                      .detail = code_of(server, symbol),
                      .time = server->time += 1000,
                      .root = server->screen->root,
                      .event = window,
                      .state = state,
                      .same_screen = 1}};
  xcb_send_event(server->connection, false, window, 0, sent.bytes);
  settle(server);
}

void x11_server_drag(X11Server *server, xcb_window_t window, int x, int y, int to_x, int to_y) {
  x11_server_point(server, window, XCB_BUTTON_PRESS, 1, x, y);
  x11_server_point(server, window, XCB_MOTION_NOTIFY, 0, to_x, to_y);
  x11_server_point(server, window, XCB_BUTTON_RELEASE, 1, to_x, to_y);
}

uint32_t x11_server_pixel(X11Server *server, xcb_window_t window, int x, int y) {
  xcb_get_image_reply_t *const image =
    xcb_get_image_reply(server->connection,
                        xcb_get_image(server->connection, XCB_IMAGE_FORMAT_Z_PIXMAP, window,
                                      (int16_t)x, (int16_t)y, 1, 1, UINT32_MAX),
                        NULL);
  assert_non_null(image);
  const uint8_t *const bytes = xcb_get_image_data(image);
  const uint32_t color = (uint32_t)bytes[2] << 16 | (uint32_t)bytes[1] << 8 | bytes[0];
  free(image);
  return color;
}
