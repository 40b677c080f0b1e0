/* SPDX-License-Identifier: MIT */
/* What the screen says at usual and at tiny sizes. */
#include "ui/screen.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "canvas_row.h"

static Canvas canvas;
static ScreenState shown;
static Keymap keymap;

static int begin(void **state) {
  (void)state;
  memset(&canvas, 0, sizeof canvas);
  keymap_default(&keymap);
  shown = (ScreenState){
    .play =
      {.preset = "snare-14x5.5",
       .device = "JACK: system",
       .rate = 48000,
       .buffer = 128,
       .latency = 0.0081,
       .time = 83.9,
       .channels = 2,
       .gain = 2,
       .xruns = 3,
       .strikers = 1,
       .strokes = 77,
       .ignored_notes = 4,
       .last_event = {.type = TABOR_EVENT_STRIKE, .velocity = 2.5, .radius = 0.0889, .angle = 30},
       .last_time = 12.345},
    .quality = "live",
    .mics = {"top", "bottom"},
    .meters = {{.level = -12.3, .peak = -6.1}, {.level = METER_FLOOR, .peak = METER_FLOOR}},
    .load = {.median = 0.31, .worst = 0.64},
    .head_radius = 0.1778,
    .speed = 2.83,
    .humanize = 0.3,
    .has_snares = true,
    .snares_on = true,
    .tuning = {.heads = {5230.4, 4100}, .wires = 12.5, .pitches = {220, 0}},
    .heard = "left, right in a studio",
  };
  return 0;
}

static void draw(int columns, int rows) {
  canvas_begin(&canvas, columns, rows);
  screen_draw(&shown, &canvas);
}

/* The row that has this text, or -1. */
static int find(const char *text) {
  for (int row = 0; row < canvas.rows; row++) {
    if (strstr(canvas_row(&canvas, row), text)) return row;
  }
  return -1;
}

static void expect(const char *text) {
  if (find(text) >= 0) return;
  for (int row = 0; row < canvas.rows; row++) print_message("|%s|\n", canvas_row(&canvas, row));
  fail_msg("'%s' is not shown", text);
}

static void everything_is_shown_at_80_by_24(void **state) {
  (void)state;
  draw(80, 24);
  expect("tabor  snare-14x5.5 - live");
  expect("1:23");
  expect("JACK: system - 48000 Hz - 128 frames - latency 8.1 ms");
  expect(" -12.3   -6.1");
  expect(" bottom");
  expect(" 31 %, worst  64 % of 2.67 ms");
  expect("xruns 3");
  expect("strokes 77");
  expect("strikers 1");
  expect("batter A3, 5230 N/m   resonant 4100 N/m   wires 12.5 N");
  expect("notes that play nothing 4");
  expect("heard   left, right in a studio");
  shown.tuning = (ScreenTuning){.wires = 0};
  draw(80, 24);
  expect("a plate: none");
  expect("stroke at 50 % of the radius, 30 degrees, 2.50 m/s, at 12.3");
  expect("2.83 m/s   gain +6.0 dB   snares on   muffle off   humanize 0.3");
  expect("? help");
  assert_int_equal(find("CLIP"), -1);
  assert_int_equal(find("REC"), -1);
}

static void lights_go_on(void **state) {
  (void)state;
  shown.meters[1].clip_left = 1;
  shown.play.recording = shown.play.building = shown.play.sleeping = true;
  shown.has_snares = false;
  shown.is_muffled = true;
  draw(80, 24);
  assert_int_equal(find("CLIP"), find(" bottom"));
  expect("REC 1:23");
  expect("(building)");
  expect("asleep");
  expect("muffle on");
  assert_int_equal(find("snares"), -1);
}

static void meters_are_as_long_as_their_level(void **state) {
  (void)state;
  shown.play.channels = 1;
  const int width = 80 - 9 - 21;
  const double levels[] = {METER_FLOOR, -30, 0};
  const int lengths[] = {0, width / 2, width};
  for (int i = 0; i < 3; i++) {
    shown.meters[0] = (Meter){.level = levels[i], .peak = METER_FLOOR};
    draw(80, 24);
    const char *const row = canvas_row(&canvas, find(" top"));
    assert_int_equal(strspn(row + 9, "#"), lengths[i]);
  }
  shown.meters[0] = (Meter){.level = METER_FLOOR, .peak = 0};
  draw(80, 24);
  assert_int_equal(canvas_row(&canvas, find(" top"))[9 + width - 1], '|');
}

static void messages_and_commands_have_their_rows(void **state) {
  (void)state;
  static LineEditor line;
  line_editor_begin(&line);
  for (const char *c = "set wires.tension 20"; *c; c++) line_editor_take(&line, (Key)*c);
  line_editor_take(&line, KEY_HOME);
  shown.line = &line;
  strcpy(shown.message, "it went wrong");
  shown.is_trouble = true;
  draw(80, 24);
  assert_int_equal(find("it went wrong"), 22);
  assert_int_equal(find(":set wires.tension 20"), 23);
  assert_int_equal(canvas.drawn[23][1].style, STYLE_REVERSE);
  assert_int_equal(canvas.drawn[22][1].style, STYLE_BAD);
  assert_int_equal(find("? help"), -1);
  line_editor_take(&line, KEY_END);
  draw(10, 3); /* the end, where the cursor is, stays in view */
  assert_non_null(strstr(canvas_row(&canvas, 2), "nsion 20"));
  assert_int_equal(canvas.drawn[2][9].style, STYLE_REVERSE);
}

static void long_messages_take_two_rows(void **state) {
  (void)state;
  strcpy(shown.message,
         "the one thing that can be said about it is that it takes more than one row to say "
         "it in full");
  draw(80, 24);
  assert_int_equal(
    find("the one thing that can be said about it is that it takes more than one row to"), 21);
  assert_int_equal(find(" say it in full"), 22);
  memset(shown.message, 0, sizeof shown.message);
  for (int i = 0; i < 100; i++)
    strcat(shown.message, "\xc3\xa9"); /* no blank, characters of two bytes */
  draw(80, 24);
  expect("??????????????????????");
  assert_int_equal(canvas.drawn[22][22].point, '?');
  assert_int_equal(canvas.drawn[22][23].point, ' ');
}

static void help_explains_the_keys_that_there_are(void **state) {
  (void)state;
  shown.help = &keymap;
  draw(80, 24);
  expect("a s d f g h j k l      strokes, from the centre to the rim");
  expect("q w e r t y u i o p    ghost notes");
  expect("z x c v m              rimshot, cross-stick, rim, buzz, sweep");
  expect("- + =                  gain");
  expect("space                  the last stroke again");
  expect("Escape twice, Ctrl-C   quit");
  expect(" -12.3");
  assert_int_equal(find("commands of your own"), -1);
  assert_int_equal(find("xruns"), -1);
}

static void low_terminals_keep_what_matters(void **state) {
  (void)state;
  draw(80, 8);
  expect("snare-14x5.5");
  expect(" top");
  expect("stroke at");
  expect("2.83 m/s");
  expect("? help");
  assert_int_equal(find("tuning"), -1);
  strcpy(shown.message, "hello");
  draw(80, 3);
  expect("hello");
  draw(80, 2);
  expect("hello");
  draw(80, 1);
  expect("? help");
}

static void no_size_is_too_small_or_too_large(void **state) {
  (void)state;
  static LineEditor line;
  line_editor_begin(&line);
  shown.play.channels = TABOR_MAX_MICS;
  for (int help = 0; help < 2; help++) {
    shown.help = help ? &keymap : NULL;
    shown.line = help ? NULL : &line;
    for (int columns = 1; columns < 300; columns += columns < 90 ? 1 : 50) {
      for (int rows = 1; rows < 70; rows++) draw(columns, rows);
    }
  }
}

static void hostile_text_stays_on_its_row(void **state) {
  (void)state;
  strcpy(shown.play.preset, "\033[2Jx\n\xff\xc3");
  memset(shown.message, 'm', sizeof shown.message - 1);
  draw(80, 24);
  for (int row = 0; row < 24; row++) {
    for (int column = 0; column < 80; column++) assert_true(canvas.drawn[row][column].point >= ' ');
  }
  expect("?[2Jx???");
}

static void events_are_told(void **state) {
  (void)state;
  const struct {
    TaborEvent event;
    const char *text;
  } events[] = {
    {{.type = 0}, ""},
    {{.type = TABOR_EVENT_STRIKE, .velocity = 1, .radius = 0.1, .angle = -10},
     "stroke at 50 % of the radius, -10 degrees, 1.00 m/s"},
    {{.type = TABOR_EVENT_PRESS, .value = 0.5}, "press 0.50"},
    {{.type = TABOR_EVENT_DAMP, .value = 3}, "hand on the head, 3.00 N s/m"},
    {{.type = TABOR_EVENT_RELEASE}, "release"},
    {{.type = TABOR_EVENT_PARAMETER, .value = 20}, "parameter to 20"},
    {{.type = TABOR_EVENT_SWAP}, "another drum"},
    {{.type = TABOR_EVENT_RESET}, "silence"},
  };
  for (size_t i = 0; i < sizeof events / sizeof events[0]; i++) {
    char text[100];
    assert_string_equal(screen_event(&events[i].event, 0.2, text, sizeof text), events[i].text);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test_setup(everything_is_shown_at_80_by_24, begin),
    cmocka_unit_test_setup(lights_go_on, begin),
    cmocka_unit_test_setup(meters_are_as_long_as_their_level, begin),
    cmocka_unit_test_setup(messages_and_commands_have_their_rows, begin),
    cmocka_unit_test_setup(long_messages_take_two_rows, begin),
    cmocka_unit_test_setup(help_explains_the_keys_that_there_are, begin),
    cmocka_unit_test_setup(low_terminals_keep_what_matters, begin),
    cmocka_unit_test_setup(no_size_is_too_small_or_too_large, begin),
    cmocka_unit_test_setup(hostile_text_stays_on_its_row, begin),
    cmocka_unit_test_setup(events_are_told, begin),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
