/* SPDX-License-Identifier: MIT */
#include <ctype.h>
#include <string.h>

#include "platform/paths.h"

static bool is_separator(char c) { return c == '/' || c == '\\'; }

static bool has_drive(const char *path) {
  return isalpha((unsigned char)path[0]) && path[1] == ':';
}

size_t path_folder_length(const char *path) {
  size_t length = strlen(path);
  while (length > 0 && !is_separator(path[length - 1])) length--;
  return length == 0 && has_drive(path) ? 2 : length;
}

bool path_has_folder(const char *path) { return path_folder_length(path) > 0; }

const char *path_base(const char *path) { return path + path_folder_length(path); }

bool path_ends_with_separator(const char *path) {
  const size_t length = strlen(path);
  return length > 0 && is_separator(path[length - 1]);
}
