/* SPDX-License-Identifier: MIT */
#include "platform/shared_library.h"

#include <dlfcn.h>
#include <string.h>

void *shared_library_sndfile(void) {
#ifdef __APPLE__
  return dlopen("libsndfile.1.dylib", RTLD_NOW | RTLD_LOCAL);
#else
  return dlopen("libsndfile.so.1", RTLD_NOW | RTLD_LOCAL);
#endif
}

void shared_library_find(void *library, const char *name, void *function) {
  void *const address = dlsym(library, name);
  memcpy(function, &address, sizeof address);
}

void shared_library_close(void *library) { (void)dlclose(library); }
