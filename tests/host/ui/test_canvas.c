/* SPDX-License-Identifier: MIT */
/* What is drawn comes to be shown, by as few bytes as it takes; judged by a small terminal of the
 * test's. */
#include "ui/canvas.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "base/keys.h"

/* A terminal that knows the sequences which canvas.c uses, and fails at others. */
typedef struct Terminal {
  Cell cells[CANVAS_ROWS][CANVAS_COLUMNS];
  int row, column, columns, rows;
  char style[16]; /* of what is written: parameters of the last SGR */
  char styles[CANVAS_ROWS][CANVAS_COLUMNS][16];
} Terminal;

static Canvas canvas;
static Terminal terminal;
static char bytes[CANVAS_BYTES];
static size_t byte_count;

static void clear(void) {
  for (int row = 0; row < CANVAS_ROWS; row++) {
    for (int column = 0; column < CANVAS_COLUMNS; column++) {
      terminal.cells[row][column].point = ' ';
      strcpy(terminal.styles[row][column], "0");
    }
  }
}

static const char *obey(const char *text) {
  char parameters[16] = "";
  size_t length = strspn(text, "0123456789;");
  assert_true(length < sizeof parameters);
  memcpy(parameters, text, length);
  switch (text[length]) {
  case 'm': strcpy(terminal.style, parameters); break;
  case 'J': clear(); break;
  case 'H':
    assert_int_equal(sscanf(parameters, "%d;%d", &terminal.row, &terminal.column), 2);
    terminal.row--;
    terminal.column--;
    break;
  default: fail_msg("unknown sequence %s", text);
  }
  return text + length + 1;
}

static void receive(const char *text, size_t count) {
  const char *const end = text + count;
  while (text < end) {
    if (text[0] == '\033') {
      assert_int_equal(text[1], '[');
      text = obey(text + 2);
      continue;
    }
    uint32_t point = 0;
    const size_t length = utf8_read(text, &point);
    assert_true(length > 0);
    assert_in_range(terminal.row, 0, canvas.rows - 1);
    assert_in_range(terminal.column, 0, canvas.columns - 1);
    terminal.cells[terminal.row][terminal.column].point = point;
    strcpy(terminal.styles[terminal.row][terminal.column++], terminal.style);
    text += length;
  }
}

static void update(void) {
  byte_count = canvas_update(&canvas, bytes);
  bytes[byte_count] = '\0';
  receive(bytes, byte_count);
  for (int row = 0; row < canvas.rows; row++) {
    for (int column = 0; column < canvas.columns; column++) {
      assert_int_equal(terminal.cells[row][column].point, canvas.drawn[row][column].point);
    }
  }
}

static int begin(void **state) {
  (void)state;
  memset(&canvas, 0, sizeof canvas);
  memset(&terminal, 0x55, sizeof terminal); /* something unknown */
  canvas.utf8 = canvas.colour = true;
  canvas_begin(&canvas, 80, 24);
  return 0;
}

static const char *row_of(int row) {
  static char text[4 * CANVAS_COLUMNS + 1];
  size_t length = 0;
  for (int column = 0; column < canvas.columns; column++)
    length += utf8_write(terminal.cells[row][column].point, text + length);
  while (length > 0 && text[length - 1] == ' ') length--;
  text[length] = '\0';
  return text;
}

static void text_comes_to_its_place(void **state) {
  (void)state;
  assert_int_equal(canvas_text(&canvas, 3, 5, STYLE_PLAIN, "abc"), 8);
  canvas_print(&canvas, 23, 76, STYLE_BAD, "%d%%", 100);
  update();
  assert_string_equal(row_of(3), "     abc");
  assert_string_equal(terminal.styles[23][76], "0;31");
  assert_string_equal(terminal.style, "0"); /* nothing is left switched on */
}

static void text_beyond_the_edges_is_cut(void **state) {
  (void)state;
  canvas_text(&canvas, 0, 78, STYLE_PLAIN, "abc");
  canvas_text(&canvas, 1, -2, STYLE_PLAIN, "abc");
  canvas_text(&canvas, 24, 0, STYLE_PLAIN, "abc");
  canvas_text(&canvas, -1, 0, STYLE_PLAIN, "abc");
  update();
  assert_string_equal(row_of(0) + 78, "ab");
  assert_string_equal(row_of(1), "c");
}

static void what_is_unchanged_costs_nothing(void **state) {
  (void)state;
  canvas_text(&canvas, 3, 5, STYLE_STRONG, "steady");
  update();
  canvas_begin(&canvas, 80, 24);
  canvas_text(&canvas, 3, 5, STYLE_STRONG, "steady");
  update();
  assert_int_equal(byte_count, 0);
  canvas_begin(&canvas, 80, 24);
  canvas_text(&canvas, 3, 5, STYLE_STRONG, "steadY");
  update();
  assert_string_equal(bytes, "\033[4;11H\033[0;1mY\033[0m");
}

static void another_size_or_doubt_draws_everything(void **state) {
  (void)state;
  canvas_text(&canvas, 0, 0, STYLE_PLAIN, "x");
  update();
  canvas_forget(&canvas);
  memset(&terminal, 0x55, sizeof terminal);
  update();
  assert_string_equal(row_of(0), "x");
  canvas_begin(&canvas, 20, 4);
  memset(&terminal, 0x55, sizeof terminal);
  canvas_text(&canvas, 0, 0, STYLE_PLAIN, "y");
  update();
  assert_string_equal(row_of(0), "y");
  canvas_begin(&canvas, 10000, 10000);
  assert_int_equal(canvas.columns, CANVAS_COLUMNS);
  assert_int_equal(canvas.rows, CANVAS_ROWS);
  canvas_begin(&canvas, 1, 1);
  update();
}

static void random_pictures_are_shown(void **state) {
  (void)state;
  unsigned random = 1;
  size_t most = 0;
  for (int picture = 0; picture < 200; picture++) {
    canvas_begin(&canvas, CANVAS_COLUMNS, CANVAS_ROWS);
    for (int row = 0; row < canvas.rows; row++) {
      for (int column = 0; column < canvas.columns; column++) {
        random = 1664525 * random + 1013904223;
        const bool dense = picture < 5;
        const Style style = (Style)((random >> 8) % 7);
        if (dense || random >> 28 == 0)
          canvas_put(&canvas, row, column, style, 0x2588 - (random >> 20 & 7));
      }
    }
    update();
    if (byte_count > most) most = byte_count;
  }
  print_message("largest update: %zu bytes\n", most);
  assert_true(most < CANVAS_BYTES);
}

static void strange_characters_keep_the_columns(void **state) {
  (void)state;
  /* wide, combining, control, not UTF-8: one column each */
  canvas_text(&canvas, 0, 0, STYLE_PLAIN, "\xe4\xb8\xad\xcc\x81\x1b\xffo\xc3\xa9");
  update();
  assert_string_equal(row_of(0), "????o\xc3\xa9");
  canvas.utf8 = false;
  canvas_begin(&canvas, 80, 24);
  canvas_text(&canvas, 0, 0, STYLE_PLAIN, "caf\xc3\xa9");
  update();
  assert_string_equal(row_of(0), "caf?");
}

static void bars_are_as_long_as_they_say(void **state) {
  (void)state;
  canvas_bar(&canvas, 0, 0, 10, 0.5, STYLE_GOOD);
  canvas_bar(&canvas, 1, 0, 10, 0.5125, STYLE_GOOD);
  canvas_bar(&canvas, 2, 0, 10, 7, STYLE_GOOD);
  canvas_bar(&canvas, 3, 0, 10, -1, STYLE_GOOD);
  update();
  assert_string_equal(row_of(0), "█████");
  assert_string_equal(row_of(1), "█████▏");
  assert_string_equal(row_of(2), "██████████");
  assert_string_equal(row_of(3), "");
  canvas.utf8 = false;
  canvas_begin(&canvas, 80, 24);
  canvas_bar(&canvas, 0, 0, 10, 0.5, STYLE_GOOD);
  update();
  assert_string_equal(row_of(0), "#####");
}

static void without_colour_there_is_none(void **state) {
  (void)state;
  canvas.colour = false;
  for (int style = 0; style <= STYLE_ALARM; style++)
    canvas_text(&canvas, style, 0, (Style)style, "x");
  update();
  for (int colour = 30; colour < 50; colour++) {
    char parameter[8];
    snprintf(parameter, sizeof parameter, ";%d", colour);
    assert_null(strstr(bytes, parameter));
  }
  assert_string_equal(terminal.styles[STYLE_ALARM][0], "0;1;7");
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test_setup(text_comes_to_its_place, begin),
    cmocka_unit_test_setup(text_beyond_the_edges_is_cut, begin),
    cmocka_unit_test_setup(what_is_unchanged_costs_nothing, begin),
    cmocka_unit_test_setup(another_size_or_doubt_draws_everything, begin),
    cmocka_unit_test_setup(random_pictures_are_shown, begin),
    cmocka_unit_test_setup(strange_characters_keep_the_columns, begin),
    cmocka_unit_test_setup(bars_are_as_long_as_they_say, begin),
    cmocka_unit_test_setup(without_colour_there_is_none, begin),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
