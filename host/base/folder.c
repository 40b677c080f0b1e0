/* SPDX-License-Identifier: MIT */
#include "base/folder.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

bool folder_ends_with_slash(const char *path) {
  const size_t length = strlen(path);
  return length > 0 && path[length - 1] == '/';
}

char *folder_path(const char *folder, const char *file) {
  const size_t size = strlen(folder) + strlen(file) + 1;
  char *const path = malloc(size);
  if (path) (void)snprintf(path, size, "%s%s", folder, file);
  return path;
}

char *folder_name(const char *path) {
  return folder_path(path, folder_ends_with_slash(path) ? "" : "/");
}

Outcome folder_check(const char *path) {
  struct stat status;
  if (stat(path, &status) == 0) {
    return S_ISDIR(status.st_mode) ? OUTCOME_OK : refuse("-o '%s': not a folder", path);
  }
  return errno == ENOENT ? OUTCOME_OK : fail("cannot write to '%s': %s", path, strerror(errno));
}

Outcome folder_create(const char *folder) {
  if (mkdir(folder, 0777) == 0 || errno == EEXIST) return OUTCOME_OK;
  return fail("cannot create the folder '%s': %s", folder, strerror(errno));
}
