/* SPDX-License-Identifier: MIT */
/**
 * @file host_stalls.c
 * Measures whether the machine keeps time: sleeps for a millisecond repeatedly, until SIGTERM ends
 * it.
 *
 *     host_stalls FILE
 *
 * FILE holds the largest delay of a wake-up so far [s]. A test that compares times runs host_stalls
 * in parallel and counts a delay of the program as a fault only if host_stalls was not late.
 */
#define _GNU_SOURCE
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <time.h>

static const double NAP = 1e-3; /* [s] */

static volatile sig_atomic_t is_over;

static void end(int number) {
  (void)number;
  is_over = 1;
}

static double now(void) {
  struct timespec time;
  (void)clock_gettime(CLOCK_MONOTONIC, &time);
  return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static bool write_lateness(const char *path, double seconds) {
  FILE *const file = fopen(path, "w");
  if (!file) return false;
  (void)fprintf(file, "%.6f\n", seconds);
  return fclose(file) == 0;
}

int main(int argc, char **argv) {
  const struct timespec nap = {.tv_nsec = (long)(1e9 * NAP)};
  double worst = 0;
  if (argc != 2 || !write_lateness(argv[1], worst)) return 2;
  (void)signal(SIGTERM, end);
  double last = now();
  while (!is_over) {
    (void)nanosleep(&nap, NULL);
    const double time = now(), late = time - last - NAP;
    if (late > worst && !write_lateness(argv[1], worst = late)) return 1;
    last = now(); /* writing is not the machine's fault */
  }
  return 0;
}
