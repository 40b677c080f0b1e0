/* SPDX-License-Identifier: MIT */
#include <errno.h>
#include <io.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <windows.h>

#include "platform/terminal.h"

static const char screen_on[] = "\033[?1049h\033[?25l\033[2J";
static const char screen_off[] = "\033[0m\033[?25h\033[?1049l";

/* Globals: the handler of Ctrl-C has no other way to know. */
static DWORD input_before, output_before; /* written before is_ours is set */
static UINT input_page_before;
static bool wants_screen;
static atomic_bool is_ours;
static TerminalSize size_before;

static HANDLE input(void) { return GetStdHandle(STD_INPUT_HANDLE); }
static HANDLE output(void) { return GetStdHandle(STD_OUTPUT_HANDLE); }

TerminalAbilities terminal_abilities(void) {
  DWORD mode;
  const char *const no_colour = getenv("NO_COLOR");
  const bool keys = GetConsoleMode(input(), &mode) != 0;
  return (TerminalAbilities){.keys = keys,
                             .screen = keys && GetConsoleMode(output(), &mode) != 0,
                             .colour = !(no_colour && *no_colour),
                             .utf8 = true};
}

static bool take(void) {
  DWORD keys = input_before & ~(DWORD)(ENABLE_LINE_INPUT | ENABLE_ECHO_INPUT);
  keys |= ENABLE_PROCESSED_INPUT | ENABLE_VIRTUAL_TERMINAL_INPUT;
  if (!SetConsoleMode(input(), keys)) return false;
  if (!wants_screen) return true;
  const DWORD screen = output_before | ENABLE_PROCESSED_OUTPUT | ENABLE_VIRTUAL_TERMINAL_PROCESSING;
  return SetConsoleMode(output(), screen) && terminal_write(screen_on, sizeof screen_on - 1);
}

bool terminal_enter(bool screen) {
  static bool is_registered;
  if (atomic_load(&is_ours)) return true;
  wants_screen = screen;
  input_page_before = GetConsoleCP();
  if (!GetConsoleMode(input(), &input_before) ||
      (screen && !GetConsoleMode(output(), &output_before))) {
    errno = ENOTTY;
    return false;
  }
  if (!is_registered) is_registered = atexit(terminal_leave) == 0;
  atomic_store(&is_ours, true);
  (void)SetConsoleCP(CP_UTF8);
  if (take()) return true;
  terminal_leave();
  errno = EIO;
  return false;
}

void terminal_restore(void) {
  if (!atomic_exchange(&is_ours, false)) return;
  if (wants_screen) {
    (void)terminal_write(screen_off, sizeof screen_off - 1);
    (void)SetConsoleMode(output(), output_before);
  }
  (void)FlushConsoleInputBuffer(input());
  (void)SetConsoleMode(input(), input_before);
  (void)SetConsoleCP(input_page_before);
}

void terminal_leave(void) { terminal_restore(); }

static bool is_key(const INPUT_RECORD *record) {
  return record->EventType == KEY_EVENT && record->Event.KeyEvent.bKeyDown &&
         record->Event.KeyEvent.uChar.UnicodeChar != 0;
}

/* ReadFile() would wait for a key where there are only other events, as keys that go up. */
static bool has_key(void) {
  INPUT_RECORD record;
  DWORD count;
  while (PeekConsoleInputW(input(), &record, 1, &count) && count > 0) {
    if (is_key(&record)) return true;
    (void)ReadConsoleInputW(input(), &record, 1, &count);
  }
  return false;
}

ptrdiff_t terminal_read(unsigned char *bytes, size_t size, int timeout) {
  DWORD count = 0;
  const DWORD waited = WaitForSingleObject(input(), (DWORD)timeout);
  if (waited == WAIT_FAILED) return -1;
  if (waited != WAIT_OBJECT_0 || !has_key()) return 0;
  if (!ReadFile(input(), bytes, (DWORD)size, &count, NULL)) return -1;
  return (ptrdiff_t)count;
}

bool terminal_write(const char *bytes, size_t size) {
  while (size > 0) {
    DWORD count = 0;
    if (!WriteFile(output(), bytes, (DWORD)size, &count, NULL) || count == 0) return false;
    bytes += count;
    size -= count;
  }
  return true;
}

TerminalSize terminal_size(void) {
  CONSOLE_SCREEN_BUFFER_INFO info;
  if (!GetConsoleScreenBufferInfo(output(), &info)) return (TerminalSize){80, 24};
  return (TerminalSize){info.srWindow.Right - info.srWindow.Left + 1,
                        info.srWindow.Bottom - info.srWindow.Top + 1};
}

bool terminal_changed(void) {
  const TerminalSize now = terminal_size();
  const bool changed = now.columns != size_before.columns || now.rows != size_before.rows;
  size_before = now;
  return changed;
}
