/* SPDX-License-Identifier: MIT */
#include "kit/kit_file.h"

#include <stdio.h>
#include <string.h>

#include "drums/drum_file.h"
#include "drums/user_presets.h"

bool kit_file_is_note(const char *section) { return strncmp(section, "note.", 5) == 0; }

/* Of "drum.NAME.preset" the drum, which is there or becomes the next; NULL: it is another key, or there can be none. */
static TaborDrumDef *drum_of_preset(TaborKitDef *def, const char *key) {
  char name[TABOR_NAME_SIZE] = "", section[TABOR_NAME_SIZE + sizeof "drum."];
  const char *const start = key + strlen("drum."), *const dot = strrchr(key, '.');
  if (strncmp(key, "drum.", 5) != 0 || dot <= start || strcmp(dot, ".preset") != 0) return NULL;
  if ((size_t)(dot - start) >= sizeof name) return NULL;
  memcpy(name, start, (size_t)(dot - start));
  (void)snprintf(section, sizeof section, "drum.%s", name);
  if (tabor_kit_def_section(def, section, NULL) != TABOR_OK) return NULL;
  return &def->drum[tabor_kit_def_find(def, name)].def;
}

TaborStatus kit_file_set(TaborKitDef *def, const char *key, const char *value, TaborError *error) {
  char room[USER_PRESET_PATH], message[2 * TABOR_TEXT_SIZE];
  TaborDrumDef own;
  const TaborStatus status = tabor_kit_def_set(def, key, value, error);
  if (status != TABOR_ERROR_NAME) return status;
  const char *const file = preset_is_file(value) ? value : user_preset_find(value, room);
  TaborDrumDef *const drum = file ? drum_of_preset(def, key) : NULL;
  if (!drum) return status;
  if (drum_file_read(file, &own, message, sizeof message) == PRESET_FILE_OK) {
    *drum = own;
    return TABOR_OK;
  }
  (void)snprintf(error->message, sizeof error->message, "%.*s", (int)sizeof error->message - 1,
                 message);
  return status;
}

void kit_name_after(TaborKitDef *def, const char *path) {
  const PresetStem stem = preset_stem(path);
  memset(def->name, 0, sizeof def->name);
  (void)snprintf(def->name, sizeof def->name, "%.*s", stem.length, stem.text);
}

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
  const TaborStatus status = key ? kit_file_set(reader->def, full, value, &error)
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
  TaborDrumDef placed;
  TaborStatus status =
    def->drum_count > 0 ? tabor_kit_def_validate(def, &error) : TABOR_ERROR_ARGUMENT;
  for (uint32_t i = 0; status == TABOR_OK && i < def->drum_count; i++) {
    status = tabor_kit_def_place(def, i, &placed, &error);
  }
  if (status == TABOR_OK) return true;
  (void)snprintf(message, size, "%s: %s", name, error.message);
  return false;
}
