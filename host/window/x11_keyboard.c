/* SPDX-License-Identifier: MIT */
#include "window/x11_keyboard.h"

#include <stdlib.h>
#include <xkbcommon/xkbcommon-x11.h>

struct X11Keyboard {
  struct xkb_context *context;
  struct xkb_keymap *keymap;
  struct xkb_state *state;
};

static bool begin(X11Keyboard *keyboard, xcb_connection_t *connection) {
  if (!xkb_x11_setup_xkb_extension(connection, XKB_X11_MIN_MAJOR_XKB_VERSION,
                                   XKB_X11_MIN_MINOR_XKB_VERSION,
                                   XKB_X11_SETUP_XKB_EXTENSION_NO_FLAGS, NULL, NULL, NULL, NULL))
    return false;
  const int32_t device = xkb_x11_get_core_keyboard_device_id(connection);
  keyboard->context = xkb_context_new(XKB_CONTEXT_NO_FLAGS);
  if (device < 0 || !keyboard->context) return false;
  keyboard->keymap = xkb_x11_keymap_new_from_device(keyboard->context, connection, device,
                                                    XKB_KEYMAP_COMPILE_NO_FLAGS);
  if (keyboard->keymap) keyboard->state = xkb_state_new(keyboard->keymap);
  return keyboard->state != NULL;
}

X11Keyboard *x11_keyboard_create(xcb_connection_t *connection) {
  X11Keyboard *const keyboard = calloc(1, sizeof *keyboard);
  if (keyboard && begin(keyboard, connection)) return keyboard;
  x11_keyboard_destroy(keyboard);
  return NULL;
}

void x11_keyboard_destroy(X11Keyboard *keyboard) {
  if (!keyboard) return;
  xkb_state_unref(keyboard->state);
  xkb_keymap_unref(keyboard->keymap);
  xkb_context_unref(keyboard->context);
  free(keyboard);
}

static Key special(xkb_keysym_t symbol) {
  switch (symbol) {
  case XKB_KEY_Escape: return KEY_ESCAPE;
  case XKB_KEY_Return:
  case XKB_KEY_KP_Enter: return KEY_ENTER;
  case XKB_KEY_BackSpace: return KEY_BACKSPACE;
  case XKB_KEY_Delete:
  case XKB_KEY_KP_Delete: return KEY_DELETE;
  case XKB_KEY_ISO_Left_Tab:
  case XKB_KEY_Up:
  case XKB_KEY_KP_Up: return KEY_UP;
  case XKB_KEY_Down:
  case XKB_KEY_KP_Down: return KEY_DOWN;
  case XKB_KEY_Left:
  case XKB_KEY_KP_Left: return KEY_LEFT;
  case XKB_KEY_Right:
  case XKB_KEY_KP_Right: return KEY_RIGHT;
  case XKB_KEY_Home:
  case XKB_KEY_KP_Home: return KEY_HOME;
  case XKB_KEY_End:
  case XKB_KEY_KP_End: return KEY_END;
  case XKB_KEY_Page_Up:
  case XKB_KEY_KP_Page_Up: return KEY_PAGE_UP;
  case XKB_KEY_Page_Down:
  case XKB_KEY_KP_Page_Down: return KEY_PAGE_DOWN;
  default: return KEY_UNKNOWN;
  }
}

/* The event has the modifiers, and the group of the layout in bits 13 and 14. With Ctrl a letter's
 * character is the control character. */
Key x11_keyboard_key(X11Keyboard *keyboard, const xcb_key_press_event_t *event) {
  if (!keyboard) return KEY_UNKNOWN;
  (void)xkb_state_update_mask(keyboard->state, event->state & 0xffu, 0, 0, 0, 0,
                              (event->state >> 13) & 3u);
  const Key key = special(xkb_state_key_get_one_sym(keyboard->state, event->detail));
  if (key != KEY_UNKNOWN) return key;
  const uint32_t character = xkb_state_key_get_utf32(keyboard->state, event->detail);
  return character > 0 ? character : KEY_UNKNOWN;
}
