/* SPDX-License-Identifier: MIT */
#include "kit/kit_file.h"

#include <stdio.h>
#include <string.h>

bool kit_file_is_note(const char *section) { return strncmp(section, "note.", 5) == 0; }

/* A PresetPairFn. */
static bool set_pair(void *context, const char *section, const char *key, const char *value,
                     unsigned line, char *message, size_t size) {
  const KitFileReader *const reader = context;
  if (kit_file_is_note(section)) {
    return !reader->note || reader->note(reader->context, section, key, value, line, message, size);
  }
  char full[2 * TABOR_NAME_SIZE + 256];
  (void)snprintf(full, sizeof full, "%s.%s", section, key ? key : "");
  TaborError error;
  const TaborStatus status = key ? tabor_kit_def_set(reader->def, full, value, &error)
                                 : tabor_kit_def_section(reader->def, section, &error);
  if (status == TABOR_OK) return true;
  const char *const hint = strcmp(section, "drum") == 0 ? "; is this file a drum, not a kit?" : "";
  (void)snprintf(message, size, "%s%s", error.message, hint);
  return false;
}

PresetFileStatus kit_file_read(const char *path, const KitFileReader *reader, char *message,
                               size_t size) {
  KitFileReader own = *reader;
  tabor_kit_def_default(own.def);
  return preset_file_read(path, set_pair, &own, message, size);
}

PresetFileStatus kit_file_parse(const char *name, const char *text, size_t length,
                                const KitFileReader *reader, char *message, size_t size) {
  KitFileReader own = *reader;
  tabor_kit_def_default(own.def);
  return preset_file_parse(name, text, length, set_pair, &own, message, size);
}

bool kit_file_check(const char *name, const TaborKitDef *def, char *message, size_t size) {
  TaborError error = {.message = "the kit has no drum; [drum.NAME] adds one"};
  if (def->drum_count > 0 && tabor_kit_def_validate(def, &error) == TABOR_OK) return true;
  (void)snprintf(message, size, "%s: %s", name, error.message);
  return false;
}
