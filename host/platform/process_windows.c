/* SPDX-License-Identifier: MIT */
#include <fcntl.h>
#include <io.h>
#include <malloc.h>
#include <process.h>
#include <stdlib.h>
#include <string.h>
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

/* A word as the C library of the other program takes it from its command line: in quotes, with
 * backslashes doubled before quotes and at the end. */
static wchar_t *quoted(const char *word) {
  wchar_t *const wide = wide_from_utf8(word);
  wchar_t *const text = wide ? malloc((2 * wcslen(wide) + 3) * sizeof *text) : NULL;
  if (text) {
    wchar_t *end = text;
    size_t backslashes = 0;
    *end++ = L'"';
    for (const wchar_t *next = wide;; next++) {
      if (*next == L'"' || !*next)
        for (; backslashes > 0; backslashes--) *end++ = L'\\';
      if (!*next) break;
      if (*next == L'"') *end++ = L'\\';
      backslashes = *next == L'\\' ? backslashes + 1 : 0;
      *end++ = *next;
    }
    *end++ = L'"';
    *end = 0;
  }
  free(wide);
  return text;
}

static bool quote_all(const char *const *words, wchar_t **quotes) {
  for (; *words; words++, quotes++) {
    *quotes = quoted(*words);
    if (!*quotes) return false;
  }
  return true;
}

int process_run(const char *const *words) {
  size_t count = 0;
  while (words[count]) count++;
  wchar_t **const quotes = calloc(count + 1, sizeof *quotes);
  wchar_t *const name = wide_from_utf8(words[0]);
  int status = -1;
  if (quotes && name && quote_all(words, quotes))
    status = (int)_wspawnvp(_P_WAIT, name, (const wchar_t *const *)quotes);
  for (size_t i = 0; quotes && i < count; i++) free(quotes[i]);
  free(quotes);
  free(name);
  return status;
}

void *process_allocate_aligned(size_t alignment, size_t size) {
  return _aligned_malloc(size, alignment);
}

void process_free_aligned(void *memory) { _aligned_free(memory); }
