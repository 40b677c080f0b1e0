/* SPDX-License-Identifier: MIT */
/**
 * @file console.h
 * The computer keyboard and the screen of `tabor play`.
 *
 * Keys are played while the standard input is a terminal, and the screen is drawn where the standard output is
 * one as well; otherwise, or with --no-ui, lines say what happens.
 */
#ifndef TABOR_HOST_CONSOLE_H
#define TABOR_HOST_CONSOLE_H

#include "play/live_session.h"

typedef struct Console Console;

/** Takes the terminal, for a live session that is open. *created is valid, if not NULL, whatever the outcome. */
Outcome console_open(LiveSession *session, Console **created);
/** What the user's thread does again and again (LiveSessionTurn). False: the user wants to stop. */
bool console_turn(void *console);
/** Gives the terminal back. NULL is allowed. */
void console_close(Console *console);

#endif
