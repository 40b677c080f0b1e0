/* SPDX-License-Identifier: MIT */
#include "window/favourites.h"

#include <stdio.h>
#include <string.h>

#include "drums/user_presets.h"
#include "platform/files.h"

static const char NAME[] = "favourites";

static uint32_t place_of(const Favourites *favourites, const char *name) {
  uint32_t place = 0;
  while (place < favourites->count && strcmp(favourites->names[place], name) != 0) place++;
  return place;
}

static void add(Favourites *favourites, const char *name) {
  if (!*name || favourites->count == FAVOURITES_MOST || favourites_have(favourites, name)) return;
  (void)snprintf(favourites->names[favourites->count++], TABOR_NAME_SIZE, "%.*s",
                 TABOR_NAME_SIZE - 1, name);
}

void favourites_read(Favourites *favourites) {
  char path[2 * USER_PRESET_PATH], line[2 * TABOR_NAME_SIZE];
  favourites->count = 0;
  if (!user_file_path(NAME, path)) return;
  FILE *const file = file_stream_to_read(path);
  if (!file) return;
  while (fgets(line, sizeof line, file)) {
    line[strcspn(line, "\r\n")] = '\0';
    add(favourites, line);
  }
  (void)fclose(file);
}

bool favourites_have(const Favourites *favourites, const char *name) {
  return place_of(favourites, name) < favourites->count;
}

bool favourites_change(Favourites *favourites, const char *name) {
  char text[FAVOURITES_MOST * (TABOR_NAME_SIZE + 1) + 1] = "", message[TABOR_TEXT_SIZE];
  const uint32_t place = place_of(favourites, name);
  if (place < favourites->count) {
    favourites->count--;
    memmove(favourites->names[place], favourites->names[place + 1],
            (favourites->count - place) * sizeof *favourites->names);
  } else {
    add(favourites, name);
  }
  for (uint32_t i = 0; i < favourites->count; i++) {
    const size_t length = strlen(text);
    (void)snprintf(text + length, sizeof text - length, "%s\n", favourites->names[i]);
  }
  return user_folder_write(NAME, text, message, sizeof message);
}
