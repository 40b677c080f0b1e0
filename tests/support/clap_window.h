/* SPDX-License-Identifier: MIT */
/**
 * @file clap_window.h
 * A host of CLAP plugins that opens their windows on a desktop of its own, and a hand that clicks
 * there.
 */
#ifndef TABOR_TESTS_CLAP_WINDOW_H
#define TABOR_TESTS_CLAP_WINDOW_H

#include "clap_host.h"
#include "desktop.h"

extern const clap_plugin_entry_t clap_entry;
extern Desktop server; /**< of all windows of a test */

typedef struct Opened {
  ClapHost *host;
  const clap_plugin_gui_t *gui;
  DesktopWindow outer, inner;
} Opened;

/** A host that scans is told of the window of the plugin @p id, and on X11 cannot open it for want
 * of timers. */
void scan_window(const char *id);
/** Opens a window of opened->host and asserts what is due. */
void open_window(Opened *opened, double scale);
void close_window(Opened *opened);
/** Closes the window and the host. */
void close_host(Opened *opened);
/** A look of the window at what has happened, as the host's timer brings it. */
void tick(const Opened *opened);
void click(const Opened *opened, int x, int y);
void double_click(const Opened *opened, int x, int y);
/** The wheel, up with positive @p steps. */
void wheel(const Opened *opened, int x, int y, int steps);
/** Presses a key (desktop_key()), without modifiers. */
void press_key(const Opened *opened, const char *name);
/** Types letters and digits. */
void type_text(const Opened *opened, const char *text);
/** Presses at one place and lets go at the other. */
void drag(const Opened *opened, int x, int y, int to_x, int to_y);

#endif
