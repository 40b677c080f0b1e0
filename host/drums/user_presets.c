/* SPDX-License-Identifier: MIT */
#include "drums/user_presets.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

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

bool user_file_path(const char *file, char path[USER_PRESET_PATH]) {
  if (!user_folder(path)) return false;
  const size_t length = strlen(path);
  return fits((int)length + snprintf(path + length, USER_PRESET_PATH - length, "/%s", file));
}

bool user_preset_path(const char *name, char path[USER_PRESET_PATH]) {
  char file[USER_PRESET_PATH];
  return fits(snprintf(file, sizeof file, "%s.ini", name)) && user_file_path(file, path);
}

/* ---- writing -------------------------------------------------------------------------------- */

/* With those that it lies in. */
static bool make_folder(char *path) {
  for (char *end = strchr(path + 1, '/'); end; end = strchr(end + 1, '/')) {
    *end = '\0';
    (void)folder_make(path);
    *end = '/';
  }
  return folder_make(path) || errno == EEXIST;
}

static bool write_all(int descriptor, const char *text) {
  size_t left = strlen(text);
  while (left > 0) {
    const ssize_t count = write(descriptor, text, (unsigned)left);
    if (count <= 0) return false;
    text += count;
    left -= (size_t)count;
  }
  return true;
}

/* Under another name first, so that a file of before stays if the disk is full. */
static bool replace(const char *path, const char *text) {
  char part[USER_PRESET_PATH + 16];
  (void)snprintf(part, sizeof part, "%s.XXXXXX", path);
  const int descriptor = file_create_unique(part);
  if (descriptor < 0) return false;
  file_take_permissions(descriptor, NULL);
  const bool is_written = write_all(descriptor, text);
  if (close(descriptor) == 0 && is_written && file_rename(part, path)) return true;
  (void)file_remove(part);
  return false;
}

bool user_folder_write(const char *file, const char *text, char *message, size_t size) {
  char folder[USER_PRESET_PATH], path[USER_PRESET_PATH];
  if (!user_folder(folder) || !user_file_path(file, path)) {
    (void)snprintf(message, size,
                   "there is no folder for the user's files: neither HOME nor "
                   "XDG_DATA_HOME says where");
    return false;
  }
  if (make_folder(folder) && replace(path, text)) return true;
  (void)snprintf(message, size, "cannot write '%.160s': %s", path, strerror(errno));
  return false;
}

/* ---- names ---------------------------------------------------------------------------------- */

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
