/* SPDX-License-Identifier: MIT */
/*
 * The window of the LV2 plugins on a desktop of its own: what is clicked is struck, controls are
 * ports of the host, presets, undo and comparison, that runs wait for nothing while it is open, and
 * that nothing stays of a window that is closed. What is drawn is the same as in the CLAP plugins:
 * test_clap_window.
 *
 * test_lv2_window; OPENINGS in the environment is how often a window is opened, PICTURES a folder
 * for pictures of it.
 */
#define _POSIX_C_SOURCE 200809L
#include "lv2_window.h"

#include <lv2/instance-access/instance-access.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "counted_calls.h"
#include "lv2/instance.h"
#include "lv2/uris.h"
#include "window_checks.h"

enum { FRAMES = 2400 };

/* ---- a host with a window ------------------------------------------------------------------- */

static PluginHost *open_draft(const char *uri) {
  PluginHost *const host = open_plugin(uri);
  host->knobs[KNOB_QUALITY] = 0; /* draft */
  host_wait(host);
  return host;
}

static void open_host(Opened *opened, const char *uri, float scale) {
  *opened = (Opened){.host = open_draft(uri)};
  open_window(opened, scale);
}

static double peak_of(const PluginHost *host) { return host_peak(host->sound[0], FRAMES); }

static const char *name_of(const Opened *opened) {
  static InstrumentSetting saved;
  Instance *const instance = opened->host->handle;
  instance->instrument->kind->calls->note(instance->instrument, &saved);
  return saved.def.name;
}

/* ---- strokes -------------------------------------------------------------------------------- */

static void a_click_is_a_stroke(void **state) {
  (void)state;
  static const float SCALES[] = {1, 2};
  for (size_t i = 0; i < 2; i++) {
    Opened opened;
    const int scale = (int)SCALES[i];
    open_host(&opened, i == 0 ? URI_DRUM : URI_DRUM_MULTI, SCALES[i]);
    assert_int_equal(opened.width, scale * WIDTH);
    assert_int_equal(opened.height, scale * HEIGHT);
    host_run(opened.host, FRAMES);
    assert_true(peak_of(opened.host) == 0);
    click(&opened, scale * 5, scale * 5);
    host_run(opened.host, FRAMES);
    assert_true(peak_of(opened.host) == 0); /* beside the head */
    click(&opened, scale * (MIDDLE_X + R / 2), scale * MIDDLE_Y);
    host_run(opened.host, FRAMES);
    print_message("a click sounds to %.3f\n", peak_of(opened.host));
    assert_true(peak_of(opened.host) > 1e-3);
    tick(&opened);
    keep_picture(opened.outer, i == 0 ? "lv2" : "lv2-twice");
    close_host(&opened);
  }
}

/* ---- controls and drums --------------------------------------------------------------------- */

static void a_control_is_a_port_of_the_host(void **state) {
  (void)state;
  Opened opened;
  open_host(&opened, URI_DRUM, 1);
  const float before = opened.host->knobs[KNOB_STRAINER];
  const int x = CONTROL_X + CONTROL_WIDTH / 2;
  drag(&opened, x, STRAINER_Y, x - CONTROL_WIDTH / 4, STRAINER_Y);
  assert_true(fabsf(opened.host->knobs[KNOB_STRAINER] - 0.25f) < 0.01f);
  assert_true(opened.writes == 2 && opened.grabs == 1 && opened.releases == 1);
  host_run(opened.host, 64);
  click(&opened, UNDO_X, BUTTON_Y); /* undo */
  assert_true(opened.host->knobs[KNOB_STRAINER] == before);
  close_host(&opened);
}

/* Ports stand where the drum is, and the drum is the preset to the bit: no knob has been turned. */
static void a_preset_comes_with_its_knobs(void **state) {
  (void)state;
  Opened opened;
  TaborDrumDef def;
  InstrumentSetting saved;
  open_host(&opened, URI_DRUM, 1);
  Instance *const instance = opened.host->handle;
  assert_string_equal(name_of(&opened), DEFAULT_PRESET);
  click(&opened, 682, 34); /* the next preset */
  host_wait(opened.host);
  assert_string_not_equal(name_of(&opened), DEFAULT_PRESET);
  print_message("%s\n", name_of(&opened));
  assert_int_equal(tabor_drum_def_preset(&def, name_of(&opened), NULL), TABOR_OK);
  instance->instrument->kind->calls->note(instance->instrument, &saved);
  assert_true(saved.def.batter.tension == def.batter.tension);
  assert_true(fabs((double)opened.host->knobs[KNOB_BATTER_TENSION] / def.batter.tension - 1) <
              1e-6);
  click(&opened, UNDO_X, BUTTON_Y); /* undo */
  host_wait(opened.host);
  assert_string_equal(name_of(&opened), DEFAULT_PRESET);
  close_host(&opened);
}

static void two_drums_are_compared(void **state) {
  (void)state;
  Opened opened;
  open_host(&opened, URI_DRUM, 1);
  click(&opened, COMPARE_X, BUTTON_Y); /* B, as A is */
  click(&opened, CONTROL_X + CONTROL_WIDTH / 2, STRAINER_Y);
  const float b = opened.host->knobs[KNOB_STRAINER];
  click(&opened, COMPARE_X, BUTTON_Y);
  const float a = opened.host->knobs[KNOB_STRAINER];
  click(&opened, COMPARE_X, BUTTON_Y);
  assert_true(a == 1 && fabsf(b - 0.5f) < 0.01f);
  assert_true(opened.host->knobs[KNOB_STRAINER] == b);
  close_host(&opened);
}

/* What the host turns is shown: the window turns on from there. */
static void the_host_turns_a_control(void **state) {
  (void)state;
  Opened opened;
  open_host(&opened, URI_DRUM, 1);
  opened.host->knobs[KNOB_STRAINER] = 0.5f;
  tell_ports(&opened);
  tick(&opened);
  desktop_wheel(&server, opened.inner, CONTROL_X + 50, STRAINER_Y, 1); /* wheel */
  tick(&opened);
  assert_true(fabsf(opened.host->knobs[KNOB_STRAINER] - 0.52f) < 0.001f);
  close_host(&opened);
}

/* It has no other head and no snares: their controls are there, but nothing turns. */
static void controls_of_missing_parts_are_idle(void **state) {
  (void)state;
  enum { RESONANT_PITCH_Y = CONTROL_Y + CONTROL_ROW + 26, BATTER_PITCH_Y = CONTROL_Y + 26 };
  Opened opened;
  InstrumentSetting saved;
  open_host(&opened, URI_DRUM, 1);
  Instance *const instance = opened.host->handle;
  instance->instrument->kind->calls->note(instance->instrument, &saved);
  assert_int_equal(tabor_drum_def_preset(&saved.def, "frame-drum", NULL), TABOR_OK);
  instance->instrument->kind->calls->use(instance->instrument, &saved);
  host_wait(opened.host);
  close_window(&opened);
  open_window(&opened, 1);
  tick(&opened);
  const uint32_t before = opened.writes;
  click(&opened, CONTROL_X + 100, RESONANT_PITCH_Y);
  click(&opened, CONTROL_X + 100, STRAINER_Y);
  assert_int_equal(opened.writes, before);
  click(&opened, CONTROL_X + 100, BATTER_PITCH_Y);
  assert_true(opened.writes > before);
  keep_picture(opened.outer, "lv2-one-head");
  close_host(&opened);
}

/* ---- the audio thread ----------------------------------------------------------------------- */

static void runs_wait_for_nothing_while_it_is_open(void **state) {
  (void)state;
  Opened opened;
  open_host(&opened, URI_DRUM, 1);
  for (int i = 0; i < 60; i++) {
    click(&opened, MIDDLE_X - R / 2 + 3 * i, MIDDLE_Y);
    if (i % 5 == 0) click(&opened, CONTROL_X + 4 * i, GAIN_Y);
    if (i % 20 == 19) click(&opened, 682, 34); /* the next preset */
    count_calls_begin();
    opened.host->descriptor->run(opened.host->handle, 512);
    const long calls = count_calls_end();
    if (calls > 0) fail_msg("%ld calls", calls);
  }
  assert_true(opened.writes > 0 && host_peak(opened.host->sound[0], 512) > 0);
  close_host(&opened);
}

/* ---- beginning and end ---------------------------------------------------------------------- */

static LV2UI_Handle open_with(const LV2_Feature *const *features, const char *plugin) {
  LV2UI_Widget widget;
  const LV2UI_Descriptor *const descriptor = lv2ui_descriptor(0);
  return descriptor->instantiate(descriptor, plugin, "", write_port, NULL, &widget, features);
}

static void it_opens_for_its_own_instances_alone(void **state) {
  (void)state;
  PluginHost *const host = open_draft(URI_DRUM);
  Instance *const instance = host->handle;
  const DesktopWindow outer = desktop_window(&server, WIDTH, HEIGHT);
  const LV2_Feature parent = {LV2_UI__parent, (void *)(uintptr_t)outer},
                    access = {LV2_INSTANCE_ACCESS_URI, host->handle};
  assert_null(open_with((const LV2_Feature *const[]){&parent, NULL}, URI_DRUM));
  assert_null(open_with((const LV2_Feature *const[]){&access, NULL}, URI_DRUM));
  const LV2_Feature *const both[] = {&parent, &access, NULL};
  assert_null(open_with(both, URI_KIT));
  instance->version = "0.0.0";
  assert_null(open_with(both, URI_DRUM));
  instance->version = tabor_version();
  const LV2UI_Handle ui = open_with(both, URI_DRUM);
  assert_non_null(ui);
  lv2ui_descriptor(0)->cleanup(ui);
  assert_null(lv2ui_descriptor(2));
  desktop_close(&server, outer);
  host_close(host);
}

static void nothing_stays_of_a_window(void **state) {
  (void)state;
  check_openings(open_draft(URI_DRUM));
}

static int run(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(the_counters_count),
    cmocka_unit_test(a_click_is_a_stroke),
    cmocka_unit_test(a_control_is_a_port_of_the_host),
    cmocka_unit_test(a_preset_comes_with_its_knobs),
    cmocka_unit_test(two_drums_are_compared),
    cmocka_unit_test(the_host_turns_a_control),
    cmocka_unit_test(controls_of_missing_parts_are_idle),
    cmocka_unit_test(runs_wait_for_nothing_while_it_is_open),
    cmocka_unit_test(it_opens_for_its_own_instances_alone),
    cmocka_unit_test(nothing_stays_of_a_window),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

int main(void) { return desktop_run(&server, run); }
