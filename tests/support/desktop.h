/* SPDX-License-Identifier: MIT */
/**
 * @file desktop.h
 * A desktop of a test's own, and what a person does in a window: outer windows, clicks, pictures.
 * desktop_x11.c starts an X server; desktop_windows.c takes the desktop that there is. Any failure
 * fails the test.
 */
#ifndef TABOR_TESTS_DESKTOP_H
#define TABOR_TESTS_DESKTOP_H

#include <stdbool.h>
#include <stdint.h>

/** An id of X11 or a HWND. */
typedef uintptr_t DesktopWindow;

typedef struct Desktop {
  int process; /**< the id of an X server */
  struct xcb_connection_t *connection;
  struct xcb_screen_t *screen;
  uint32_t time; /**< of the newest event [ms]: clicks are a second apart */
  /* on Windows: the newest press that is no second one, or time 0 */
  uint32_t pressed;
  int pressed_x, pressed_y;
} Desktop;

typedef enum DesktopAct { DESKTOP_PRESS, DESKTOP_RELEASE, DESKTOP_MOVE } DesktopAct;
typedef enum DesktopButton { DESKTOP_NONE, DESKTOP_LEFT, DESKTOP_RIGHT } DesktopButton;
enum { DESKTOP_SHIFT = 1, DESKTOP_CONTROL = 2 }; /**< keys that are held */

/** Starts one. False: there is none. */
bool desktop_start(Desktop *desktop);
void desktop_stop(Desktop *desktop);
/** Starts one, runs the tests and stops it. 0 if there is none, and a line that says so. */
int desktop_run(Desktop *desktop, int (*tests)(void));

/** A window that is shown, and in none. */
DesktopWindow desktop_window(Desktop *desktop, uint16_t width, uint16_t height);
void desktop_close(Desktop *desktop, DesktopWindow window);
/** The first window inside @p window; 0 if there is none. */
DesktopWindow desktop_inner(Desktop *desktop, DesktopWindow window);
/** What the pointer does at a place of @p window. */
void desktop_point(Desktop *desktop, DesktopWindow window, DesktopAct act, DesktopButton button,
                   int x, int y);
/** Presses and lets go. */
void desktop_click(Desktop *desktop, DesktopWindow window, int x, int y);
/** The wheel: up with positive @p steps. */
void desktop_wheel(Desktop *desktop, DesktopWindow window, int x, int y, int steps);
/** Clicks twice within 100 ms. */
void desktop_double_click(Desktop *desktop, DesktopWindow window, int x, int y);
/** Presses the key of a character or a name of X11's, as "Return", while those of @p held are. It
 * has to be in the first two levels of the layout. */
void desktop_key(Desktop *desktop, DesktopWindow window, const char *name, unsigned held);
/** Presses at one place and lets go at the other. */
void desktop_drag(Desktop *desktop, DesktopWindow window, int x, int y, int to_x, int to_y);
/** The colour of a pixel, 0xRRGGBB. */
uint32_t desktop_pixel(Desktop *desktop, DesktopWindow window, int x, int y);

/** Lets windows take the messages that wait for them, if they have such. */
void desktop_settle(Desktop *desktop);
/** For a person: the window as it is, in the folder $PICTURES. */
void keep_picture(DesktopWindow window, const char *name);
/** Number of what a window may leave behind in this process: files that are open, of which a
 * connection to an X server is one; or windows and what they draw with. */
long open_files(void);

#endif
