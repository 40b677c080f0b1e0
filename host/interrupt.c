/* SPDX-License-Identifier: MIT */
#include "interrupt.h"

#include <stddef.h>
#include <tabor/tabor.h>
#include <unistd.h>

#define GUARDS (TABOR_MAX_MICS + 1) /* a sound for each microphone, and the trace */

static const int fatal_signals[] = {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGXCPU};
#define FATAL_SIGNALS (sizeof fatal_signals / sizeof fatal_signals[0])

/* The only globals of the program: a handler has no other way to know. Changed under hold only. */
static const char *volatile guarded[GUARDS];

/* A flag would not do: libsndfile restarts an interrupted write to a pipe that nobody reads. */
static void end(int number) {
  for (size_t i = 0; i < GUARDS; i++) {
    if (guarded[i]) (void)unlink(guarded[i]);
  }
  _exit(128 + number);
}

static void fatal_set(sigset_t *set) {
  sigemptyset(set);
  for (size_t i = 0; i < FATAL_SIGNALS; i++) sigaddset(set, fatal_signals[i]);
}

void interrupt_install(void) {
  struct sigaction action = {.sa_handler = end};
  fatal_set(&action.sa_mask);
  for (size_t i = 0; i < FATAL_SIGNALS; i++) {
    struct sigaction before;
    /* nohup ignores SIGHUP; shells ignore SIGINT in background jobs, but not for this purpose */
    const int number = fatal_signals[i];
    if (number == SIGHUP && sigaction(number, NULL, &before) == 0 && before.sa_handler == SIG_IGN) {
      continue;
    }
    (void)sigaction(number, &action, NULL);
  }
  const struct sigaction ignore = {.sa_handler = SIG_IGN};
  (void)sigaction(SIGPIPE, &ignore, NULL);
  (void)sigaction(SIGXFSZ, &ignore, NULL);
}

void interrupt_hold(sigset_t *before) {
  sigset_t set;
  fatal_set(&set);
  (void)sigprocmask(SIG_BLOCK, &set, before);
}

void interrupt_resume(const sigset_t *before) { (void)sigprocmask(SIG_SETMASK, before, NULL); }

void interrupt_guard(const char *path) {
  for (size_t i = 0; i < GUARDS; i++) {
    if (!guarded[i]) {
      guarded[i] = path;
      return;
    }
  }
}

void interrupt_unguard(const char *path) {
  for (size_t i = 0; i < GUARDS; i++) {
    if (guarded[i] == path) guarded[i] = NULL;
  }
}
