/* SPDX-License-Identifier: MIT */
#include "base/line_editor.h"

#include <stdio.h>
#include <string.h>

static bool is_continuation(char byte) { return ((unsigned char)byte & 0xC0u) == 0x80u; }

static size_t before(const LineEditor *editor, size_t place) {
  if (place > 0) place--;
  while (place > 0 && is_continuation(editor->text[place])) place--;
  return place;
}

static size_t behind(const LineEditor *editor, size_t place) {
  if (place < editor->length) place++;
  while (place < editor->length && is_continuation(editor->text[place])) place++;
  return place;
}

static size_t word_before(const LineEditor *editor, size_t place) {
  while (place > 0 && editor->text[place - 1] == ' ') place--;
  while (place > 0 && editor->text[place - 1] != ' ') place--;
  return place;
}

/* Bytes from start on to end; the cursor is left at start. */
static void erase(LineEditor *editor, size_t start, size_t end) {
  memmove(editor->text + start, editor->text + end, editor->length - end + 1);
  editor->length -= end - start;
  editor->cursor = start;
}

static void insert(LineEditor *editor, const char *bytes, size_t count) {
  if (editor->length + count >= LINE_SIZE) return;
  char *const place = editor->text + editor->cursor;
  memmove(place + count, place, editor->length - editor->cursor + 1);
  memcpy(place, bytes, count);
  editor->length += count;
  editor->cursor += count;
}

static void set_text(LineEditor *editor, const char *text) {
  (void)snprintf(editor->text, sizeof editor->text, "%s", text);
  editor->length = editor->cursor = strlen(editor->text);
}

static void recall(LineEditor *editor, size_t lines_back) {
  if (lines_back > editor->history_count) return;
  if (editor->recalled == 0) memcpy(editor->typed, editor->text, sizeof editor->typed);
  editor->recalled = lines_back;
  const size_t line = editor->history_count - lines_back;
  set_text(editor, lines_back == 0 ? editor->typed : editor->history[line]);
}

static bool is_newest(const LineEditor *editor) {
  const size_t count = editor->history_count;
  return count > 0 && strcmp(editor->history[count - 1], editor->text) == 0;
}

static void remember(LineEditor *editor) {
  if (editor->length == 0 || is_newest(editor)) return;
  if (editor->history_count == LINE_HISTORY) {
    editor->history_count--;
    memmove(editor->history[0], editor->history[1], sizeof editor->history - LINE_SIZE);
  }
  memcpy(editor->history[editor->history_count++], editor->text, LINE_SIZE);
}

void line_editor_begin(LineEditor *editor) {
  set_text(editor, "");
  editor->recalled = 0;
}

void line_editor_replace(LineEditor *editor, size_t start, const char *text) {
  erase(editor, start, editor->cursor);
  insert(editor, text, strlen(text));
}

static void take_character(LineEditor *editor, Key key) {
  char bytes[4];
  const bool is_control = key < ' ' || (key >= 0x7f && key < 0xa0);
  if (key < KEY_UNKNOWN && !is_control) insert(editor, bytes, utf8_write(key, bytes));
}

static void edit(LineEditor *editor, Key key) {
  const size_t cursor = editor->cursor;
  switch (key) {
  case KEY_LEFT: editor->cursor = before(editor, cursor); break;
  case KEY_RIGHT: editor->cursor = behind(editor, cursor); break;
  case KEY_CTRL('a'):
  case KEY_HOME: editor->cursor = 0; break;
  case KEY_CTRL('e'):
  case KEY_END: editor->cursor = editor->length; break;
  case KEY_BACKSPACE: erase(editor, before(editor, cursor), cursor); break;
  case KEY_DELETE: erase(editor, cursor, behind(editor, cursor)); break;
  case KEY_CTRL('k'): erase(editor, cursor, editor->length); break;
  case KEY_CTRL('u'): erase(editor, 0, cursor); break;
  case KEY_CTRL('w'): erase(editor, word_before(editor, cursor), cursor); break;
  case KEY_UP: recall(editor, editor->recalled + 1); break;
  case KEY_DOWN:
    if (editor->recalled > 0) recall(editor, editor->recalled - 1);
    break;
  default: take_character(editor, key);
  }
}

LineOutcome line_editor_take(LineEditor *editor, Key key) {
  if (key == KEY_ESCAPE || key == KEY_CTRL('c') || key == KEY_CTRL('g')) return LINE_GIVEN_UP;
  if (key == KEY_BACKSPACE && editor->length == 0) return LINE_GIVEN_UP;
  if (key == KEY_ENTER) {
    remember(editor);
    return LINE_DONE;
  }
  edit(editor, key);
  return LINE_EDITING;
}
