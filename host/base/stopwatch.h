/* SPDX-License-Identifier: MIT */
/* Reads a clock of the system. */
#ifndef TABOR_HOST_STOPWATCH_H
#define TABOR_HOST_STOPWATCH_H

#include <time.h>

/* Time [s]; CLOCK_THREAD_CPUTIME_ID: the calling thread's processor time. Any thread. */
static inline double stopwatch_seconds(clockid_t clock) {
  struct timespec now = {0};
  (void)clock_gettime(clock, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

#endif
