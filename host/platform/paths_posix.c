/* SPDX-License-Identifier: MIT */
#include <string.h>

#include "platform/paths.h"

bool path_has_folder(const char *path) { return strchr(path, '/') != NULL; }

size_t path_folder_length(const char *path) {
  const char *const slash = strrchr(path, '/');
  return slash ? (size_t)(slash - path) + 1 : 0;
}

const char *path_base(const char *path) { return path + path_folder_length(path); }

bool path_ends_with_separator(const char *path) {
  const size_t length = strlen(path);
  return length > 0 && path[length - 1] == '/';
}
