/* SPDX-License-Identifier: MIT */
#include <fcntl.h>
#include <io.h>
#include <malloc.h>
#include <stdlib.h>
#include <windows.h>

#include <shellapi.h>

#include "platform/process.h"
#include "platform/wide.h"

/* They last as long as the process. */
static char **to_utf8(wchar_t *const *wide, int count) {
  char **const arguments = calloc((size_t)count + 1, sizeof *arguments);
  for (int i = 0; arguments && i < count; i++) {
    arguments[i] = wide_to_utf8(wide[i]);
    if (!arguments[i]) return NULL;
  }
  return arguments;
}

static void take_arguments(int *argc, char ***argv) {
  int count = 0;
  wchar_t **const wide = CommandLineToArgvW(GetCommandLineW(), &count);
  char **const arguments = wide ? to_utf8(wide, count) : NULL;
  if (wide) (void)LocalFree(wide);
  if (!arguments) return;
  *argc = count;
  *argv = arguments;
}

/* Line ends are written as they are: sounds go to standard output, too. */
void process_begin(int *argc, char ***argv) {
  for (int descriptor = 0; descriptor <= 2; descriptor++) (void)_setmode(descriptor, _O_BINARY);
  (void)SetConsoleOutputCP(CP_UTF8);
  take_arguments(argc, argv);
}

unsigned process_processors(void) {
  const DWORD processors = GetActiveProcessorCount(ALL_PROCESSOR_GROUPS);
  return processors < 1 ? 1 : (unsigned)processors;
}

void *process_loaded_function(const char *name) {
  (void)name;
  return NULL;
}

void *process_allocate_aligned(size_t alignment, size_t size) {
  return _aligned_malloc(size, alignment);
}

void process_free_aligned(void *memory) { _aligned_free(memory); }
