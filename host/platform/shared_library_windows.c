/* SPDX-License-Identifier: MIT */
#include "platform/shared_library.h"

#include <stdlib.h>
#include <string.h>
#include <windows.h>

#include "platform/wide.h"

void *shared_library_open(const char *name) {
  wchar_t *const wide = wide_from_utf8(name);
  const HMODULE library = wide ? LoadLibraryW(wide) : NULL;
  free(wide);
  return library;
}

void *shared_library_sndfile(void) {
  void *const library = shared_library_open("sndfile.dll");
  return library ? library : shared_library_open("libsndfile-1.dll");
}

void shared_library_find(void *library, const char *name, void *function) {
  const FARPROC address = GetProcAddress(library, name);
  memcpy(function, &address, sizeof address);
}

void shared_library_close(void *library) { (void)FreeLibrary(library); }
