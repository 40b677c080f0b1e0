/* SPDX-License-Identifier: MIT */
/**
 * @file windows_keyboard.h
 * What the messages of Windows about keys mean. A key that has a character comes twice: as a key,
 * and then as the character in the user's layout, which the host's loop makes of it.
 */
#ifndef TABOR_WINDOW_WINDOWS_KEYBOARD_H
#define TABOR_WINDOW_WINDOWS_KEYBOARD_H

#include <windows.h>

#include "base/keys.h"

typedef struct WindowsKeyboard {
  bool is_taken; /**< the newest key was none of characters: one that follows means nothing */
  WCHAR high;    /**< the first half of a character that has two, or 0 */
} WindowsKeyboard;

/** The key of WM_KEYDOWN; KEY_UNKNOWN if it is a character's, or none of keys.h. Shift with Tab is
 * KEY_UP. */
Key windows_keyboard_key(WindowsKeyboard *keyboard, WPARAM code);
/** The key of WM_CHAR; KEY_UNKNOWN if there is none, or not yet. */
Key windows_keyboard_character(WindowsKeyboard *keyboard, WPARAM unit);
bool windows_keyboard_has_shift(void);

#endif
