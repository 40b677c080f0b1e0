/* SPDX-License-Identifier: MIT */
/*
 * The window of the CLAP plugins on a desktop of its own: what is clicked is struck, controls
 * turn and are told to the host, microphones move, presets, undo and comparison, sizes, that blocks
 * wait for nothing while it is open, and that nothing stays of a window that is closed.
 *
 * test_clap_window; OPENINGS in the environment is how often a window is opened, PICTURES a folder
 * for pictures of it. PLAY_SECONDS=60 plays for so long with the window open and for so long
 * without one, in turns, and prints the processor time of blocks of both.
 */
#define _POSIX_C_SOURCE 200809L
#include "clap_window.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <cmocka.h>

#include "counted_calls.h"
#include "drums/default_preset.h"
#include "processor_time.h"
#include "user_files.h"
#include "window_checks.h"

enum {
  BESIDE_X = MIDDLE_X + 20,
  BESIDE_Y = MIDDLE_Y - 45
}; /* beside wires and the mark of the newest stroke */
enum { FRAMES = 2400 };

static Opened open_host(const char *id, double scale) {
  Opened opened = {.host = clap_host_open(&clap_entry, id)};
  clap_host_set(opened.host, 0, KNOB_QUALITY, CLAP_QUALITY(TABOR_QUALITY_DRAFT));
  clap_host_flush(opened.host);
  clap_host_activate(opened.host);
  clap_host_render(opened.host, true);
  clap_host_run(opened.host, FRAMES);
  open_window(&opened, scale);
  return opened;
}

static double peak_of(const ClapHost *host) {
  double peak = 0;
  for (uint32_t i = 0; i < FRAMES; i++) peak = fmax(peak, fabs((double)host->sound[0][i]));
  return peak;
}

/* ---- strokes -------------------------------------------------------------------------------- */

/* The same stroke from a note, whose place the knobs say. */
static void a_click_is_a_stroke_at_its_place(void **state) {
  (void)state;
  static float clicked[FRAMES];
  Opened opened = open_host(ID_DRUM, 1);
  click(&opened, MIDDLE_X + R / 2, MIDDLE_Y);
  clap_host_run(opened.host, FRAMES);
  assert_true(peak_of(opened.host) > 1e-3);
  memcpy(clicked, opened.host->sound[0], sizeof clicked);
  close_host(&opened);

  /* 87.5 pixels are half of the radius, 87 are where the click was */
  const double radius = 0.1778 * (R / 2) / R;
  ClapHost *const host = clap_host_open(&clap_entry, ID_DRUM);
  clap_host_set(host, 0, KNOB_QUALITY, CLAP_QUALITY(TABOR_QUALITY_DRAFT));
  clap_host_set(host, 0, KNOB_STRIKE_RADIUS, radius);
  clap_host_set(host, 0, KNOB_STRIKE_ANGLE, 0);
  clap_host_flush(host);
  clap_host_activate(host);
  clap_host_render(host, true);
  clap_host_run(host, FRAMES);
  double nearest = INFINITY;
  for (int velocity = 70; velocity < 110; velocity++) { /* one is near 4.5 m/s */
    double difference = 0, energy = 0;
    host->plugin->reset(host->plugin);
    clap_host_midi(host, 0, &(MidiMessage){0x99, {38, (uint8_t)velocity}});
    clap_host_run(host, FRAMES);
    for (uint32_t i = 0; i < FRAMES; i++) {
      const double off = (double)(host->sound[0][i] - clicked[i]);
      difference += off * off;
      energy += (double)clicked[i] * (double)clicked[i];
    }
    nearest = fmin(nearest, difference / energy);
  }
  print_message("a click and a note at its place differ by %.4f of their energy\n", nearest);
  assert_true(nearest < 0.02);
  clap_host_close(host);
}

static void the_wheel_changes_how_fast_strokes_are(void **state) {
  (void)state;
  Opened opened = open_host(ID_DRUM, 1);
  click(&opened, MIDDLE_X, MIDDLE_Y);
  clap_host_run(opened.host, FRAMES);
  const double before = peak_of(opened.host);
  opened.host->plugin->reset(opened.host->plugin);
  for (int i = 0; i < 4; i++) desktop_wheel(&server, opened.inner, MIDDLE_X, MIDDLE_Y, -1);
  click(&opened, MIDDLE_X, MIDDLE_Y);
  clap_host_run(opened.host, FRAMES);
  print_message("four notches down: %.1f dB\n", 20 * log10(peak_of(opened.host) / before));
  assert_true(peak_of(opened.host) < 0.7 * before && peak_of(opened.host) > 0.2 * before);
  close_host(&opened);
}

/* The corner beside the head, and a plugin that is not active. */
static void what_is_no_head_is_not_struck(void **state) {
  (void)state;
  Opened opened = open_host(ID_DRUM, 1);
  click(&opened, 5, 5);
  click(&opened, MIDDLE_X + R + 15, MIDDLE_Y);
  clap_host_run(opened.host, FRAMES);
  assert_true(peak_of(opened.host) == 0);
  close_host(&opened);
  opened = (Opened){.host = clap_host_open(&clap_entry, ID_DRUM)};
  open_window(&opened, 1);
  click(&opened, MIDDLE_X, MIDDLE_Y);
  close_host(&opened);
}

/* ---- what is seen --------------------------------------------------------------------------- */

static const struct timespec moment = {.tv_nsec = 10000000};

static uint32_t green_beside(const Opened *opened) {
  return desktop_pixel(&server, opened->inner, BESIDE_X, BESIDE_Y) >> 8 & 255;
}

/* The server draws when it comes to it: what is asked for here may come first. A head at rest is
 * bright. */
static uint32_t green_at_rest(const Opened *opened) {
  uint32_t green = 0;
  for (int i = 0; i < 500 && green < 160; i++) {
    (void)nanosleep(&moment, NULL);
    green = green_beside(opened);
  }
  return green;
}

/* Where the head is pressed down it becomes darker. */
static void a_stroke_is_seen(const Opened *opened, const char *picture) {
  const uint32_t still = green_at_rest(opened);
  uint32_t green = still;
  click(opened, MIDDLE_X, MIDDLE_Y);
  clap_host_run(opened->host, 64);
  tick(opened);
  for (int i = 0; i < 500 && green + 20 > still; i++) {
    (void)nanosleep(&moment, NULL);
    green = green_beside(opened);
  }
  print_message("green at rest %u, struck %u\n", still, green);
  assert_true(green + 20 <= still);
  keep_picture(opened->outer, picture);
}

static void the_head_is_seen_to_move(void **state) {
  (void)state;
  Opened opened = open_host(ID_DRUM, 1);
  clap_host_render(opened.host, false);
  tick(&opened); /* asks for a look */
  clap_host_run(opened.host, 64);
  tick(&opened);
  a_stroke_is_seen(&opened, "struck");
  close_host(&opened);
}

/* A note's stroke, too: an orange ring around the preset's place, of 6 pixels at first. */
static void a_note_leaves_its_mark(void **state) {
  (void)state;
  Opened opened = open_host(ID_DRUM, 1);
  uint32_t color = 0;
  TaborDrumDef def;
  assert_int_equal(tabor_drum_def_preset(&def, DEFAULT_PRESET, NULL), TABOR_OK);
  const double away = R * def.strike.radius / def.shell.radius;
  const double angle = def.strike.angle * 3.14159265358979323846 / 180;
  const int x = (int)lround(MIDDLE_X + away * cos(angle)) + 6;
  const int y = (int)lround(MIDDLE_Y - away * sin(angle));
  clap_host_set(opened.host, 0, KNOB_HUMANIZE, 0);
  clap_host_midi(opened.host, 0, &(MidiMessage){0x99, {38, 100}});
  clap_host_run(opened.host, 64);
  tick(&opened);
  for (int i = 0; i < 500 && ((color >> 16 & 255) < 220 || (color & 255) > 80); i++) {
    (void)nanosleep(&moment, NULL);
    color = desktop_pixel(&server, opened.inner, x, y);
  }
  print_message("beside the place of the stroke: %06x\n", color);
  keep_picture(opened.outer, "note");
  assert_true((color >> 16 & 255) >= 220 && (color & 255) <= 80);
  close_host(&opened);
}

/* Another model: the view follows. */
static void it_is_seen_on_another_drum(void **state) {
  (void)state;
  Opened opened = open_host(ID_DRUM, 1);
  click(&opened, 434, 34); /* the preset before */
  assert_true(opened.host->rescans > 0 && opened.host->loaded[0] != '\0');
  print_message("%s\n", opened.host->loaded);
  for (int i = 0; i < 4; i++) { /* the model comes, the old view is given up, a new one asked for */
    clap_host_run(opened.host, FRAMES);
    tick(&opened);
  }
  a_stroke_is_seen(&opened, "other-drum");
  close_host(&opened);
}

/* ---- controls ------------------------------------------------------------------------------- */

static void a_control_turns_and_the_host_is_told(void **state) {
  (void)state;
  Opened opened = open_host(ID_DRUM, 1);
  ClapHost *const host = opened.host;
  const int y = STRAINER_Y;
  const double before = clap_host_value(host, KNOB_STRAINER);
  drag(&opened, CONTROL_X + CONTROL_WIDTH / 2, y, CONTROL_X + CONTROL_WIDTH / 4, y);
  assert_true(fabs(clap_host_value(host, KNOB_STRAINER) - 0.25) < 0.01);
  clap_host_run(host, 64);
  assert_int_equal(host->gestures, 1);
  assert_int_equal(host->turns, 2);
  assert_int_equal(host->turned, clap_host_id(KNOB_STRAINER));
  assert_true(fabs(host->turned_to - 0.25) < 0.01);
  keep_picture(opened.outer, "turned");
  click(&opened, UNDO_X, BUTTON_Y); /* undo */
  assert_true(clap_host_value(host, KNOB_STRAINER) == before);
  close_host(&opened);
}

/* Of a page the row @p row, which a hand moves to a quarter of its way. */
static void drag_row(const Opened *opened, int row) {
  const int y = CONTROL_Y + CONTROL_ROW * row + 26;
  drag(opened, CONTROL_X + CONTROL_WIDTH / 2, y, CONTROL_X + CONTROL_WIDTH / 4, y);
}

static void every_microphone_has_a_level(void **state) {
  (void)state;
  Opened opened = open_host(ID_DRUM, 1);
  const double quarter = -60 + (12 + 60) / 4.0; /* [dB] */
  wheel(&opened, PAGE_X, BUTTON_Y, -3);
  for (int row = 0; row < 6; row++) {
    static const KnobId ids[] = {KNOB_LEVEL_PAIR, KNOB_LEVEL_TOP, KNOB_LEVEL_BOTTOM,
                                 KNOB_LEVEL_NEAR, KNOB_LEVEL_FAR, KNOB_LEVEL_INSIDE};
    drag_row(&opened, row);
    assert_true(fabs(clap_host_value(opened.host, ids[row]) - quarter) < 0.5);
  }
  keep_picture(opened.outer, "levels");
  wheel(&opened, PAGE_X, BUTTON_Y, 3);
  drag_row(&opened, 4);
  assert_true(fabs(clap_host_value(opened.host, KNOB_STRAINER) - 0.25) < 0.01);
  close_host(&opened);
}

static void a_microphone_that_the_drum_lacks_has_none(void **state) {
  (void)state;
  Opened opened = open_host(ID_DRUM, 1);
  for (int i = 0; i < 4; i++) click(&opened, 434, 34); /* the frame drum, which has no shell */
  wheel(&opened, PAGE_X, BUTTON_Y, -3);
  const double before = clap_host_value(opened.host, KNOB_LEVEL_INSIDE);
  drag_row(&opened, 5);
  keep_picture(opened.outer, "no-level");
  assert_true(clap_host_value(opened.host, KNOB_LEVEL_INSIDE) == before);
  close_host(&opened);
}

/* After the built-in ones; kits are passed over. */
static void drums_of_the_user_follow(void **state) {
  (void)state;
  static ClapState saved;
  Opened opened = open_host(ID_DRUM, 1);
  const double usual = clap_host_value(opened.host, KNOB_DRUM);
  for (int i = 0; i <= usual; i++) click(&opened, 434, 34);
  assert_string_equal(opened.host->refused, "");
  clap_host_save(opened.host, &saved);
  saved.bytes[saved.size] = '\0';
  assert_non_null(strstr(saved.bytes, "name = mine"));
  click(&opened, 682, 34); /* the first after the last */
  clap_host_run(opened.host, 64);
  assert_true(clap_host_value(opened.host, KNOB_DRUM) == 0);
  close_host(&opened);
}

/* A click on the title opens the list at the drum that plays; a click on a line chooses that drum,
 * and another click on the title brings the controls back. */
static void a_drum_is_chosen_from_the_list(void **state) {
  (void)state;
  enum { LINE = LIST_LINE, LINES = LIST_LINES };
  Opened opened = open_host(ID_DRUM, 1);
  ClapHost *const host = opened.host;
  const double usual = clap_host_value(host, KNOB_DRUM);
  click(&opened, TITLE_X, TITLE_Y);
  tick(&opened);
  keep_picture(opened.outer, "sounds");
  double chosen = usual;
  for (int line = LINES - 1; line > 0 && chosen == usual; line--) {
    click(&opened, LIST_X, LIST_Y + LINE * line + LINE / 2);
    clap_host_run(host, FRAMES);
    chosen = clap_host_value(host, KNOB_DRUM);
  }
  print_message("drum %g before, %g chosen\n", usual, chosen);
  assert_true(chosen != usual);
  const double strainer = clap_host_value(host, KNOB_STRAINER);
  click(&opened, CONTROL_X + CONTROL_WIDTH / 2,
        LIST_Y + 2 * LINE + LINE / 2); /* no control lies there now */
  assert_true(clap_host_value(host, KNOB_STRAINER) == strainer);
  for (int i = 0; i < 100; i++) /* to the end of the list, where the user's own are */
    desktop_wheel(&server, opened.inner, LIST_X, LIST_Y + LINE, -1);
  tick(&opened);
  keep_picture(opened.outer, "own");
  click(&opened, LIST_X, LIST_Y + LINE * (LINES - 1) + LINE / 2);
  clap_host_run(host, FRAMES);
  static ClapState saved;
  clap_host_save(host, &saved);
  saved.bytes[saved.size] = '\0';
  assert_non_null(strstr(saved.bytes, "name = mine"));
  click(&opened, TITLE_X, TITLE_Y);
  tick(&opened);
  keep_picture(opened.outer, "controls");
  click(&opened, CONTROL_X, GAIN_Y);
  assert_true(clap_host_value(host, KNOB_GAIN) == -60);
  close_host(&opened);
}

static void two_drums_are_compared(void **state) {
  (void)state;
  Opened opened = open_host(ID_DRUM, 1);
  ClapHost *const host = opened.host;
  const int y = STRAINER_Y;
  click(&opened, COMPARE_X, BUTTON_Y); /* B, as A is */
  click(&opened, CONTROL_X + CONTROL_WIDTH / 2, y);
  const double b = clap_host_value(host, KNOB_STRAINER);
  click(&opened, COMPARE_X, BUTTON_Y);
  const double a = clap_host_value(host, KNOB_STRAINER);
  click(&opened, COMPARE_X, BUTTON_Y);
  print_message("strainer of A %.2f, of B %.2f\n", a, b);
  assert_true(a == 1 && fabs(b - 0.5) < 0.01);
  assert_true(clap_host_value(host, KNOB_STRAINER) == b);
  close_host(&opened);
}

/* ---- microphones ---------------------------------------------------------------------------- */

/* The right one of the pair: 0.5 m to the right, which is 2.8 radii, outside of the head. */
enum { RIGHT_X = MIDDLE_X + 192, NEAR_X = MIDDLE_X, NEAR_Y = MIDDLE_Y - 60 };

typedef struct Heard {
  float sides[2][FRAMES];
} Heard;

/* A stroke on the drum at rest. */
static void hear(const Opened *opened, Heard *heard) {
  ClapHost *const host = opened->host;
  clap_host_run(host, FRAMES); /* the model comes */
  host->plugin->reset(host->plugin);
  click(opened, MIDDLE_X + 30, MIDDLE_Y + 30);
  clap_host_run(host, FRAMES);
  for (int side = 0; side < 2; side++)
    memcpy(heard->sides[side], host->sound[side], sizeof heard->sides[side]);
}

static bool is_same(const Heard *a, const Heard *b, int side) {
  return memcmp(a->sides[side], b->sides[side], sizeof a->sides[side]) == 0;
}

static double loudness(const Heard *heard, int side) {
  double sum = 0;
  for (int i = 0; i < FRAMES; i++)
    sum += (double)heard->sides[side][i] * (double)heard->sides[side][i];
  return 10 * log10(sum);
}

static void undo(const Opened *opened) { click(opened, UNDO_X, BUTTON_Y); }

static void microphones_are_dragged_and_raised(void **state) {
  (void)state;
  static Heard before, moved, raised, back;
  Opened opened = open_host(ID_DRUM, 1);
  clap_host_set(opened.host, 0, KNOB_ROOM, 0);
  hear(&opened, &before);
  click(&opened, RIGHT_X, MIDDLE_Y); /* touched, not moved */
  hear(&opened, &back);
  assert_true(is_same(&before, &back, 0) && is_same(&before, &back, 1));
  drag(&opened, RIGHT_X, MIDDLE_Y, NEAR_X, NEAR_Y);
  keep_picture(opened.outer, "dragged");
  hear(&opened, &moved);
  assert_true(is_same(&before, &moved, 0) && !is_same(&before, &moved, 1));
  for (int i = 0; i < 4; i++) desktop_wheel(&server, opened.inner, NEAR_X, NEAR_Y, -1);
  tick(&opened);
  hear(&opened, &raised);
  print_message("at 0.5 m to the right %.1f dB, over the head %.1f dB, lower by a fifth %.1f dB\n",
                loudness(&before, 1), loudness(&moved, 1), loudness(&raised, 1));
  assert_true(loudness(&raised, 1) > loudness(&moved, 1) + 0.5);
  for (int i = 0; i < 5; i++) undo(&opened);
  hear(&opened, &back);
  assert_true(is_same(&before, &back, 0) && is_same(&before, &back, 1));
  close_host(&opened);
}

/* ---- the audio thread ----------------------------------------------------------------------- */

static void blocks_wait_for_nothing_while_it_is_open(void **state) {
  (void)state;
  Opened opened = open_host(ID_DRUM, 1);
  clap_host_render(opened.host, false);
  for (int i = 0; i < 60; i++) {
    const int x = MIDDLE_X - R / 2 + 3 * i;
    click(&opened, x, MIDDLE_Y);
    if (i % 5 == 0) click(&opened, CONTROL_X + 4 * i, GAIN_Y);
    if (i % 20 == 19) click(&opened, 682, 34); /* the next preset */
    count_calls_begin();
    clap_host_run(opened.host, 512);
    const long calls = count_calls_end();
    if (calls > 0) fail_msg("%ld calls", calls);
  }
  assert_true(opened.host->turns > 0 && peak_of(opened.host) > 0);
  close_host(&opened);
}

enum { TURN = 300, BLOCK = 256, ROOM = 200000 }; /* blocks of a turn; frames; blocks at most */

static int compare_times(const void *a, const void *b) {
  const double one = *(const double *)a, other = *(const double *)b;
  return (one > other) - (one < other);
}

/* A stroke every quarter of a second, and a look of the window 30 times a second. */
static uint32_t play_turn(const Opened *opened, bool has_window, double *times, uint32_t count) {
  for (int i = 0; i < TURN && count < ROOM; i++) {
    if (i % 47 == 0) clap_host_midi(opened->host, 0, &(MidiMessage){0x99, {38, 100}});
    if (has_window && i % 6 == 0) tick(opened);
    const double before = processor_time();
    clap_host_run(opened->host, BLOCK);
    times[count++] = processor_time() - before;
  }
  return count;
}

static void what_blocks_cost_is_printed(void **state) {
  (void)state;
  static double times[2][ROOM];
  uint32_t counts[2] = {0};
  const char *const seconds = getenv("PLAY_SECONDS");
  if (!seconds) return;
  ClapHost *const host = clap_host_open(&clap_entry, ID_DRUM);
  clap_host_activate(host);
  Opened opened = {.host = host};
  const double turns = strtod(seconds, NULL) * 48000 / (TURN * BLOCK);
  for (int turn = 0; turn < turns; turn++) {
    counts[0] = play_turn(&opened, false, times[0], counts[0]);
    open_window(&opened, 1);
    counts[1] = play_turn(&opened, true, times[1], counts[1]);
    close_window(&opened);
  }
  for (int i = 0; i < 2; i++) qsort(times[i], counts[i], sizeof **times, compare_times);
  const double without = times[0][counts[0] / 2], with = times[1][counts[1] / 2];
  print_message("median block of %u: %.1f us, with the window %.1f us, %.3f times\n", counts[0],
                1e6 * without, 1e6 * with, with / without);
  clap_host_close(host);
}

/* ---- sizes and ends ------------------------------------------------------------------------- */

static void it_has_any_size(void **state) {
  (void)state;
  static const double SCALES[] = {0.5, 1.5, 2};
  for (size_t i = 0; i < sizeof SCALES / sizeof *SCALES; i++) {
    Opened opened = open_host(ID_DRUM_MULTI, SCALES[i]);
    const int x = (int)(SCALES[i] * MIDDLE_X), y = (int)(SCALES[i] * MIDDLE_Y);
    char name[32];
    click(&opened, x, y);
    clap_host_run(opened.host, FRAMES);
    assert_true(peak_of(opened.host) > 1e-3);
    (void)snprintf(name, sizeof name, "scale-%g", SCALES[i]);
    tick(&opened);
    keep_picture(opened.outer, name);
    uint32_t width = 1000, height = 440;
    assert_true(opened.gui->adjust_size(opened.host->plugin, &width, &height));
    assert_true(width == WIDTH && height == HEIGHT);
    assert_true(opened.gui->set_size(opened.host->plugin, width, height));
    click(&opened, MIDDLE_X, MIDDLE_Y);
    close_host(&opened);
  }
}

/* Connections to the server are files. Whoever destroys the outer window first does no harm. */
static void a_host_that_scans_is_told_of_it(void **state) {
  (void)state;
  scan_window(ID_DRUM);
}

static void nothing_stays_of_a_window(void **state) {
  (void)state;
  const int openings = getenv("OPENINGS") ? atoi(getenv("OPENINGS")) : 50;
  Opened opened = {.host = clap_host_open(&clap_entry, ID_DRUM)};
  clap_host_set(opened.host, 0, KNOB_QUALITY, CLAP_QUALITY(TABOR_QUALITY_DRAFT));
  clap_host_flush(opened.host);
  clap_host_activate(opened.host);
  const long before = open_files();
  for (int i = 0; i < openings; i++) {
    open_window(&opened, 1);
    tick(&opened);
    if (i % 2 == 0) clap_host_run(opened.host, 64);
    tick(&opened);
    if (i % 5 == 0) desktop_close(&server, opened.outer);
    close_window(&opened);
  }
  print_message("%d windows: %ld files open before, %ld after\n", openings, before, open_files());
  assert_int_equal(open_files(), before);
  open_window(&opened, 1); /* and one that is open when its plugin ends */
  clap_host_close(opened.host);
}

static int run(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(the_counters_count),
    cmocka_unit_test(a_click_is_a_stroke_at_its_place),
    cmocka_unit_test(the_wheel_changes_how_fast_strokes_are),
    cmocka_unit_test(what_is_no_head_is_not_struck),
    cmocka_unit_test(the_head_is_seen_to_move),
    cmocka_unit_test(a_note_leaves_its_mark),
    cmocka_unit_test(it_is_seen_on_another_drum),
    cmocka_unit_test(a_control_turns_and_the_host_is_told),
    cmocka_unit_test(every_microphone_has_a_level),
    cmocka_unit_test(a_microphone_that_the_drum_lacks_has_none),
    cmocka_unit_test_setup_teardown(drums_of_the_user_follow, user_files_make, user_files_remove),
    cmocka_unit_test_setup_teardown(a_drum_is_chosen_from_the_list, user_files_make,
                                    user_files_remove),
    cmocka_unit_test(two_drums_are_compared),
    cmocka_unit_test(microphones_are_dragged_and_raised),
    cmocka_unit_test(blocks_wait_for_nothing_while_it_is_open),
    cmocka_unit_test(what_blocks_cost_is_printed),
    cmocka_unit_test(it_has_any_size),
    cmocka_unit_test(a_host_that_scans_is_told_of_it),
    cmocka_unit_test(nothing_stays_of_a_window),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

int main(void) { return desktop_run(&server, run); }
