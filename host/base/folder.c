/* SPDX-License-Identifier: MIT */
#include "base/folder.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "platform/files.h"
#include "platform/paths.h"

char *folder_path(const char *folder, const char *file) {
  const size_t size = strlen(folder) + strlen(file) + 1;
  char *const path = malloc(size);
  if (path) (void)snprintf(path, size, "%s%s", folder, file);
  return path;
}

char *folder_name(const char *path) {
  return folder_path(path, path_ends_with_separator(path) ? "" : "/");
}

Outcome folder_check(const char *path) {
  FileStatus status;
  if (file_status(path, &status)) {
    return status.kind == FILE_KIND_FOLDER ? OUTCOME_OK : refuse("-o '%s': not a folder", path);
  }
  return errno == ENOENT ? OUTCOME_OK : fail("cannot write to '%s': %s", path, strerror(errno));
}

Outcome folder_create(const char *folder) {
  if (folder_make(folder) || errno == EEXIST) return OUTCOME_OK;
  return fail("cannot create the folder '%s': %s", folder, strerror(errno));
}

static Outcome create_parent(const char *folder) {
  const size_t length = path_folder_length(folder);
  if (length < 2) return OUTCOME_OK;
  char *const parent = malloc(length);
  if (!parent) return fail_memory();
  memcpy(parent, folder, length - 1);
  parent[length - 1] = '\0';
  const Outcome outcome = folder_create_whole(parent);
  free(parent);
  return outcome;
}

Outcome folder_create_whole(const char *folder) {
  if (folder_make(folder)) return OUTCOME_OK;
  if (errno != ENOENT) return folder_create(folder);
  const Outcome outcome = create_parent(folder);
  return outcome == OUTCOME_OK ? folder_create(folder) : outcome;
}
