/* SPDX-License-Identifier: MIT */
#include "window/windows_keyboard.h"

bool windows_keyboard_has_shift(void) { return GetKeyState(VK_SHIFT) < 0; }

static Key special(WPARAM code) {
  switch (code) {
  case VK_ESCAPE: return KEY_ESCAPE;
  case VK_RETURN: return KEY_ENTER;
  case VK_BACK: return KEY_BACKSPACE;
  case VK_DELETE: return KEY_DELETE;
  case VK_TAB: return windows_keyboard_has_shift() ? KEY_UP : KEY_TAB;
  case VK_UP: return KEY_UP;
  case VK_DOWN: return KEY_DOWN;
  case VK_LEFT: return KEY_LEFT;
  case VK_RIGHT: return KEY_RIGHT;
  case VK_HOME: return KEY_HOME;
  case VK_END: return KEY_END;
  case VK_PRIOR: return KEY_PAGE_UP;
  case VK_NEXT: return KEY_PAGE_DOWN;
  default: return KEY_UNKNOWN;
  }
}

Key windows_keyboard_key(WindowsKeyboard *keyboard, WPARAM code) {
  const Key key = special(code);
  keyboard->is_taken = key != KEY_UNKNOWN;
  return key;
}

/* With Ctrl a letter's character is the control character. */
Key windows_keyboard_character(WindowsKeyboard *keyboard, WPARAM unit) {
  const WCHAR high = keyboard->high, half = (WCHAR)unit;
  keyboard->high = IS_HIGH_SURROGATE(half) ? half : 0;
  if (keyboard->is_taken || half == 0 || IS_HIGH_SURROGATE(half)) return KEY_UNKNOWN;
  if (!IS_LOW_SURROGATE(half)) return half;
  return high ? 0x10000u + ((high & 0x3ffu) << 10 | (half & 0x3ffu)) : KEY_UNKNOWN;
}
