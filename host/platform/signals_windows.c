/* SPDX-License-Identifier: MIT */
#include <windows.h>

#include "platform/signals.h"

#define HANG_UP 1
#define QUIT 3
/* [ms]: how long Windows lets a program live whose console is being closed */
#define PATIENCE 5000

static void (*volatile end_program)(int number); /* a handler has no other way to know */

static int number_of(DWORD event) {
  switch (event) {
  case CTRL_C_EVENT: return SIGINT;
  case CTRL_BREAK_EVENT: return QUIT;
  case CTRL_CLOSE_EVENT: return HANG_UP;
  default: return SIGTERM;
  }
}

/* After any but the first two Windows ends the program as soon as this returns. */
static BOOL WINAPI on_event(DWORD event) {
  end_program(number_of(event));
  if (event != CTRL_C_EVENT && event != CTRL_BREAK_EVENT) Sleep(PATIENCE);
  return TRUE;
}

void signals_install(void (*end)(int number)) {
  end_program = end;
  (void)SetConsoleCtrlHandler(on_event, TRUE);
}

bool signals_leave_no_time(int number) {
  (void)number;
  return false;
}

void signals_block(SignalMask *before) { *before = 0; }

void signals_unblock(const SignalMask *before) { (void)before; }

void signals_take_abort(void (*handler)(int number), SignalHandler *before) {
  before->function = signal(SIGABRT, handler);
}

void signals_restore_abort(const SignalHandler *before) { (void)signal(SIGABRT, before->function); }
