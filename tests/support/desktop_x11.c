/* SPDX-License-Identifier: MIT */
#include "desktop.h"

#include <fcntl.h>
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
#include <xcb/xcb.h>
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

bool desktop_start(Desktop *desktop) {
  int ends[2], number = 0;
  char line[32] = "", display[40];
  assert_int_equal(pipe(ends), 0);
  desktop->process = fork();
  assert_true(desktop->process >= 0);
  if (desktop->process == 0) run_server(ends[1]);
  (void)close(ends[1]);
  const ssize_t length = read(ends[0], line, sizeof line - 1);
  (void)close(ends[0]);
  if (length <= 0) { /* it ended without a word */
    (void)waitpid(desktop->process, NULL, 0);
    return false;
  }
  (void)snprintf(display, sizeof display, ":%d", atoi(line));
  assert_int_equal(setenv("DISPLAY", display, 1), 0);
  desktop->connection = xcb_connect(display, &number);
  assert_int_equal(xcb_connection_has_error(desktop->connection), 0);
  desktop->screen = xcb_setup_roots_iterator(xcb_get_setup(desktop->connection)).data;
  return true;
}

void desktop_stop(Desktop *desktop) {
  xcb_disconnect(desktop->connection);
  (void)kill(desktop->process, SIGTERM);
  (void)waitpid(desktop->process, NULL, 0);
}

static void ask(Desktop *desktop) {
  free(
    xcb_get_input_focus_reply(desktop->connection, xcb_get_input_focus(desktop->connection), NULL));
}

/* Everything that was asked for has been done and, by the second answer, told to other clients. */
void desktop_settle(Desktop *desktop) {
  ask(desktop);
  ask(desktop);
}

DesktopWindow desktop_window(Desktop *desktop, uint16_t width, uint16_t height) {
  const xcb_window_t window = xcb_generate_id(desktop->connection);
  xcb_create_window(desktop->connection, XCB_COPY_FROM_PARENT, window, desktop->screen->root, 0, 0,
                    width, height, 0, XCB_WINDOW_CLASS_INPUT_OUTPUT, desktop->screen->root_visual,
                    0, NULL);
  xcb_map_window(desktop->connection, window);
  desktop_settle(desktop);
  return window;
}

void desktop_close(Desktop *desktop, DesktopWindow window) {
  xcb_destroy_window(desktop->connection, (xcb_window_t)window);
  desktop_settle(desktop);
}

DesktopWindow desktop_inner(Desktop *desktop, DesktopWindow window) {
  xcb_query_tree_reply_t *const tree = xcb_query_tree_reply(
    desktop->connection, xcb_query_tree(desktop->connection, (xcb_window_t)window), NULL);
  assert_non_null(tree);
  const xcb_window_t inner =
    xcb_query_tree_children_length(tree) > 0 ? xcb_query_tree_children(tree)[0] : 0;
  free(tree);
  return inner;
}

static void send_button(Desktop *desktop, DesktopWindow window, uint8_t type, uint8_t button, int x,
                        int y) {
  union {
    xcb_button_press_event_t event; /* motions have these fields, too */
    char bytes[32];
  } sent = {.event = {.response_type = type,
                      .detail = button,
                      .time = desktop->time,
                      .root = desktop->screen->root,
                      .event = (xcb_window_t)window,
                      .event_x = (int16_t)x,
                      .event_y = (int16_t)y,
                      .same_screen = 1}};
  xcb_send_event(desktop->connection, false, (xcb_window_t)window, 0, sent.bytes);
  desktop_settle(desktop);
}

void desktop_point(Desktop *desktop, DesktopWindow window, DesktopAct act, DesktopButton button,
                   int x, int y) {
  static const uint8_t types[] = {XCB_BUTTON_PRESS, XCB_BUTTON_RELEASE, XCB_MOTION_NOTIFY};
  static const uint8_t buttons[] = {0, 1, 3};
  send_button(desktop, window, types[act], buttons[button], x, y);
}

void desktop_wheel(Desktop *desktop, DesktopWindow window, int x, int y, int steps) {
  for (int i = 0; i < abs(steps); i++)
    send_button(desktop, window, XCB_BUTTON_PRESS, steps > 0 ? 4 : 5, x, y);
}

/* The code of the key that has the symbol on its first or second level. */
static xcb_keycode_t code_of(Desktop *desktop, xcb_keysym_t symbol) {
  const xcb_setup_t *const setup = xcb_get_setup(desktop->connection);
  const uint8_t count = (uint8_t)(setup->max_keycode - setup->min_keycode + 1);
  xcb_get_keyboard_mapping_reply_t *const mapping = xcb_get_keyboard_mapping_reply(
    desktop->connection, xcb_get_keyboard_mapping(desktop->connection, setup->min_keycode, count),
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

static uint16_t state_of(unsigned held) {
  return (uint16_t)((held & DESKTOP_SHIFT ? XCB_MOD_MASK_SHIFT : 0) |
                    (held & DESKTOP_CONTROL ? XCB_MOD_MASK_CONTROL : 0));
}

void desktop_key(Desktop *desktop, DesktopWindow window, const char *name, unsigned held) {
  const xcb_keysym_t symbol = xkb_keysym_from_name(name, XKB_KEYSYM_NO_FLAGS);
  union {
    xcb_key_press_event_t event;
    char bytes[32];
  } sent = {.event = {.response_type = XCB_KEY_PRESS,
                      .detail = code_of(desktop, symbol),
                      .time = desktop->time += 1000,
                      .root = desktop->screen->root,
                      .event = (xcb_window_t)window,
                      .state = state_of(held),
                      .same_screen = 1}};
  xcb_send_event(desktop->connection, false, (xcb_window_t)window, 0, sent.bytes);
  desktop_settle(desktop);
}

uint32_t desktop_pixel(Desktop *desktop, DesktopWindow window, int x, int y) {
  xcb_get_image_reply_t *const image = xcb_get_image_reply(
    desktop->connection,
    xcb_get_image(desktop->connection, XCB_IMAGE_FORMAT_Z_PIXMAP, (xcb_window_t)window, (int16_t)x,
                  (int16_t)y, 1, 1, UINT32_MAX),
    NULL);
  assert_non_null(image);
  const uint8_t *const bytes = xcb_get_image_data(image);
  const uint32_t color = (uint32_t)bytes[2] << 16 | (uint32_t)bytes[1] << 8 | bytes[0];
  free(image);
  return color;
}

/* ---- for a person, and what stays open -------------------------------------------------------- */

/* Fontconfig keeps what it knows of fonts until the program ends, and it is the same for every
 * window. */
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void) { return "leak:libfontconfig"; }

void keep_picture(DesktopWindow window, const char *name) {
  char command[256];
  const char *const folder = getenv("PICTURES");
  if (!folder) return;
  (void)snprintf(command, sizeof command, "import -window 0x%x %s/%s.png", (unsigned)window, folder,
                 name);
  if (system(command) != 0) printf("no picture of %s\n", name);
}

long open_files(void) {
  long count = 0;
  for (int i = 0; i < 1024; i++) count += fcntl(i, F_GETFD) != -1;
  return count;
}
