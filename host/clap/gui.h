/* SPDX-License-Identifier: MIT */
/**
 * @file gui.h
 * The window of an instance (window/plugin_window.h) as CLAP's extension. It is one of X11,
 * which needs a host with timers, or of Windows. no_gui.c is there in place of gui.c where plugins
 * have no window.
 */
#ifndef TABOR_CLAP_GUI_H
#define TABOR_CLAP_GUI_H

#include <clap/clap.h>

/** The extension @p id if it is one of the window's, else NULL. */
const void *gui_extension(const char *id);
/** MAIN. Closes the window, if there is one. */
void gui_end(const clap_plugin_t *plugin);

#endif
