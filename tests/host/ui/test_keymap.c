/* SPDX-License-Identifier: MIT */
/* The usual keys, and files that change them. */
#include "ui/keymap.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

static char path[1100];

static int set_up(void **state) {
  (void)state;
  const char *const temporary = getenv("TMPDIR");
  snprintf(path, sizeof path, "%s/test_keymap.XXXXXX", temporary ? temporary : "/tmp");
  const int file = mkstemp(path);
  return file < 0 ? -1 : close(file);
}

static int tear_down(void **state) {
  (void)state;
  return unlink(path);
}

/* Reads a file with this text into @p keymap; the message comes into @p message. */
static Outcome read_text(Keymap *keymap, const char *text, char message[1000]) {
  FILE *const file = fopen(path, "wb");
  assert_non_null(file);
  assert_true(fputs(text, file) >= 0);
  assert_int_equal(fclose(file), 0);
  keymap_default(keymap);
  const MessageCapture before = message_capture(message, 1000);
  const Outcome outcome = keymap_read(path, keymap);
  message_release(before);
  return outcome;
}

static void expect(const Keymap *keymap, Key key, ActionKind kind, double value) {
  const Action action = keymap_find(keymap, key);
  if (action.kind != kind || fabs(action.value - value) > 1e-12) {
    fail_msg("key %x: action %d with %g", (unsigned)key, (int)action.kind, action.value);
  }
}

static void zones_go_from_the_centre_to_the_rim(void **state) {
  (void)state;
  Keymap keymap;
  keymap_default(&keymap);
  const char *const strokes = "asdfghjkl", *const ghosts = "qwertyuio";
  double last = -1;
  for (int i = 0; i < 9; i++) {
    const Action stroke = keymap_find(&keymap, (Key)strokes[i]);
    assert_int_equal(stroke.kind, ACTION_STROKE);
    assert_true(stroke.value > last && stroke.value <= 1);
    last = stroke.value;
    expect(&keymap, (Key)ghosts[i], ACTION_GHOST, stroke.value);
  }
  expect(&keymap, 'a', ACTION_STROKE, 0);
  expect(&keymap, 'l', ACTION_STROKE, 0.92);
  expect(&keymap, 'p', ACTION_GHOST, 0.92);
}

static void digits_are_speeds_in_ratios(void **state) {
  (void)state;
  Keymap keymap;
  keymap_default(&keymap);
  expect(&keymap, '1', ACTION_SPEED, 0.5);
  expect(&keymap, '9', ACTION_SPEED, 8);
  for (Key digit = '1'; digit < '9'; digit++) {
    const double ratio = keymap_find(&keymap, digit + 1).value / keymap_find(&keymap, digit).value;
    assert_true(fabs(ratio / sqrt(2.0) - 1) < 0.01); /* they are written with two decimals */
  }
  expect(&keymap, '0', ACTION_NONE, 0);
}

static void the_other_keys_do_what_is_documented(void **state) {
  (void)state;
  Keymap keymap;
  keymap_default(&keymap);
  const struct {
    Key key;
    const char *technique;
  } techniques[] = {{'z', "rimshot"}, {'x', "cross-stick"}, {'c', "rim"}, {'v', "buzz"}};
  for (int i = 0; i < 4; i++) {
    expect(&keymap, techniques[i].key, ACTION_TECHNIQUE, 0);
    assert_string_equal(keymap_find(&keymap, techniques[i].key).text, techniques[i].technique);
  }
  expect(&keymap, ' ', ACTION_REPEAT, 0);
  expect(&keymap, 'b', ACTION_SNARES, 0);
  expect(&keymap, 'n', ACTION_MUFFLE, 0);
  expect(&keymap, '[', ACTION_PRESET, -1);
  expect(&keymap, ']', ACTION_PRESET, 1);
  expect(&keymap, '+', ACTION_GAIN, 1);
  expect(&keymap, '-', ACTION_GAIN, -1);
  expect(&keymap, ':', ACTION_COMMAND, 0);
  expect(&keymap, '?', ACTION_HELP, 0);
  expect(&keymap, KEY_CTRL('c'), ACTION_QUIT, 0);
  expect(&keymap, KEY_UNKNOWN, ACTION_NONE, 0);
  expect(&keymap, KEY_UP, ACTION_NONE, 0);
}

static void files_change_keys(void **state) {
  (void)state;
  Keymap keymap;
  char message[1000];
  const Outcome outcome =
    read_text(&keymap,
              "; mine\n[keys]\na = stroke 50%\nf1=:preset tom-12 ; a command\n"
              "semicolon = ghost 12.5%\nspace = none\n\xc3\xa9 = buzz\n"
              "up = gain 0.5\npage-down = preset next\n0 = speed 12\n",
              message);
  assert_string_equal(message, "");
  assert_int_equal(outcome, OUTCOME_OK);
  expect(&keymap, 'a', ACTION_STROKE, 0.5);
  expect(&keymap, 's', ACTION_STROKE, 0.115);
  expect(&keymap, KEY_F1, ACTION_RUN, 0);
  assert_string_equal(keymap_find(&keymap, KEY_F1).text, "preset tom-12");
  expect(&keymap, ';', ACTION_GHOST, 0.125);
  expect(&keymap, ' ', ACTION_NONE, 0);
  expect(&keymap, 0xe9, ACTION_TECHNIQUE, 0);
  expect(&keymap, KEY_UP, ACTION_GAIN, 0.5);
  expect(&keymap, KEY_PAGE_DOWN, ACTION_PRESET, 1);
  expect(&keymap, '0', ACTION_SPEED, 12);
}

static void keys_of_an_action_are_listed(void **state) {
  (void)state;
  Keymap keymap;
  char text[100], message[1000];
  keymap_default(&keymap);
  assert_int_equal(keymap_list(&keymap, ACTION_STROKE, text, sizeof text), 9);
  assert_string_equal(text, "a s d f g h j k l");
  assert_int_equal(keymap_list(&keymap, ACTION_REPEAT, text, sizeof text), 1);
  assert_string_equal(text, "space");
  assert_int_equal(keymap_list(&keymap, ACTION_RUN, text, sizeof text), 0);
  assert_string_equal(text, "");
  assert_int_equal(keymap_list(&keymap, ACTION_STROKE, text, 4), 9); /* cut, not overflown */
  assert_string_equal(text, "a s");
  assert_int_equal(read_text(&keymap, "[keys]\ns = none\nf2 = stroke 1%\n", message), OUTCOME_OK);
  keymap_list(&keymap, ACTION_STROKE, text, sizeof text);
  assert_string_equal(text, "a d f g h j k l f2");
}

static void wrong_files_are_refused(void **state) {
  (void)state;
  const struct {
    const char *text, *message;
  } wrong[] = {
    {"[keys]\nfoo = stroke 1%\n", ":2: unknown key 'foo'; allowed: a character, space"},
    {"[keys]\na = strok 1%\n", ":2: 'a = strok 1%': unknown action; did you mean 'stroke'?"},
    {"[keys]\na = fly\n", "unknown action; there are: none, stroke"},
    {"[keys]\na =\n", "unknown action"},
    {"[keys]\na = stroke\n", "its place is missing; allowed: 0% to 100%"},
    {"[keys]\na = stroke 5\n", "its place is missing"},
    {"[keys]\na = stroke 101%\n", "place in per cent '101': out of range; allowed: 0 to 100"},
    {"[keys]\na = ghost nan%\n", "not a number"},
    {"[keys]\na = speed 31\n", "speed '31': out of range; allowed: 0.01 to 30"},
    {"[keys]\na = speed\n", "speed '': not a number"},
    {"[keys]\na = gain 25\n", "gain '25': out of range; allowed: -24 to 24"},
    {"[keys]\na = repeat 2\n", "'a = repeat 2': nothing may follow this action"},
    {"[keys]\na = rimshot 2\n", "nothing may follow"},
    {"[keys]\na = preset\n", "allowed: preset next, preset previous"},
    {"[keys]\na = :\n", "no command follows the ':'"},
    {"[keys]\na = :gian 3\n", ":2: 'a = :gian 3': unknown command 'gian'; did you mean 'gain'?"},
    {"[keys]\na = :set\n", "'a = :set': set needs more: set KEY VALUE"},
    {"[keys]\na = : quit now\n", "nothing may follow 'quit'"},
    {"[keys]\nescape = quit\n", "'escape' always quits"},
    {"[keys]\nctrl-c = none\n", "'ctrl-c' always quits"},
    {"[key]\na = repeat\n", ":1: unknown section [key]; allowed: [keys]"},
    {"a = repeat\n", ":1: 'a' stands before the first section"},
    {"[keys]\na = repeat\na = none\n", ":3: 'a' occurs twice"},
    {"[keys]\n a = repeat\n", ":2: the line is indented"},
    {"[keys]\n; = repeat\nb\n", ":3: 'b' is neither"},
    {"[keys]\na = repeat", "the last line has no line end"},
    {"", "the file holds no section"},
  };
  for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
    static Keymap keymap;
    char message[1000];
    assert_int_equal(read_text(&keymap, wrong[i].text, message), OUTCOME_REFUSED);
    if (!strstr(message, wrong[i].message) || strncmp(message, "--keys: ", 8) != 0) {
      fail_msg("'%s': %s", wrong[i].text, message);
    }
  }
}

static void missing_files_fail(void **state) {
  (void)state;
  static Keymap keymap;
  char message[1000];
  const MessageCapture before = message_capture(message, sizeof message);
  assert_int_equal(keymap_read("/nowhere/keys.ini", &keymap), OUTCOME_FAILED);
  message_release(before);
  assert_string_equal(message, "--keys: /nowhere/keys.ini: No such file or directory");
}

static void too_many_keys_are_refused(void **state) {
  (void)state;
  static Keymap keymap;
  static char text[40000];
  char message[1000], name[5] = "";
  strcpy(text, "[keys]\n");
  for (uint32_t point = 0x4e00; point < 0x4e00 + MOST_KEYS; point++) {
    name[utf8_write(point, name)] = '\0';
    strcat(strcat(text, name), " = repeat\n");
  }
  assert_int_equal(read_text(&keymap, text, message), OUTCOME_REFUSED);
  assert_non_null(strstr(message, "too many keys; allowed: up to 256"));
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(zones_go_from_the_centre_to_the_rim),
    cmocka_unit_test(digits_are_speeds_in_ratios),
    cmocka_unit_test(the_other_keys_do_what_is_documented),
    cmocka_unit_test(files_change_keys),
    cmocka_unit_test(keys_of_an_action_are_listed),
    cmocka_unit_test(wrong_files_are_refused),
    cmocka_unit_test(missing_files_fail),
    cmocka_unit_test(too_many_keys_are_refused),
  };
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
