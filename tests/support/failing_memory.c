/* SPDX-License-Identifier: MIT */
/**
 * @file failing_memory.c
 * A library to preload: allocation number TABOR_FAIL_AT of the process (malloc, calloc, realloc,
 * aligned ones) fails, and no other. With 0 none fails. The number of allocations is written to the
 * file TABOR_COUNT_IN at the end. Allocations of the dynamic loader and before main() count, too.
 */
#define _GNU_SOURCE
#include <errno.h>
#include <malloc.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>

/* What the C library itself calls its functions. */
extern void *__libc_malloc(size_t size);
extern void *__libc_calloc(size_t count, size_t size);
extern void *__libc_realloc(void *memory, size_t size);
extern void *__libc_memalign(size_t alignment, size_t size);

static atomic_ulong allocations;
static unsigned long failing;

static int fails(void) {
  const unsigned long number = atomic_fetch_add(&allocations, 1) + 1;
  if (failing == 0 || number != failing) return 0;
  errno = ENOMEM;
  return 1;
}

void *malloc(size_t size) { return fails() ? NULL : __libc_malloc(size); }
void *calloc(size_t count, size_t size) { return fails() ? NULL : __libc_calloc(count, size); }
void *realloc(void *memory, size_t size) { return fails() ? NULL : __libc_realloc(memory, size); }
void *aligned_alloc(size_t alignment, size_t size) {
  return fails() ? NULL : __libc_memalign(alignment, size);
}
void *memalign(size_t alignment, size_t size) { return aligned_alloc(alignment, size); }
int posix_memalign(void **memory, size_t alignment, size_t size) {
  void *const found = aligned_alloc(alignment, size);
  if (!found) return ENOMEM;
  *memory = found;
  return 0;
}

/* Counting starts here, behind the loader. */
__attribute__((constructor)) static void begin(void) {
  const char *const text = getenv("TABOR_FAIL_AT");
  failing = text ? strtoul(text, NULL, 10) : 0;
  atomic_store(&allocations, 0);
}

__attribute__((destructor)) static void end(void) {
  const char *const path = getenv("TABOR_COUNT_IN");
  const unsigned long count = atomic_load(&allocations);
  failing = 0;
  FILE *const file = path ? fopen(path, "w") : NULL;
  if (!file) return;
  (void)fprintf(file, "%lu\n", count);
  (void)fclose(file);
}
