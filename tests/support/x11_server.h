/* SPDX-License-Identifier: MIT */
/**
 * @file x11_server.h
 * An X server of a test's own, and what a person does in a window: outer windows, clicks, pictures.
 * Any failure fails the test.
 */
#ifndef TABOR_TESTS_X11_SERVER_H
#define TABOR_TESTS_X11_SERVER_H

#include <stdbool.h>
#include <stdint.h>
#include <xcb/xcb.h>

typedef struct X11Server {
  int process; /**< its id */
  xcb_connection_t *connection;
  xcb_screen_t *screen;
  uint32_t time; /**< of the newest event [ms]: clicks are a second apart */
} X11Server;

/** Starts Xvfb and names it in $DISPLAY. False: there is no Xvfb. */
bool x11_server_start(X11Server *server);
void x11_server_stop(X11Server *server);
/** Starts the server, runs the tests and stops it. 0 without Xvfb, and a line that says so. */
int x11_server_run(X11Server *server, int (*tests)(void));

/** A mapped window on the root. */
xcb_window_t x11_server_window(X11Server *server, uint16_t width, uint16_t height);
void x11_server_close(X11Server *server, xcb_window_t window);
/** The first window inside @p window; 0 if there is none. */
xcb_window_t x11_server_inner(X11Server *server, xcb_window_t window);
/** What the pointer does at a place of @p window: XCB_BUTTON_PRESS, XCB_BUTTON_RELEASE or
 * XCB_MOTION_NOTIFY. */
void x11_server_point(X11Server *server, xcb_window_t window, uint8_t type, uint8_t button, int x,
                      int y);
/** Presses and lets go. */
void x11_server_click(X11Server *server, xcb_window_t window, int x, int y);
/** The wheel: up with positive @p steps. */
void x11_server_wheel(X11Server *server, xcb_window_t window, int x, int y, int steps);
/** Clicks twice within 100 ms. */
void x11_server_double_click(X11Server *server, xcb_window_t window, int x, int y);
/** Presses the key of a character or a name of keysyms, as "Return", with the modifiers @p state
 * (XCB_MOD_MASK_SHIFT). It has to be in the first two levels of the server's layout. */
void x11_server_key(X11Server *server, xcb_window_t window, const char *name, uint16_t state);
/** Presses at one place and lets go at the other. */
void x11_server_drag(X11Server *server, xcb_window_t window, int x, int y, int to_x, int to_y);
/** The colour of a pixel, 0xRRGGBB. */
uint32_t x11_server_pixel(X11Server *server, xcb_window_t window, int x, int y);

#endif
