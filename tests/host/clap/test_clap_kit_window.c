/* SPDX-License-Identifier: MIT */
/*
 * The window of Tabor Kit on a desktop of its own: a click strikes the drum that stands there,
 * what plays lights up, controls turn and are told to the host, kits, undo and comparison, that
 * blocks wait for nothing while it is open, and that nothing stays of a window that is closed.
 *
 * test_clap_kit_window; OPENINGS in the environment is how often a window is opened, PICTURES a
 * folder for pictures of it.
 */
#define _POSIX_C_SOURCE 200809L
#include "clap_window.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <cmocka.h>

#include "counted_calls.h"
#include "kit_window_checks.h"
#include "user_files.h"
#include "window_checks.h"

enum { FRAMES = 2400 };

static TaborKitDef kit; /* standard */

/* Without what drums hear of each other, so that a drum that was not struck is silent. */
static Opened open_kit(void) {
  Opened opened = {.host = clap_host_open(&clap_entry, ID_KIT)};
  clap_host_set_id(opened.host, 0, KIT_KNOB_QUALITY, 0);
  clap_host_set_id(opened.host, 0, KIT_KNOB_COUPLING, -60);
  clap_host_flush(opened.host);
  clap_host_render(opened.host, true);
  clap_host_activate(opened.host);
  clap_host_run(opened.host, FRAMES);
  open_window(&opened, 1);
  assert_int_equal(tabor_kit_def_preset(&kit, "standard", NULL), TABOR_OK);
  return opened;
}

static double value_of(const ClapHost *host, KitKnobId knob) {
  const clap_plugin_params_t *const params = clap_host_extension(host, CLAP_EXT_PARAMS);
  double value = NAN;
  assert_true(params->get_value(host->plugin, (clap_id)knob, &value));
  return value;
}

/* Of a drum's own output, which follows the mix. */
static double peak_of(const ClapHost *host, uint32_t drum) {
  double peak = 0;
  for (uint32_t i = 0; i < FRAMES; i++)
    peak = fmax(peak, fabs((double)host->sound[2 + 2 * drum][i]));
  return peak;
}

static void click_on(const Opened *opened, uint32_t drum) {
  int x, y;
  kit_pixel_of(&kit, kit.drum[drum].x, kit.drum[drum].y, &x, &y);
  click(opened, x, y);
}

/* ---- strokes -------------------------------------------------------------------------------- */

static void a_click_strikes_the_drum_that_stands_there(void **state) {
  (void)state;
  static const char *const upright[] = {"snare", "high-tom", "floor-tom"};
  Opened opened = open_kit();
  for (size_t i = 0; i < sizeof upright / sizeof *upright; i++) {
    const uint32_t struck = kit_drum_named(&kit, upright[i]);
    opened.host->plugin->reset(opened.host->plugin);
    click_on(&opened, struck);
    clap_host_run(opened.host, FRAMES);
    for (uint32_t drum = 0; drum < kit.drum_count && drum < KIT_KNOB_DRUMS; drum++) {
      const double peak = peak_of(opened.host, drum);
      if (drum == struck ? !(peak > 1e-4) : peak != 0)
        fail_msg("%s struck: %s has %g", upright[i], kit.drum[drum].name, peak);
    }
  }
  close_host(&opened);
}

/* A bass drum is seen from its side: its head is not, and its own stroke comes. */
static void a_bass_drum_has_its_own_stroke(void **state) {
  (void)state;
  Opened opened = open_kit();
  const uint32_t kick = kit_drum_named(&kit, "kick");
  const TaborKitDrumDef *const drum = &kit.drum[kick];
  int x, y;
  kit_pixel_of(&kit, drum->x, drum->y + 0.9 * drum->def.shell.depth, &x, &y);
  click(&opened, x, y);
  clap_host_run(opened.host, FRAMES);
  print_message("kick at %d, %d: %g\n", x, y, peak_of(opened.host, kick));
  assert_true(peak_of(opened.host, kick) > 1e-4);
  tick(&opened);
  keep_picture(opened.outer, "kit");
  opened.host->plugin->reset(opened.host->plugin);
  click(&opened, 3, 3);
  clap_host_run(opened.host, FRAMES);
  for (uint32_t i = 0; i < kit.drum_count && i < KIT_KNOB_DRUMS; i++)
    assert_true(peak_of(opened.host, i) == 0);
  close_host(&opened);
}

/* The window knows of a note only from the audio thread. */
static void what_is_played_lights_up(void **state) {
  (void)state;
  const struct timespec moment = {.tv_nsec = 10000000};
  Opened opened = open_kit();
  const uint32_t snare = kit_drum_named(&kit, "snare");
  int x, y;
  kit_pixel_of(&kit, kit.drum[snare].x, kit.drum[snare].y + 0.6 * kit.drum[snare].def.shell.radius,
               &x, &y);
  tick(&opened);
  uint32_t rest = 0, lit = 255;
  for (int i = 0; i < 500 && (rest & 255) < 150; i++) {
    (void)nanosleep(&moment, NULL);
    rest = desktop_pixel(&server, opened.inner, x, y);
  }
  clap_host_midi(opened.host, 0, &(MidiMessage){0x99, {38, 110}});
  clap_host_run(opened.host, 64);
  tick(&opened);
  for (int i = 0; i < 500 && (lit & 255) > 100; i++) {
    (void)nanosleep(&moment, NULL);
    lit = desktop_pixel(&server, opened.inner, x, y);
  }
  print_message("blue at rest %u, struck %u\n", rest & 255, lit & 255);
  assert_true((rest & 255) >= 150 && (lit & 255) <= 100);
  close_host(&opened);
}

/* ---- controls ------------------------------------------------------------------------------- */

static void controls_turn_and_the_host_is_told(void **state) {
  (void)state;
  Opened opened = open_kit();
  ClapHost *const host = opened.host;
  const uint32_t snare = kit_drum_named(&kit, "snare");
  const KitKnobId level = (KitKnobId)(KIT_KNOB_LEVEL + snare),
                  tune = (KitKnobId)(KIT_KNOB_TUNE + snare);
  const int y = KIT_FIRST_ROW + KIT_ROW * (int)snare;
  drag(&opened, KIT_WAY_X + KIT_WAY / 2, y, KIT_WAY_X + KIT_WAY / 4, y);
  assert_true(fabs(value_of(host, level) - (-60 + 84 * 0.25)) < 0.01);
  clap_host_run(host, 64);
  assert_int_equal(host->gestures, 1);
  assert_int_equal(host->turns, 2);
  assert_int_equal(host->turned, level);
  wheel(&opened, KIT_PAGE_X, KIT_BUTTON_Y, -1); /* tunings */
  click(&opened, KIT_WAY_X + KIT_WAY / 4, y);
  assert_true(fabs(value_of(host, tune) + 6) < 0.051);
  click(&opened, KIT_UNDO_X, KIT_BUTTON_Y);
  assert_true(value_of(host, tune) == 0);
  click(&opened, KIT_UNDO_X, KIT_BUTTON_Y);
  assert_true(value_of(host, level) == 0);
  close_host(&opened);
}

static void kits_are_chosen_and_settings_compared(void **state) {
  (void)state;
  Opened opened = open_kit();
  ClapHost *const host = opened.host;
  click(&opened, KIT_NEXT_X, KIT_NEXT_Y);
  assert_true(value_of(host, KIT_KNOB_KIT) == 1);
  click(&opened, KIT_UNDO_X, KIT_BUTTON_Y);
  assert_true(value_of(host, KIT_KNOB_KIT) == 0);
  click(&opened, KIT_COMPARE_X, KIT_BUTTON_Y); /* B, as A is */
  for (int i = 0; i < 3; i++) click(&opened, KIT_NEXT_X, KIT_NEXT_Y);
  assert_true(value_of(host, KIT_KNOB_KIT) == 3);
  clap_host_run(host, FRAMES);
  tick(&opened);
  keep_picture(opened.outer, "frame-drums");
  click(&opened, KIT_COMPARE_X, KIT_BUTTON_Y);
  assert_true(value_of(host, KIT_KNOB_KIT) == 0);
  click(&opened, KIT_COMPARE_X, KIT_BUTTON_Y);
  assert_true(value_of(host, KIT_KNOB_KIT) == 3);
  click(&opened, KIT_NEXT_X, KIT_NEXT_Y); /* the first after the last */
  assert_true(value_of(host, KIT_KNOB_KIT) == 0);
  close_host(&opened);
}

/* After the built-in ones; drums are passed over. The kit's hi-hat is a sound file beside it. */
static void kits_of_the_user_follow(void **state) {
  (void)state;
  const double own = tabor_kit_count();
  Opened opened = open_kit();
  ClapHost *const host = opened.host;
  click(&opened, KIT_BEFORE_X, KIT_NEXT_Y);
  assert_true(value_of(host, KIT_KNOB_KIT) == own);
  assert_string_equal(host->refused, "");
  clap_host_run(host, 64);
  clap_host_note(host, 0, CLAP_EVENT_NOTE_ON, 42, 1);
  clap_host_run(host, FRAMES);
  double peak = 0;
  for (uint32_t i = 0; i < FRAMES; i++) peak = fmax(peak, fabs((double)host->sound[0][i]));
  print_message("the hi-hat of a file peaks at %.3f\n", peak);
  if (clap_host_has_sound_files()) assert_true(peak > 0.1);
  click(&opened, KIT_NEXT_X, KIT_NEXT_Y); /* the first after the last */
  assert_true(value_of(host, KIT_KNOB_KIT) == 0);
  click(&opened, KIT_BEFORE_X, KIT_NEXT_Y);
  click(&opened, KIT_BEFORE_X, KIT_NEXT_Y);
  assert_true(value_of(host, KIT_KNOB_KIT) == own - 1);
  click(&opened, KIT_UNDO_X, KIT_BUTTON_Y);
  assert_true(value_of(host, KIT_KNOB_KIT) == own);
  close_host(&opened);
}

/* ---- the audio thread, and ends ------------------------------------------------------------- */

static void blocks_wait_for_nothing_while_it_is_open(void **state) {
  (void)state;
  Opened opened = open_kit();
  clap_host_render(opened.host, false);
  for (int i = 0; i < 40; i++) {
    click_on(&opened, (uint32_t)i % kit.drum_count);
    if (i % 5 == 0) click(&opened, KIT_WAY_X + 2 * i, KIT_FIRST_ROW);
    if (i % 20 == 19) wheel(&opened, KIT_PAGE_X, KIT_BUTTON_Y, -1); /* tunings, then the kit's */
    count_calls_begin();
    clap_host_run(opened.host, 512);
    const long calls = count_calls_end();
    if (calls > 0) fail_msg("%ld calls", calls);
  }
  assert_true(opened.host->turns > 0);
  close_host(&opened);
}

static void a_host_that_scans_is_told_of_it(void **state) {
  (void)state;
  scan_window(ID_KIT);
}

static void nothing_stays_of_a_window(void **state) {
  (void)state;
  const int openings = getenv("OPENINGS") ? atoi(getenv("OPENINGS")) : 50;
  Opened opened = open_kit();
  close_window(&opened);
  const long before = open_files();
  for (int i = 0; i < openings; i++) {
    open_window(&opened, 1);
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
    cmocka_unit_test(a_click_strikes_the_drum_that_stands_there),
    cmocka_unit_test(a_bass_drum_has_its_own_stroke),
    cmocka_unit_test(what_is_played_lights_up),
    cmocka_unit_test(controls_turn_and_the_host_is_told),
    cmocka_unit_test(kits_are_chosen_and_settings_compared),
    cmocka_unit_test_setup_teardown(kits_of_the_user_follow, user_files_make, user_files_remove),
    cmocka_unit_test(blocks_wait_for_nothing_while_it_is_open),
    cmocka_unit_test(a_host_that_scans_is_told_of_it),
    cmocka_unit_test(nothing_stays_of_a_window),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

int main(void) { return desktop_run(&server, run); }
