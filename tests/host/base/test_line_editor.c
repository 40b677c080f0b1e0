/* SPDX-License-Identifier: MIT */
/* Typing a line: moving, erasing, earlier lines, characters of several bytes. */
#include "base/line_editor.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

static LineEditor editor;

static int begin(void **state) {
  (void)state;
  memset(&editor, 0, sizeof editor);
  line_editor_begin(&editor);
  return 0;
}

/* Types ASCII; '<' '>' are the cursor keys, '|' Enter, '^' '_' up and down, '\b' Backspace. */
static LineOutcome type(const char *keys) {
  LineOutcome outcome = LINE_EDITING;
  for (; *keys; keys++) {
    Key key = (Key)*keys;
    if (*keys == '<') key = KEY_LEFT;
    if (*keys == '>') key = KEY_RIGHT;
    if (*keys == '|') key = KEY_ENTER;
    if (*keys == '^') key = KEY_UP;
    if (*keys == '_') key = KEY_DOWN;
    if (*keys == '\b') key = KEY_BACKSPACE;
    outcome = line_editor_take(&editor, key);
  }
  return outcome;
}

static void expect(const char *text, size_t cursor) {
  assert_string_equal(editor.text, text);
  assert_int_equal(editor.length, strlen(text));
  assert_int_equal(editor.cursor, cursor);
}

static void what_is_typed_stands_there(void **state) {
  (void)state;
  assert_int_equal(type("set a 1"), LINE_EDITING);
  expect("set a 1", 7);
  type("<<<<x");
  expect("setx a 1", 4);
  assert_int_equal(type("|"), LINE_DONE);
  expect("setx a 1", 4);
}

static void keys_erase(void **state) {
  (void)state;
  type("one two three\b");
  expect("one two thre", 12);
  line_editor_take(&editor, KEY_CTRL('w'));
  expect("one two ", 8);
  line_editor_take(&editor, KEY_CTRL('w'));
  expect("one ", 4);
  line_editor_take(&editor, KEY_HOME);
  line_editor_take(&editor, KEY_DELETE);
  expect("ne ", 0);
  type(">");
  line_editor_take(&editor, KEY_CTRL('k'));
  expect("n", 1);
  type("abc<");
  line_editor_take(&editor, KEY_CTRL('u'));
  expect("c", 0);
  type("\b<<");
  expect("c", 0);
  line_editor_take(&editor, KEY_CTRL('e'));
  line_editor_take(&editor, KEY_DELETE);
  type(">>");
  expect("c", 1);
}

static void characters_of_several_bytes_are_one(void **state) {
  (void)state;
  line_editor_take(&editor, 0xe9);
  line_editor_take(&editor, 0x1f941);
  line_editor_take(&editor, 'x');
  expect("\xc3\xa9\xf0\x9f\xa5\x81x", 7);
  type("<<");
  expect("\xc3\xa9\xf0\x9f\xa5\x81x", 2);
  line_editor_take(&editor, KEY_DELETE);
  expect("\xc3\xa9x", 2);
  type("\b");
  expect("x", 0);
}

static void keys_that_are_no_characters_are_passed_over(void **state) {
  (void)state;
  const Key keys[] = {KEY_UNKNOWN, KEY_F1, KEY_INSERT, KEY_CTRL('q'), 0x85, KEY_TAB, KEY_PAGE_UP};
  for (size_t i = 0; i < sizeof keys / sizeof keys[0]; i++) {
    assert_int_equal(line_editor_take(&editor, keys[i]), LINE_EDITING);
  }
  expect("", 0);
}

static void some_keys_give_up(void **state) {
  (void)state;
  type("abc");
  assert_int_equal(line_editor_take(&editor, KEY_ESCAPE), LINE_GIVEN_UP);
  line_editor_begin(&editor);
  assert_int_equal(line_editor_take(&editor, KEY_BACKSPACE), LINE_GIVEN_UP);
  assert_int_equal(line_editor_take(&editor, KEY_CTRL('c')), LINE_GIVEN_UP);
  line_editor_begin(&editor);
  type("^");
  expect("", 0); /* what was given up is not remembered */
}

static void earlier_lines_come_back(void **state) {
  (void)state;
  const char *const lines[] = {"one|", "two|", "two|",
                               "|"}; /* repeated and empty ones are not kept */
  for (int i = 0; i < 4; i++) {
    line_editor_begin(&editor);
    type(lines[i]);
  }
  line_editor_begin(&editor);
  type("new^");
  expect("two", 3);
  type("^");
  expect("one", 3);
  type("^^");
  expect("one", 3);
  type("_");
  expect("two", 3);
  type("_");
  expect("new", 3);
  type("_");
  expect("new", 3);
  type("^\b\b");
  expect("t", 1);
  type("|");
  line_editor_begin(&editor);
  type("^");
  expect("t", 1);
  type("^"); /* a changed line is a new one; the old stays */
  expect("two", 3);
}

static void history_and_lines_have_an_end(void **state) {
  (void)state;
  for (int i = 0; i < LINE_HISTORY + 10; i++) {
    char line[20];
    snprintf(line, sizeof line, "%d|", i);
    line_editor_begin(&editor);
    type(line);
  }
  line_editor_begin(&editor);
  for (int i = 0; i < 2 * LINE_HISTORY; i++) type("^");
  expect("10", 2);
  line_editor_begin(&editor);
  for (int i = 0; i < 2 * LINE_SIZE; i++) line_editor_take(&editor, 0x20ac);
  assert_true(editor.length < LINE_SIZE && editor.length % 3 == 0);
}

static void words_are_replaced(void **state) {
  (void)state;
  type("set wir x<<");
  line_editor_replace(&editor, 4, "wires.tension");
  expect("set wires.tension x", 17);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test_setup(what_is_typed_stands_there, begin),
    cmocka_unit_test_setup(keys_erase, begin),
    cmocka_unit_test_setup(characters_of_several_bytes_are_one, begin),
    cmocka_unit_test_setup(keys_that_are_no_characters_are_passed_over, begin),
    cmocka_unit_test_setup(some_keys_give_up, begin),
    cmocka_unit_test_setup(earlier_lines_come_back, begin),
    cmocka_unit_test_setup(history_and_lines_have_an_end, begin),
    cmocka_unit_test_setup(words_are_replaced, begin),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
