/* SPDX-License-Identifier: MIT */
#include "base/interrupt.h"

#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <tabor/tabor.h>
#include <unistd.h>

#include "platform/clock.h"
#include "platform/files.h"

/* a sound for each microphone, and the trace, of every rendering */
#define GUARDS (INTERRUPT_MOST_THREADS * (TABOR_MAX_MICS + 1))

/* Globals: a handler has no other way to know. Changed under hold only. */
static const char *volatile guarded[GUARDS];

static void (*volatile at_end)(void);
static atomic_bool catches;
static atomic_int caught;

/* Who holds. A mutex is not for handlers; and a thread that holds gets no signal, so the handler
   never waits for what it has interrupted itself. */
static atomic_flag held = ATOMIC_FLAG_INIT;
static _Thread_local unsigned depth; /* of holds within holds */

static void take_hold(void) {
  const struct timespec moment = {.tv_nsec = 50000};
  while (atomic_flag_test_and_set(&held)) (void)nanosleep(&moment, NULL);
}

/* True if the program ends by itself. Several may come at once: timeout(1) sends one to the process
   and one to its group. */
static bool is_noted(int number) {
  int none = 0;
  if (!atomic_load(&catches) || signals_leave_no_time(number)) return false;
  (void)atomic_compare_exchange_strong(&caught, &none, number);
  return true;
}

/* A flag would not do: libsndfile restarts an interrupted write to a pipe that nobody reads. Runs
   in any thread, and keeps the hold, so that no other creates or renames a file any more. */
static void end(int number) {
  if (is_noted(number)) return;
  take_hold();
  if (at_end) at_end();
  for (size_t i = 0; i < GUARDS; i++) {
    if (guarded[i]) (void)file_remove(guarded[i]);
  }
  _exit(128 + number);
}

void interrupt_install(void) { signals_install(end); }

void interrupt_catch(void) { atomic_store(&catches, true); }

int interrupt_caught(void) { return atomic_load(&caught); }

void interrupt_at_end(void (*call)(void)) { at_end = call; }

void interrupt_hold(SignalMask *before) {
  signals_block(before);
  if (depth++ == 0) take_hold();
}

void interrupt_resume(const SignalMask *before) {
  if (--depth == 0) atomic_flag_clear(&held);
  signals_unblock(before);
}

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
