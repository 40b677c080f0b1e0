/* SPDX-License-Identifier: MIT */
/**
 * @file terminal.h
 * The terminal while somebody plays on it: keys come one by one and unechoed, and a full screen may be
 * drawn. However the program ends or is suspended, by signals and failed assertions too, the terminal
 * is as it was before.
 *
 * One terminal, of one process: what is entered lies in this module. One thread uses it; terminal_restore()
 * may be called by any, and by signal handlers.
 */
#ifndef TABOR_HOST_TERMINAL_H
#define TABOR_HOST_TERMINAL_H

#include <stdbool.h>
#include <stddef.h>

#include "base/message.h"

/** What the standard streams are good for. */
typedef struct TerminalAbilities {
  bool keys;   /**< the standard input is a terminal, and this process is in its foreground */
  bool screen; /**< so is the standard output, and a cursor can be moved on it */
  bool colour; /**< NO_COLOR is not set */
  bool utf8;   /**< the user's locale has UTF-8 */
} TerminalAbilities;

typedef struct TerminalSize {
  int columns, rows; /**< at least 1 each */
} TerminalSize;

TerminalAbilities terminal_abilities(void);

/**
 * Switches to single keys and, with @p screen, to an empty screen whose cursor is hidden. Needs
 * TerminalAbilities.keys. SIGTSTP, SIGCONT, SIGWINCH and those of crashes are handled from now on; signals
 * that end the program are interrupt.h's, which restores the terminal, too.
 */
Outcome terminal_enter(bool screen);
/** Leaves everything as it was before terminal_enter(). May be called at any time, also twice. */
void terminal_leave(void);
/** Gives the terminal its settings and its screen back, at once. Async-signal-safe. */
void terminal_restore(void);

/**
 * Waits up to @p timeout milliseconds for keys. Returns the bytes read; 0 for none in that time, or while
 * this process is in the background; -1 once the terminal is gone.
 */
ptrdiff_t terminal_read(unsigned char *bytes, size_t size, int timeout);
/**
 * Shows @p bytes. Does not wait for a terminal that takes nothing: returns false if not all was shown, also
 * in the background.
 */
bool terminal_write(const char *bytes, size_t size);
TerminalSize terminal_size(void);
/** True once after everything is to be drawn anew: the size changed, or the process was suspended. */
bool terminal_changed(void);

#endif
