/* SPDX-License-Identifier: MIT */
/* Plugins without a window: hosts show their controls. */
#include "clap/gui.h"

const void *gui_extension(const char *id) {
  (void)id;
  return NULL;
}

void gui_end(const clap_plugin_t *plugin) { (void)plugin; }
