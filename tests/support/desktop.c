/* SPDX-License-Identifier: MIT */
#include "desktop.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

int desktop_run(Desktop *desktop, int (*tests)(void)) {
  if (!desktop_start(desktop)) {
    print_message("SKIPPED: no desktop: needs xvfb\n");
    return 0;
  }
  const int failed = tests();
  desktop_stop(desktop);
  return failed;
}

void desktop_click(Desktop *desktop, DesktopWindow window, int x, int y) {
  desktop->time += 1000;
  desktop_point(desktop, window, DESKTOP_PRESS, DESKTOP_LEFT, x, y);
  desktop_point(desktop, window, DESKTOP_RELEASE, DESKTOP_LEFT, x, y);
}

void desktop_double_click(Desktop *desktop, DesktopWindow window, int x, int y) {
  desktop_click(desktop, window, x, y);
  desktop->time += 100 - 1000;
  desktop_click(desktop, window, x, y);
}

void desktop_drag(Desktop *desktop, DesktopWindow window, int x, int y, int to_x, int to_y) {
  desktop_point(desktop, window, DESKTOP_PRESS, DESKTOP_LEFT, x, y);
  desktop_point(desktop, window, DESKTOP_MOVE, DESKTOP_NONE, to_x, to_y);
  desktop_point(desktop, window, DESKTOP_RELEASE, DESKTOP_LEFT, to_x, to_y);
}
