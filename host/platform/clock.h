/* SPDX-License-Identifier: MIT */
/* Clocks of the system. */
#ifndef TABOR_HOST_CLOCK_H
#define TABOR_HOST_CLOCK_H

#include <pthread.h> /* on Windows the clocks are those of its threads' library */
#include <time.h>

/* Time [s]. Any thread. Windows counts processor time in steps of 15.6 ms, longer than a block of
 * sound: there the clocks of processor time show the time that has passed. */
static inline double stopwatch_seconds(clockid_t clock) {
  struct timespec now = {0};
#ifdef _WIN32
  if (clock == CLOCK_THREAD_CPUTIME_ID || clock == CLOCK_PROCESS_CPUTIME_ID)
    clock = CLOCK_MONOTONIC;
#endif
  (void)clock_gettime(clock, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Processor time [s] of the calling thread, where other threads compute something else. */
static inline double processor_seconds(void) { return stopwatch_seconds(CLOCK_THREAD_CPUTIME_ID); }

/* Processor time [s] of all threads, where they compute one thing together. It includes the turns
 * for which they wait for one another. */
static inline double process_seconds(void) { return stopwatch_seconds(CLOCK_PROCESS_CPUTIME_ID); }

/* Sleeps until CLOCK_MONOTONIC shows @p time [s]. macOS has no clock_nanosleep(). */
static inline void clock_sleep_until(double time) {
  double rest;
  while ((rest = time - stopwatch_seconds(CLOCK_MONOTONIC)) > 0) {
    const time_t seconds = (time_t)rest;
    const struct timespec moment = {.tv_sec = seconds,
                                    .tv_nsec = (long)(1e9 * (rest - (double)seconds))};
    (void)nanosleep(&moment, NULL);
  }
}

#endif
