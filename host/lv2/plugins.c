/* SPDX-License-Identifier: MIT */
#include "lv2/plugins.h"

#include <string.h>

#define DRUM                                                                                       \
  .window = URI_WINDOW, .group = URI_GROUP, .file = URI_DRUM_FILE, .text = URI_STATE_DEFINITION,   \
  .needs_text = true

const Lv2Plugin lv2_plugins[INSTRUMENT_KINDS] = {
  {.uri = URI_DRUM, .kind = INSTRUMENT_STEREO, .type = "InstrumentPlugin", DRUM},
  {.uri = URI_DRUM_MULTI, .kind = INSTRUMENT_MULTI, .type = "InstrumentPlugin", DRUM},
  {.uri = URI_KIT,
   .kind = INSTRUMENT_KIT,
   .type = "InstrumentPlugin",
   .window = URI_KIT_WINDOW,
   .group = URI_KIT_GROUP,
   .file = URI_KIT_FILE,
   .text = URI_STATE_KIT},
  {.uri = URI_EFFECT, .kind = INSTRUMENT_EFFECT, .type = "SimulatorPlugin", DRUM}};

const Lv2Plugin *lv2_plugin_find(const char *uri) {
  for (size_t i = 0; i < INSTRUMENT_KINDS; i++) {
    if (strcmp(uri, lv2_plugins[i].uri) == 0) return &lv2_plugins[i];
  }
  return NULL;
}
