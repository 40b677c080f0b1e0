/* SPDX-License-Identifier: MIT */
/**
 * @file lv2_window.h
 * A host of LV2 plugins that opens their windows on a desktop of its own, and a hand that clicks
 * there.
 */
#ifndef TABOR_TESTS_LV2_WINDOW_H
#define TABOR_TESTS_LV2_WINDOW_H

#include <lv2/ui/ui.h>

#include "desktop.h"
#include "plugin_host.h"

extern Desktop server; /**< of all windows of a test */

typedef struct Opened {
  PluginHost *host;
  const LV2UI_Descriptor *descriptor;
  LV2UI_Handle ui;
  DesktopWindow outer, inner;
  uint32_t writes, grabs, releases;
  int width, height; /* that the window has asked for */
  LV2UI_Touch touch;
  LV2UI_Resize resize;
} Opened;

/** Opens the plugin of this binary with that URI, at its defaults. */
PluginHost *open_plugin(const char *uri);
/** Opens a window of opened->host and asserts what is due. */
void open_window(Opened *opened, float scale);
/** Tells the window where all ports stand. */
void tell_ports(const Opened *opened);
void close_window(const Opened *opened);
/** Closes the window and the host. */
void close_host(const Opened *opened);
/** Opens $OPENINGS windows, or 50, one after another, and asserts that no file stays open; closes
 * @p host. */
void check_openings(PluginHost *host);
/** A look of the window at what has happened, as the host's idle call brings it. */
void tick(const Opened *opened);
void click(const Opened *opened, int x, int y);
/** The wheel, up with positive @p steps. */
void wheel(const Opened *opened, int x, int y, int steps);
/** Presses at one place and lets go at the other. */
void drag(const Opened *opened, int x, int y, int to_x, int to_y);
/** As a host: a port that the window turns. */
void write_port(LV2UI_Controller controller, uint32_t port, uint32_t size, uint32_t format,
                const void *buffer);

#endif
