/* SPDX-License-Identifier: MIT */
#include "kit/kit_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "drums/drum_file.h"
#include "drums/user_presets.h"
#include "platform/files.h"
#include "platform/paths.h"

/* Of "drum.NAME.preset" the drum, which is there or becomes the next; NULL: it is another key, or
 * there can be none. */
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

/* ---- sound files ---- */

/* "FOLDER/hat.wav" beside "FOLDER/kit.ini"; a path of its own stays. False if there is no room for
 * it. */
static bool move_beside(const char *file, char sample[TABOR_TEXT_SIZE]) {
  const size_t folder = path_has_folder(sample) ? 0 : (size_t)(path_base(file) - file);
  const size_t length = strlen(sample);
  if (folder + length >= TABOR_TEXT_SIZE) return false;
  memmove(sample + folder, sample, length + 1);
  memcpy(sample, file, folder);
  return true;
}

static PresetFileStatus move_samples(const char *file, TaborKitDef *def, char *message,
                                     size_t size) {
  for (unsigned note = 0; note < TABOR_KIT_NOTES; note++) {
    char *const sample = def->note[note].sample;
    if (!*sample || move_beside(file, sample)) continue;
    TaborError error = {.line = 0};
    (void)snprintf(error.message, sizeof error.message,
                   "note.%u.sample: with its folder the name is longer than %d bytes", note,
                   TABOR_TEXT_SIZE - 1);
    return preset_file_refuse(file, &error, message, size);
  }
  return PRESET_FILE_OK;
}

/* A name that is too long from the root stays as it is. */
void kit_file_root_samples(TaborKitDef *def) {
  for (unsigned note = 0; note < TABOR_KIT_NOTES; note++) {
    char *const sample = def->note[note].sample;
    char *const rooted = *sample ? file_absolute(sample) : NULL;
    if (rooted && strlen(rooted) < TABOR_TEXT_SIZE) memcpy(sample, rooted, strlen(rooted) + 1);
    free(rooted);
  }
}

/* ---- files ---- */

/* A TaborTextTake. */
static TaborStatus take_line(void *def, const TaborTextLine *line, TaborError *error) {
  const TaborStatus status = line->key ? kit_file_set(def, line->full, line->value, error)
                                       : tabor_kit_def_section(def, line->section, error);
  if (status == TABOR_OK || strcmp(line->section, "drum") != 0) return status;
  const size_t length = strlen(error->message);
  (void)snprintf(error->message + length, sizeof error->message - length,
                 "; is this file a drum, not a kit?");
  return status;
}

PresetFileStatus kit_file_parse(const char *name, const char *text, size_t length, TaborKitDef *def,
                                char *message, size_t size) {
  tabor_kit_def_default(def);
  const PresetFileStatus status =
    preset_file_parse(name, text, length, take_line, def, message, size);
  return status == PRESET_FILE_OK ? move_samples(name, def, message, size) : status;
}

PresetFileStatus kit_file_read(const char *path, TaborKitDef *def, char *message, size_t size) {
  char *text;
  size_t length;
  PresetFileStatus status = preset_file_load(path, &text, &length, message, size);
  if (status == PRESET_FILE_OK) status = kit_file_parse(path, text, length, def, message, size);
  free(text);
  return status;
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
