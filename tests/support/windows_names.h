/* SPDX-License-Identifier: MIT */
/* What tests use of C11 and POSIX, for mingw-w64, too. */
#ifndef TABOR_TEST_WINDOWS_NAMES_H
#define TABOR_TEST_WINDOWS_NAMES_H

#include <stddef.h>
#include <stdlib.h>

#ifdef _WIN32
#  include <io.h>
#  include <malloc.h>

static inline void *aligned_memory(size_t alignment, size_t size) {
  return _aligned_malloc(size, alignment);
}
static inline void free_aligned_memory(void *memory) { _aligned_free(memory); }

static inline char *mkdtemp(char *path) { return _mktemp(path) && mkdir(path) == 0 ? path : NULL; }
#else
static inline void *aligned_memory(size_t alignment, size_t size) {
  return aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}
static inline void free_aligned_memory(void *memory) { free(memory); }
#endif

#endif
