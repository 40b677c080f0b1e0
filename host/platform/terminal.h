/* SPDX-License-Identifier: MIT */
/**
 * @file terminal.h
 * Terminal input and output during play: keys come singly and without echo, and a full screen can
 * be drawn. However the program ends or is suspended, also by signals and failed assertions, the
 * terminal's earlier settings and screen are restored.
 *
 * The state is global: there is one terminal per process. One thread uses these functions; any
 * thread and signal handlers may call terminal_restore().
 */
#ifndef TABOR_HOST_TERMINAL_H
#define TABOR_HOST_TERMINAL_H

#include <stdbool.h>
#include <stddef.h>

/** Abilities of the standard streams. */
typedef struct TerminalAbilities {
  bool keys;   /**< standard input is a terminal, with this process in the foreground */
  bool screen; /**< so is standard output, and its cursor can be moved */
  bool colour; /**< NO_COLOR is not set */
  bool utf8;   /**< the user's locale has UTF-8 */
} TerminalAbilities;

typedef struct TerminalSize {
  int columns, rows; /**< at least 1 each */
} TerminalSize;

TerminalAbilities terminal_abilities(void);

/**
 * Switches to single keys and, with @p screen, to an empty screen with a hidden cursor. Requires
 * TerminalAbilities.keys. False, with errno, if the settings cannot be changed. Installs handlers
 * for SIGTSTP, SIGCONT, SIGWINCH and the signals of crashes; for signals that end the program, give
 * terminal_restore() to interrupt_at_end().
 */
bool terminal_enter(bool screen);
/** Undoes terminal_enter(). May be called at any time, also twice. */
void terminal_leave(void);
/** Restores the settings and the screen of the terminal at once. Async-signal-safe. */
void terminal_restore(void);

/**
 * Waits up to @p timeout milliseconds for keys. Returns the number of bytes read; 0 if none came in
 * that time, or in the background; -1 once the terminal is gone.
 */
ptrdiff_t terminal_read(unsigned char *bytes, size_t size, int timeout);
/**
 * Writes @p bytes to the terminal without waiting for it. False if not all bytes were written, also
 * in the background.
 */
bool terminal_write(const char *bytes, size_t size);
TerminalSize terminal_size(void);
/** True, once, if the screen must be redrawn: the size changed, or the process was suspended. */
bool terminal_changed(void);

#endif
