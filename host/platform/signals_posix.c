/* SPDX-License-Identifier: MIT */
#include <pthread.h>
#include <stddef.h>

#include "platform/signals.h"

static const int fatal_signals[] = {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGXCPU};
#define FATAL_SIGNALS (sizeof fatal_signals / sizeof fatal_signals[0])

static void fatal_set(sigset_t *set) {
  sigemptyset(set);
  for (size_t i = 0; i < FATAL_SIGNALS; i++) sigaddset(set, fatal_signals[i]);
}

void signals_install(void (*end)(int number)) {
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

bool signals_leave_no_time(int number) { return number == SIGXCPU; }

void signals_block(SignalMask *before) {
  sigset_t set;
  fatal_set(&set);
  (void)pthread_sigmask(SIG_BLOCK, &set, before);
}

void signals_unblock(const SignalMask *before) { (void)pthread_sigmask(SIG_SETMASK, before, NULL); }

void signals_take_abort(void (*handler)(int number), SignalHandler *before) {
  const struct sigaction action = {.sa_handler = handler};
  (void)sigaction(SIGABRT, &action, &before->action);
}

void signals_restore_abort(const SignalHandler *before) {
  (void)sigaction(SIGABRT, &before->action, NULL);
}
