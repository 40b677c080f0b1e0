/* SPDX-License-Identifier: MIT */
/** @file processor_time.h The clock of benchmarks. Define _POSIX_C_SOURCE 200809L first. */
#ifndef TABOR_TESTS_PROCESSOR_TIME_H
#define TABOR_TESTS_PROCESSOR_TIME_H

#include <time.h>

/** Of this thread [s]. */
static inline double processor_time(void) {
  struct timespec time;
  (void)clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

#endif
