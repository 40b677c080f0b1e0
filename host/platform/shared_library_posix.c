/* SPDX-License-Identifier: MIT */
#include "platform/shared_library.h"

#include <dlfcn.h>
#include <string.h>

void *shared_library_open(const char *name) { return dlopen(name, RTLD_NOW | RTLD_LOCAL); }

void *shared_library_sndfile(void) {
#ifdef __APPLE__
  return shared_library_open("libsndfile.1.dylib");
#else
  return shared_library_open("libsndfile.so.1");
#endif
}

void shared_library_find(void *library, const char *name, void *function) {
  void *const address = dlsym(library, name);
  memcpy(function, &address, sizeof address);
}

void shared_library_close(void *library) { (void)dlclose(library); }
