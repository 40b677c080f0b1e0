/* SPDX-License-Identifier: MIT */
/**
 * @file x11_keyboard.h
 * What the keys of an X11 server mean, in the user's layout, by libxkbcommon.
 */
#ifndef TABOR_WINDOW_X11_KEYBOARD_H
#define TABOR_WINDOW_X11_KEYBOARD_H

#include <xcb/xcb.h>

#include "base/keys.h"

typedef struct X11Keyboard X11Keyboard;

/** NULL if the server has no keyboard extension, or memory is short. */
X11Keyboard *x11_keyboard_create(xcb_connection_t *connection);
/** Ignores NULL. */
void x11_keyboard_destroy(X11Keyboard *keyboard);
/** The key of a press; KEY_UNKNOWN if it is none of keys.h, and with @p keyboard NULL. Shift with
 * Tab is KEY_UP. */
Key x11_keyboard_key(X11Keyboard *keyboard, const xcb_key_press_event_t *event);

#endif
