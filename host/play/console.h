/* SPDX-License-Identifier: MIT */
/**
 * @file console.h
 * The computer keyboard and the screen of `tabor play`.
 *
 * The keys play while standard input is a terminal. The screen is drawn if standard output is a
 * terminal as well. Otherwise, or with --no-ui, messages are printed line by line.
 */
#ifndef TABOR_HOST_CONSOLE_H
#define TABOR_HOST_CONSOLE_H

#include "play/live_session.h"

typedef struct Console Console;

/** Takes over the terminal for an open live session. *created is valid or NULL, whatever the
 * outcome. */
Outcome console_open(LiveSession *session, Console **created);
/** One turn of the user's thread (LiveSessionTurn). False: the user wants to stop. */
bool console_turn(void *console);
/** Restores the terminal. NULL is allowed. */
void console_close(Console *console);

#endif
