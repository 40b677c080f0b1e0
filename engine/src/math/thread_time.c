/* SPDX-License-Identifier: MIT */
#if (defined(__unix__) || defined(__APPLE__)) && !defined(__EMSCRIPTEN__)
#  define _POSIX_C_SOURCE 199309L
#endif
#include "math/thread_time.h"

#include <time.h>

double tb_thread_time(void) {
#ifdef _POSIX_C_SOURCE
  struct timespec now;
  if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now) == 0) {
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
  }
#endif
  return (double)clock() / CLOCKS_PER_SEC;
}
