/* SPDX-License-Identifier: MIT */
/* What tests use of C11 and POSIX, for mingw-w64, too. */
#ifndef TABOR_TEST_WINDOWS_NAMES_H
#define TABOR_TEST_WINDOWS_NAMES_H

#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>

#ifdef _WIN32
#  include <io.h>
#  include <malloc.h>

static inline void *aligned_memory(size_t alignment, size_t size) {
  return _aligned_malloc(size, alignment);
}
static inline void free_aligned_memory(void *memory) { _aligned_free(memory); }

static inline char *mkdtemp(char *path) { return _mktemp(path) && mkdir(path) == 0 ? path : NULL; }

/** The variable that says where the user's files are. */
#  define USER_DATA "APPDATA"
static inline int setenv(const char *name, const char *value, int overwrite) {
  (void)overwrite;
  return _putenv_s(name, value);
}
static inline int make_folder(const char *path) { return mkdir(path); }

/** A folder with files, and folders of files; its separators are slashes. */
static inline int remove_folder(const char *path) {
  char command[600];
  (void)snprintf(command, sizeof command, "rmdir /s /q \"%s\"", path);
  for (char *c = command + 12; *c; c++)
    if (*c == '/') *c = '\\';
  return system(command);
}

#  define QUOTED(text) "\"" text "\""

/** system(), which takes off the outer quotes of a command here if there are several. */
static inline int run_command(const char *command) {
  char quoted[2048];
  (void)snprintf(quoted, sizeof quoted, QUOTED("%s"), command);
  return system(quoted);
}
#else
#  include <sys/stat.h>

#  define USER_DATA "XDG_DATA_HOME"
#  define QUOTED(text) "'" text "'"

static inline int run_command(const char *command) { return system(command); }
static inline int make_folder(const char *path) { return mkdir(path, 0700); }

static inline int remove_folder(const char *path) {
  char command[600];
  (void)snprintf(command, sizeof command, "rm -r '%s'", path);
  return system(command);
}

static inline void *aligned_memory(size_t alignment, size_t size) {
  return aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}
static inline void free_aligned_memory(void *memory) { free(memory); }
#endif

#endif
