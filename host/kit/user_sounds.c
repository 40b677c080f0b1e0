/* SPDX-License-Identifier: MIT */
#include "kit/user_sounds.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "drums/drum_file.h"
#include "drums/user_presets.h"
#include "kit/kit_file.h"
#include "platform/files.h"

static const char EXTENSION[] = ".ini";

static void take(UserSound *sound, const char *name, const char *category, const char *comment) {
  (void)snprintf(sound->name, sizeof sound->name, "%s", name);
  (void)snprintf(sound->category, sizeof sound->category, "%s", category);
  (void)snprintf(sound->comment, sizeof sound->comment, "%s", comment);
}

/* The message is that of the drum. */
static bool read_sound(const char *path, TaborKitDef *kit, UserSound *sound, char *message,
                       size_t size) {
  TaborDrumDef drum;
  sound->is_kit = kit_file_read(path, kit, message, size) == PRESET_FILE_OK;
  if (sound->is_kit) {
    take(sound, kit->name, "kit", kit->comment);
    return true;
  }
  if (drum_file_read(path, &drum, message, size) != PRESET_FILE_OK) return false;
  take(sound, drum.name, drum.category, drum.comment);
  return true;
}

bool user_sound_read(const char *path, UserSound *sound, char *message, size_t size) {
  TaborKitDef *const kit = malloc(sizeof *kit);
  if (!kit) (void)snprintf(message, size, "out of memory");
  const bool is_read = kit && read_sound(path, kit, sound, message, size);
  free(kit);
  return is_read;
}

/* A look through the folder. */
typedef struct Look {
  char folder[USER_PRESET_PATH];
  bool kits;
  void (*visit)(void *context, const char *file, const UserSound *sound);
  void *context;
} Look;

static void visit_file(void *context, const char *file) {
  const Look *const look = context;
  char name[TABOR_NAME_SIZE], path[2 * USER_PRESET_PATH], message[2 * TABOR_TEXT_SIZE];
  UserSound sound;
  const char *const end = strstr(file, EXTENSION);
  const size_t length = end ? (size_t)(end - file) : 0;
  if (length == 0 || end[sizeof EXTENSION - 1] != '\0' || length >= sizeof name) return;
  memcpy(name, file, length);
  name[length] = '\0';
  const int size = snprintf(path, sizeof path, "%s/%s", look->folder, file);
  if (size < 0 || (size_t)size >= sizeof path) return;
  if (user_sound_read(path, &sound, message, sizeof message) && sound.is_kit == look->kits)
    look->visit(look->context, name, &sound);
}

void user_sounds_visit(bool kits,
                       void (*visit)(void *context, const char *file, const UserSound *sound),
                       void *context) {
  Look look = {.kits = kits, .visit = visit, .context = context};
  if (user_folder(look.folder)) folder_visit(look.folder, visit_file, &look);
}
