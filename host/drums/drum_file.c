/* SPDX-License-Identifier: MIT */
#include "drums/drum_file.h"

#include <stdio.h>
#include <string.h>

/* Sections of kit files, which a drum has not. */
static bool is_of_kit(const char *section) {
  return strcmp(section, "kit") == 0 || strncmp(section, "drum.", 5) == 0 ||
         strncmp(section, "note.", 5) == 0;
}

/* A PresetPairFn: a section or a "key = value" of a preset file into the definition. */
static bool set_pair(void *def, const char *section, const char *key, const char *value,
                     unsigned line, char *message, size_t size) {
  (void)line;
  char full[2 * TABOR_NAME_SIZE + 256];
  (void)snprintf(full, sizeof full, "%s.%s", section, key ? key : "");
  TaborError error;
  const TaborStatus status = key ? tabor_drum_def_set(def, full, value, &error)
                                 : tabor_drum_def_section(def, section, &error);
  if (status == TABOR_OK) return true;
  const char *const hint = is_of_kit(section) ? "; is this file a kit, not a drum?" : "";
  (void)snprintf(message, size, "%s%s", error.message, hint);
  return false;
}

PresetFileStatus drum_file_read(const char *path, TaborDrumDef *def, char *message, size_t size) {
  tabor_drum_def_clear(def);
  return preset_file_read(path, set_pair, def, message, size);
}
