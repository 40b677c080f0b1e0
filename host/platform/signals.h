/* SPDX-License-Identifier: MIT */
/**
 * @file signals.h
 * What ends a program from outside: signals on POSIX; on Windows Ctrl-C, Ctrl-Break, closing the
 * console and logging off, which have the numbers of SIGINT, SIGQUIT, SIGHUP and SIGTERM.
 */
#ifndef TABOR_HOST_SIGNALS_H
#define TABOR_HOST_SIGNALS_H

#include <signal.h>
#include <stdbool.h>

#ifdef _WIN32
typedef int SignalMask;
typedef struct SignalHandler {
  void (*function)(int number);
} SignalHandler;
#else
typedef sigset_t SignalMask;
typedef struct SignalHandler {
  struct sigaction action;
} SignalHandler;
#endif

/**
 * Lets @p end be called with the number of what would end the program. On POSIX it runs in any
 * thread that does not block these signals, with them blocked; on Windows in a thread of its own.
 * Also lets writing to a closed pipe, or beyond a limit, be an error of the write.
 */
void signals_install(void (*end)(int number));
/** True if there is no time to end in good order after this one. */
bool signals_leave_no_time(int number);

/** Keeps these signals from this thread until signals_unblock(). Windows delivers none to it. */
void signals_block(SignalMask *before);
void signals_unblock(const SignalMask *before);

/** Sets the handler of SIGABRT, until signals_restore_abort(). */
void signals_take_abort(void (*handler)(int number), SignalHandler *before);
void signals_restore_abort(const SignalHandler *before);

#endif
