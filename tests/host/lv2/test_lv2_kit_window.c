/* SPDX-License-Identifier: MIT */
/*
 * The window of the LV2 plugin Tabor Kit: a click strikes the drum that stands there, controls and
 * kits are ports of the host, undo, and that nothing stays of a window that is closed. What is
 * drawn is the same as in the CLAP plugin: test_clap_kit_window.
 *
 * test_lv2_kit_window; OPENINGS in the environment is how often a window is opened, PICTURES a
 * folder for pictures of it.
 */
#define _POSIX_C_SOURCE 200809L
#include "lv2_window.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "counted_calls.h"
#include "kit_window_checks.h"
#include "lv2/uris.h"
#include "window_checks.h"

enum { FRAMES = 2400 };

static TaborKitDef kit; /* standard */

/* Without what drums hear of each other, so that a drum that was not struck is silent. */
static PluginHost *open_kit(void) {
  PluginHost *const host = open_plugin(URI_KIT);
  host->kit_knobs[KIT_KNOB_QUALITY] = 0; /* draft */
  host->kit_knobs[KIT_KNOB_COUPLING] = -60;
  host->freewheel = 1;
  host_run(host, FRAMES);
  assert_int_equal(tabor_kit_def_preset(&kit, "standard", NULL), TABOR_OK);
  return host;
}

static void open_host(Opened *opened) {
  *opened = (Opened){.host = open_kit()};
  open_window(opened, 1);
}

static void click_on(const Opened *opened, uint32_t drum) {
  int x, y;
  kit_pixel_of(&kit, kit.drum[drum].x, kit.drum[drum].y, &x, &y);
  click(opened, x, y);
}

static void a_click_strikes_the_drum_that_stands_there(void **state) {
  (void)state;
  Opened opened;
  open_host(&opened);
  const uint32_t struck = kit_drum_named(&kit, "high-tom");
  click_on(&opened, struck);
  host_run(opened.host, FRAMES);
  for (uint32_t drum = 0; drum < kit.drum_count; drum++) {
    const double peak = host_peak(opened.host->sound[2 + 2 * drum], FRAMES);
    if (drum == struck ? !(peak > 1e-4) : peak != 0) fail_msg("drum %u has %g", drum, peak);
  }
  tick(&opened);
  keep_picture(opened.outer, "lv2-kit");
  close_host(&opened);
}

static void controls_and_kits_are_ports_of_the_host(void **state) {
  (void)state;
  Opened opened;
  open_host(&opened);
  const float *const ports = opened.host->kit_knobs;
  drag(&opened, KIT_WAY_X + KIT_WAY / 2, KIT_FIRST_ROW, KIT_WAY_X + KIT_WAY / 4, KIT_FIRST_ROW);
  assert_true(fabsf(ports[KIT_KNOB_LEVEL] - (-60 + 84 * 0.25f)) < 0.01f);
  assert_true(opened.writes == 2 && opened.grabs == 1 && opened.releases == 1);
  click(&opened, KIT_NEXT_X, KIT_NEXT_Y);
  assert_true(ports[KIT_KNOB_KIT] == 1);
  host_run(opened.host, FRAMES);
  click(&opened, KIT_UNDO_X, KIT_BUTTON_Y);
  assert_true(ports[KIT_KNOB_KIT] == 0);
  click(&opened, KIT_UNDO_X, KIT_BUTTON_Y);
  assert_true(ports[KIT_KNOB_LEVEL] == 0);
  close_host(&opened);
}

/* What the host turns is shown: the window turns on from there. */
static void the_host_turns_a_control(void **state) {
  (void)state;
  Opened opened;
  open_host(&opened);
  opened.host->kit_knobs[KIT_KNOB_KIT] = 2;
  tell_ports(&opened);
  tick(&opened);
  click(&opened, KIT_NEXT_X, KIT_NEXT_Y);
  assert_true(opened.host->kit_knobs[KIT_KNOB_KIT] == 3);
  close_host(&opened);
}

static void runs_wait_for_nothing_while_it_is_open(void **state) {
  (void)state;
  Opened opened;
  open_host(&opened);
  opened.host->freewheel = 0;
  for (int i = 0; i < 40; i++) {
    click_on(&opened, (uint32_t)i % kit.drum_count);
    if (i % 5 == 0) click(&opened, KIT_WAY_X + 2 * i, KIT_FIRST_ROW);
    if (i % 20 == 19) wheel(&opened, KIT_PAGE_X, KIT_BUTTON_Y, -1); /* tunings, then the kit's */
    count_calls_begin();
    opened.host->descriptor->run(opened.host->handle, 512);
    const long calls = count_calls_end();
    if (calls > 0) fail_msg("%ld calls", calls);
  }
  assert_true(opened.writes > 0 && host_peak(opened.host->sound[0], 512) > 0);
  close_host(&opened);
}

static void nothing_stays_of_a_window(void **state) {
  (void)state;
  check_openings(open_kit());
}

static int run(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(a_click_strikes_the_drum_that_stands_there),
    cmocka_unit_test(controls_and_kits_are_ports_of_the_host),
    cmocka_unit_test(the_host_turns_a_control),
    cmocka_unit_test(runs_wait_for_nothing_while_it_is_open),
    cmocka_unit_test(nothing_stays_of_a_window),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

int main(void) { return desktop_run(&server, run); }
