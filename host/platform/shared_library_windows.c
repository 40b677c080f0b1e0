/* SPDX-License-Identifier: MIT */
#include "platform/shared_library.h"

#include <string.h>
#include <windows.h>

void *shared_library_sndfile(void) {
  HMODULE library = LoadLibraryA("sndfile.dll");
  if (!library) library = LoadLibraryA("libsndfile-1.dll");
  return library;
}

void shared_library_find(void *library, const char *name, void *function) {
  const FARPROC address = GetProcAddress(library, name);
  memcpy(function, &address, sizeof address);
}

void shared_library_close(void *library) { (void)FreeLibrary(library); }
