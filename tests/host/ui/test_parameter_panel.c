/* SPDX-License-Identifier: MIT */
/* The list of parameters: what its keys choose and ask for, and what it shows. */
#include "ui/parameter_panel.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "canvas_row.h"

static ParameterPanel panel;
static TaborDrumDef def;
static char command[PANEL_COMMAND_SIZE];
static Canvas canvas;

static int begin(void **state) {
  (void)state;
  panel = (ParameterPanel){0};
  memset(&canvas, 0, sizeof canvas);
  return tabor_drum_def_preset(&def, "snare-14x5.5", NULL) != TABOR_OK;
}

static PanelWish take(Key key) { return parameter_panel_take(&panel, &def, key, command); }

static const char *chosen(void) {
  static char key[2 * TABOR_NAME_SIZE];
  assert_true(tabor_drum_def_key(&def, panel.at, key, sizeof key));
  return key;
}

/* Walks from the first until the key is chosen. */
static void choose(const char *key) {
  for (int i = 0; i < 1000; i++) (void)take(KEY_UP);
  for (int i = 0; i < 1000 && strcmp(chosen(), key) != 0; i++)
    assert_int_equal(take(KEY_DOWN), PANEL_DONE);
  assert_string_equal(chosen(), key);
}

static void closed_it_leaves_keys_alone(void **state) {
  (void)state;
  assert_int_equal(take(KEY_DOWN), PANEL_NOTHING);
  assert_int_equal(take('a'), PANEL_NOTHING);
  assert_int_equal(take(KEY_TAB), PANEL_DONE);
  assert_int_equal(take('a'), PANEL_NOTHING); /* strokes go on */
  assert_int_equal(take(KEY_TAB), PANEL_DONE);
  assert_int_equal(take(KEY_LEFT), PANEL_NOTHING);
}

static void parameters_are_chosen(void **state) {
  (void)state;
  (void)take(KEY_TAB);
  assert_string_equal(chosen(), "batter.tension");
  (void)take(KEY_TAB);
  (void)take(KEY_TAB);
  assert_string_equal(chosen(), "batter.tension");
  choose("shell.depth");
  (void)take(KEY_PAGE_DOWN);
  assert_string_equal(chosen(), "batter.tension");
  (void)take(KEY_PAGE_DOWN);
  assert_string_equal(chosen(), "resonant.tension");
  (void)take(KEY_PAGE_UP);
  assert_string_equal(chosen(), "batter.tension");
  for (int i = 0; i < 1000; i++) (void)take(KEY_DOWN);
  char key[2 * TABOR_NAME_SIZE];
  assert_false(tabor_drum_def_key(&def, panel.at + 1, key, sizeof key));
  assert_int_equal(tabor_drum_def_preset(&def, "frame-drum", NULL), TABOR_OK); /* has fewer */
  (void)take(KEY_DOWN);
  (void)chosen();
}

static void commands_turn_and_type(void **state) {
  (void)state;
  (void)take(KEY_TAB);
  choose("shell.depth");
  assert_int_equal(take(KEY_ENTER), PANEL_TYPE);
  assert_string_equal(command, "set shell.depth ");
  choose("wires.strainer");
  assert_int_equal(take(KEY_LEFT), PANEL_RUN);
  assert_string_equal(command, "set wires.strainer 0.98");
}

static void choices_and_numbers_go_by_steps(void **state) {
  (void)state;
  (void)take(KEY_TAB);
  choose("body.kind");
  assert_int_equal(take(KEY_RIGHT), PANEL_RUN);
  assert_string_equal(command, "set body.kind plate");
  choose("batter.lug_seed");
  assert_int_equal(take(KEY_RIGHT), PANEL_RUN);
  choose("wires.head");
  assert_int_equal(take(KEY_LEFT), PANEL_RUN);
  assert_string_equal(command, "set wires.head batter");
}

static void it_shows_what_is_around(void **state) {
  (void)state;
  (void)take(KEY_TAB);
  choose("shell.depth");
  canvas_begin(&canvas, 80, 24);
  parameter_panel_draw(&panel, &def, &canvas, 2, 12);
  int found = -1;
  for (int row = 2; row <= 12; row++)
    if (strstr(canvas_row(&canvas, row), "shell.depth")) found = row;
  assert_true(found > 2 && found < 12);
  assert_non_null(strstr(canvas_row(&canvas, found), "139.7 mm"));
  assert_non_null(strstr(canvas_row(&canvas, found), "depth of the air"));
  assert_int_equal(canvas.drawn[found][0].style, STYLE_REVERSE);
  assert_int_equal(canvas.drawn[found + 1][0].style, STYLE_PLAIN);
  assert_null(strstr(canvas_row(&canvas, 13), "."));
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test_setup(closed_it_leaves_keys_alone, begin),
    cmocka_unit_test_setup(parameters_are_chosen, begin),
    cmocka_unit_test_setup(commands_turn_and_type, begin),
    cmocka_unit_test_setup(choices_and_numbers_go_by_steps, begin),
    cmocka_unit_test_setup(it_shows_what_is_around, begin),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
