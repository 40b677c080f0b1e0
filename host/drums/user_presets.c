/* SPDX-License-Identifier: MIT */
#include "drums/user_presets.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "platform/files.h"
#include "platform/paths.h"

static bool fits(int length) { return length >= 0 && length < USER_PRESET_PATH; }

bool user_folder(char path[USER_PRESET_PATH]) {
#ifdef _WIN32
  const char *const data = getenv("APPDATA"), *const home = NULL;
#else
  const char *const data = getenv("XDG_DATA_HOME"), *const home = getenv("HOME");
#endif
  if (data && *data) return fits(snprintf(path, USER_PRESET_PATH, "%s/tabor", data));
  if (!home || !*home) return false;
  return fits(snprintf(path, USER_PRESET_PATH, "%s/.local/share/tabor", home));
}

bool user_preset_path(const char *name, char path[USER_PRESET_PATH]) {
  if (!user_folder(path)) return false;
  const size_t length = strlen(path);
  return fits((int)length + snprintf(path + length, USER_PRESET_PATH - length, "/%s.ini", name));
}

const char *user_preset_find(const char *name, char room[USER_PRESET_PATH]) {
  return user_preset_path(name, room) && file_exists(room) ? room : NULL;
}

bool preset_is_file(const char *preset) {
  const size_t length = strlen(preset);
  return path_has_folder(preset) || (length >= 4 && strcmp(preset + length - 4, ".ini") == 0);
}

PresetStem preset_stem(const char *preset) {
  const char *const base = path_base(preset);
  const size_t length = strlen(base);
  const bool is_ini = length > 4 && strcmp(base + length - 4, ".ini") == 0;
  return (PresetStem){base, (int)(is_ini ? length - 4 : length)};
}
