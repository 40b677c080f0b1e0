/* SPDX-License-Identifier: MIT */
/*
 * What the plugins save and restore: an instance is found as it was left; a state that is wrong
 * changes nothing.
 *
 * test_lv2_state PLUGINS
 */
#include "plugin_host.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "lv2/uris.h"
#include "user_files.h"

#define FRAMES 12000u
#define FRAME_DRUM 1 /* place of the preset among the built-in ones */

static const char *plugins;

static PluginHost *open_drum(void) {
  PluginHost *const host = host_open(host_descriptor(plugins, URI_DRUM), HOST_WITHOUT_WORKER);
  host->knobs[KNOB_QUALITY] = 0;
  host->freewheel = 1;
  return host;
}

/* Of the left side: a stroke, and what is done after @p change frames of it. */
static void record(PluginHost *host, float *sound, uint32_t change, void (*act)(PluginHost *)) {
  host_note(host, 0, 38, 100);
  for (uint32_t at = 0; at < FRAMES; at += 500) {
    if (act && at == change) act(host);
    host_run(host, 500);
    memcpy(sound + at, host->sound[0], 500 * sizeof(float));
  }
  assert_true(host_peak(sound, FRAMES) > 1e-3);
}

static void assert_same(const float *one, const float *other) {
  for (uint32_t i = 0; i < FRAMES; i++) {
    if (one[i] != other[i]) fail_msg("frame %u: %.9g, %.9g", i, (double)one[i], (double)other[i]);
  }
}

static bool is_same(const float *one, const float *other) {
  return memcmp(one, other, FRAMES * sizeof *one) == 0;
}

static float first[FRAMES], second[FRAMES], third[FRAMES];

/* ---- found as left -------------------------------------------------------------------------- */

static void save_and_restore(PluginHost *host) {
  HostState state;
  host_save(host, &state);
  assert_int_equal(host_restore(host, &state), LV2_STATE_SUCCESS);
  host_state_free(&state);
}

static void test_restoring_a_ringing_drum_changes_no_bit(void **state) {
  (void)state;
  PluginHost *const one = open_drum(), *const other = open_drum();
  record(one, first, 0, NULL);
  record(other, second, 4000, save_and_restore);
  assert_same(first, second);
  host_close(one);
  host_close(other);
}

static void choose(PluginHost *host, uint8_t program) {
  host_event(host, 0, 2, (const uint8_t[]){0xC9, program});
}

/* Deactivated and activated again it begins anew, as a new instance does. */
static void restart(PluginHost *host) { host->descriptor->activate(host->handle); }

/* Another preset by MIDI, and knobs that were turned before and after. */
static PluginHost *open_changed(void) {
  PluginHost *const host = open_drum();
  host->knobs[KNOB_WIRE_TENSION] = 20;
  host->knobs[KNOB_BATTER_TENSION] = 4000;
  host_run(host, 100);
  choose(host, FRAME_DRUM);
  host_run(host, 100);
  host->knobs[KNOB_BATTER_TENSION] = 2500;
  host->knobs[KNOB_STRIKE_RADIUS] = 0.11f;
  host_run(host, 100);
  return host;
}

/* A new instance with the same knobs, which are set before or after the state. */
static PluginHost *open_copy(PluginHost *host, bool knobs_first) {
  HostState state;
  PluginHost *const copy = open_drum();
  host_save(host, &state);
  if (knobs_first) memcpy(copy->knobs, host->knobs, sizeof copy->knobs);
  if (knobs_first) host_run(copy, 10);
  assert_int_equal(host_restore(copy, &state), LV2_STATE_SUCCESS);
  if (!knobs_first) memcpy(copy->knobs, host->knobs, sizeof copy->knobs);
  host_state_free(&state);
  return copy;
}

static void found_as_left(PluginHost *host) {
  restart(host);
  record(host, first, 0, NULL);
  for (int knobs_first = 0; knobs_first <= 1; knobs_first++) {
    PluginHost *const copy = open_copy(host, knobs_first == 1);
    record(copy, second, 0, NULL);
    assert_same(first, second);
    host_close(copy);
  }
  PluginHost *const fresh = open_drum();
  record(fresh, third, 0, NULL);
  assert_false(is_same(first, third));
  host_close(fresh);
  host_close(host);
}

static void test_an_instance_is_found_as_it_was_left(void **state) {
  (void)state;
  found_as_left(open_changed());
}

/* Live knobs alone build no model; they are found all the same. */
static void test_live_knobs_are_found_as_they_were_left(void **state) {
  (void)state;
  PluginHost *const host = open_drum();
  host_run(host, 100);
  host->knobs[KNOB_STRAINER] = 0;
  host->knobs[KNOB_BATTER_MUFFLING] = 3;
  host_run(host, 5000);
  HostState saved;
  host_save(host, &saved);
  PluginHost *const copy = open_drum();
  memcpy(copy->knobs, host->knobs, sizeof copy->knobs);
  assert_int_equal(host_restore(copy, &saved), LV2_STATE_SUCCESS);
  host_run(copy, 5000); /* where they glide to their values */
  record(host, first, 0, NULL);
  record(copy, second, 0, NULL);
  assert_same(first, second);
  host_state_free(&saved);
  host_close(host);
  host_close(copy);
}

/* Where pitches began at 0, sessions saved it in ports and states: the tension leads. Some hosts
 * bring a port into its range, which begins at 20 Hz. */
static void test_old_sessions_have_no_pitch(void **state) {
  (void)state;
  static const float none = 0;
  PluginHost *const host = open_changed();
  HostState saved;
  host_save(host, &saved);
  host_set_property(&saved, URI_STATE_CONTROL "batter_pitch", LV2_ATOM__Float, &none, sizeof none);
  host_set_property(&saved, URI_STATE_CONTROL "resonant_pitch", LV2_ATOM__Float, &none,
                    sizeof none);
  restart(host);
  record(host, first, 0, NULL);
  for (int knobs_first = 0; knobs_first <= 1; knobs_first++) {
    PluginHost *const copy = open_drum();
    memcpy(copy->knobs, host->knobs, sizeof copy->knobs);
    copy->knobs[KNOB_BATTER_PITCH] = none;
    copy->knobs[KNOB_RESONANT_PITCH] = 20;
    if (knobs_first) host_run(copy, 10);
    assert_int_equal(host_restore(copy, &saved), LV2_STATE_SUCCESS);
    record(copy, second, 0, NULL);
    assert_same(first, second);
    host_close(copy);
  }
  host_state_free(&saved);
  host_close(host);
}

/* Chosen, and not built yet. */
static void test_a_preset_that_is_on_its_way_is_saved(void **state) {
  (void)state;
  PluginHost *const host = host_open(host_descriptor(plugins, URI_DRUM), HOST_WORKER_REFUSES);
  HostState saved;
  choose(host, FRAME_DRUM);
  host_run(host, 100);
  host_save(host, &saved);
  const char *const text = host_property(&saved, URI_STATE_DEFINITION)->value;
  assert_non_null(strstr(text, "\nname = frame-drum\n"));
  host_state_free(&saved);
  host_close(host);
}

static void test_what_was_restored_is_saved_before_it_is_built(void **state) {
  (void)state;
  PluginHost *const host = open_changed();
  PluginHost *const copy = open_copy(host, false);
  HostState saved, again;
  host_save(host, &saved);
  host_save(copy, &again);
  assert_string_equal(host_property(&saved, URI_STATE_DEFINITION)->value,
                      host_property(&again, URI_STATE_DEFINITION)->value);
  host_state_free(&saved);
  host_state_free(&again);
  host_close(host);
  host_close(copy);
}

/* Controllers act on the restored drum as on the one that was left. */
static void test_a_knob_acts_on_a_restored_drum(void **state) {
  (void)state;
  PluginHost *const host = open_changed(), *const copy = open_copy(host, false);
  restart(host);
  host->knobs[KNOB_BATTER_TENSION] = copy->knobs[KNOB_BATTER_TENSION] = 3000;
  record(host, first, 0, NULL);
  record(copy, second, 0, NULL);
  assert_same(first, second);
  host_close(host);
  host_close(copy);
}

/* ---- the number of the drum ----------------------------------------------------------------- */

static void test_the_port_chooses_a_drum_as_midi_does(void **state) {
  (void)state;
  PluginHost *const host = open_drum(), *const chosen = open_drum();
  host->knobs[KNOB_DRUM] = FRAME_DRUM;
  choose(chosen, FRAME_DRUM);
  host_run(host, 100);
  host_run(chosen, 100);
  record(host, first, 0, NULL);
  record(chosen, second, 0, NULL);
  assert_same(first, second);
  host_close(host);
  host_close(chosen);
}

/* One that was chosen by its port and turned since. Hosts set ports before the state, after it, or
 * still later. */
static void test_a_restored_drum_stays_when_its_port_is_set(void **state) {
  (void)state;
  PluginHost *const host = open_drum();
  HostState saved;
  host->knobs[KNOB_DRUM] = FRAME_DRUM;
  host_run(host, 100);
  host->knobs[KNOB_BATTER_TENSION] = 2500;
  host_run(host, 100);
  host_save(host, &saved);
  restart(host);
  record(host, first, 0, NULL);
  for (int when = 0; when < 3; when++) {
    PluginHost *const copy = open_drum();
    if (when == 0) memcpy(copy->knobs, host->knobs, sizeof copy->knobs);
    if (when == 0) host_run(copy, 10);
    assert_int_equal(host_restore(copy, &saved), LV2_STATE_SUCCESS);
    if (when == 2) host_run(copy, 10);
    memcpy(copy->knobs, host->knobs, sizeof copy->knobs);
    host_run(copy, 10);
    restart(copy);
    record(copy, second, 0, NULL);
    assert_same(first, second);
    host_close(copy);
  }
  host_state_free(&saved);
  host_close(host);
}

/* Sessions from before do not say where the port stood: it is where it stands first. */
static void test_old_sessions_keep_their_drum(void **state) {
  (void)state;
  PluginHost *const host = open_changed(), *const copy = open_drum();
  HostState saved;
  host_save(host, &saved);
  (void)snprintf(host_property(&saved, URI_STATE_CONTROL "drum")->uri, 16, "urn:none");
  assert_int_equal(host_restore(copy, &saved), LV2_STATE_SUCCESS);
  memcpy(copy->knobs, host->knobs, sizeof copy->knobs);
  copy->knobs[KNOB_DRUM] = 0;
  restart(host);
  record(host, first, 0, NULL);
  record(copy, second, 0, NULL);
  assert_same(first, second);
  copy->knobs[KNOB_DRUM] = 10;
  restart(copy);
  record(copy, second, 0, NULL);
  assert_false(is_same(first, second));
  host_state_free(&saved);
  host_close(host);
  host_close(copy);
}

/* ---- what is wrong -------------------------------------------------------------------------- */

/* A state that is right but for one property, which is @p value. NULL: it is missing. */
static void refused(const char *property, const char *type, const void *value, size_t size,
                    const char *said) {
  PluginHost *const other = open_changed(), *const host = open_drum();
  HostState state;
  host_save(other, &state);
  if (value) {
    host_set_property(&state, property, type, value, size);
  } else {
    (void)snprintf(host_property(&state, property)->uri, 16, "urn:none");
  }
  host_run(host, 10);
  host->said[0] = '\0';
  if (host_restore(host, &state) == LV2_STATE_SUCCESS) fail_msg("restored with %s", property);
  if (!strstr(host->said, said)) fail_msg("%s: '%s', not '%s'", property, host->said, said);
  record(host, second, 0, NULL);
  assert_same(first, second);
  host_state_free(&state);
  host_close(host);
  host_close(other);
}

static void refused_definition(const char *text, const char *said) {
  refused(URI_STATE_DEFINITION, LV2_ATOM__String, text, strlen(text) + 1, said);
}

static void test_wrong_states_change_nothing(void **state) {
  (void)state;
  const int32_t later = STATE_VERSION + 1, never[] = {0, -1, INT32_MIN};
  const int64_t wide = STATE_VERSION;
  const double number = 1;
  static char endless[TABOR_TEXT_LIMIT + 2];
  memset(endless, 'x', sizeof endless);
  PluginHost *const host = open_drum();
  host_run(host, 10);
  record(host, first, 0, NULL);
  refused(URI_STATE_VERSION, NULL, NULL, 0, "it has no version");
  refused(URI_STATE_VERSION, LV2_ATOM__Int, &later, sizeof later, "of a later version");
  for (size_t i = 0; i < sizeof never / sizeof never[0]; i++) {
    refused(URI_STATE_VERSION, LV2_ATOM__Int, &never[i], sizeof never[i], "is not one of Tabor's");
  }
  refused(URI_STATE_VERSION, LV2_ATOM__Int, &wide, sizeof wide, "its version is none");
  refused(URI_STATE_VERSION, LV2_ATOM__Long, &wide, sizeof wide, "it has no version");
  refused(URI_STATE_DEFINITION, NULL, NULL, 0, "no definition");
  refused(URI_STATE_DEFINITION, LV2_ATOM__Int, &later, sizeof later, "no definition");
  refused(URI_STATE_DEFINITION, LV2_ATOM__String, endless, sizeof endless, "larger than");
  refused_definition("", "no section");
  refused_definition("shell.radius = 0.2\n", "no microphone");
  refused_definition("mic.top.gain = 1\nshell.radius", "is neither");
  refused_definition("mic.top.gain = 1\nshell.radius = 7\n", "shell.radius");
  refused_definition("mic.top.gain = 1\nshell.radius = wide\n", "shell.radius");
  refused_definition("mic.top.gain = 1\nstriker.a.mass = 0.01\nstrike.radius = 0.5\n",
                     "strike.radius");
  refused(URI_STATE_CONTROL "batter_tension", LV2_ATOM__Double, &number, sizeof number,
          "is no number");
  refused(URI_STATE_CONTROL "batter_tension", LV2_ATOM__Float, &number, sizeof number,
          "is no number");
  host_close(host);
}

static void test_an_empty_state_changes_nothing(void **state) {
  (void)state;
  const HostState empty = {.count = 0};
  PluginHost *const host = open_changed(), *const other = open_changed();
  assert_int_equal(host_restore(host, &empty), LV2_STATE_SUCCESS);
  assert_string_equal(host->said, "");
  record(host, first, 0, NULL);
  record(other, second, 0, NULL);
  assert_same(first, second);
  host_close(host);
  host_close(other);
}

/* A text need not be terminated; what later versions add is passed over. */
static void test_unknown_keys_are_passed_over(void **state) {
  (void)state;
  PluginHost *const host = open_changed(), *const copy = open_drum();
  HostState saved;
  char text[8192];
  host_save(host, &saved);
  const int length = snprintf(text, sizeof text, "shell.colour = red\nghosts.count = 3\n%s",
                              (const char *)host_property(&saved, URI_STATE_DEFINITION)->value);
  host_set_property(&saved, URI_STATE_DEFINITION, LV2_ATOM__String, text, (size_t)length);
  host_set_property(&saved, "urn:tabor:state:colour", LV2_ATOM__String, "red", 4);
  assert_int_equal(host_restore(copy, &saved), LV2_STATE_SUCCESS);
  memcpy(copy->knobs, host->knobs, sizeof copy->knobs);
  restart(host);
  record(host, first, 0, NULL);
  record(copy, second, 0, NULL);
  assert_same(first, second);
  host_state_free(&saved);
  host_close(host);
  host_close(copy);
}

/* ---- both plugins --------------------------------------------------------------------------- */

static void test_both_plugins_read_each_others_states(void **state) {
  (void)state;
  PluginHost *const host = open_changed();
  PluginHost *const multi =
    host_open(host_descriptor(plugins, URI_DRUM_MULTI), HOST_WITHOUT_WORKER);
  HostState saved, again;
  host_save(host, &saved);
  assert_int_equal(host_restore(multi, &saved), LV2_STATE_SUCCESS);
  host_save(multi, &again);
  assert_string_equal(host_property(&saved, URI_STATE_DEFINITION)->value,
                      host_property(&again, URI_STATE_DEFINITION)->value);
  host_state_free(&saved);
  host_state_free(&again);
  host_close(host);
  host_close(multi);
}

/* ---- files ---------------------------------------------------------------------------------- */

static bool has_mine(PluginHost *host) {
  HostState saved;
  host_save(host, &saved);
  const bool is_there = strstr(host_property(&saved, URI_STATE_DEFINITION)->value, "name = mine");
  host_state_free(&saved);
  return is_there;
}

/* The host's knobs stay where they are; the drum is the file's. What is no drum changes nothing. */
static void test_a_host_sets_the_file_of_a_drum(void **state) {
  (void)state;
  PluginHost *const host = open_drum();
  host_set_path(host, 0, URI_DRUM_FILE, user_file("kit.ini"));
  host_run(host, 64);
  assert_non_null(strstr(host->said, "kit.ini:1"));
  assert_false(has_mine(host));
  host_set_path(host, 0, URI_DRUM_FILE, user_file("drum.ini"));
  host_run(host, 64);
  host_note(host, 0, 38, 100);
  host_run(host, 4800);
  assert_true(host->ready == 1);
  assert_true(has_mine(host));
  assert_true(host_peak(host->sound[0], 4800) > 1e-3);
  host_close(host);
}

int main(int argc, char **argv) {
  if (argc < 2) return 1;
  plugins = argv[1];
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(test_restoring_a_ringing_drum_changes_no_bit),
    cmocka_unit_test(test_an_instance_is_found_as_it_was_left),
    cmocka_unit_test(test_live_knobs_are_found_as_they_were_left),
    cmocka_unit_test(test_old_sessions_have_no_pitch),
    cmocka_unit_test(test_a_preset_that_is_on_its_way_is_saved),
    cmocka_unit_test(test_what_was_restored_is_saved_before_it_is_built),
    cmocka_unit_test(test_a_knob_acts_on_a_restored_drum),
    cmocka_unit_test(test_the_port_chooses_a_drum_as_midi_does),
    cmocka_unit_test(test_a_restored_drum_stays_when_its_port_is_set),
    cmocka_unit_test(test_old_sessions_keep_their_drum),
    cmocka_unit_test(test_wrong_states_change_nothing),
    cmocka_unit_test(test_an_empty_state_changes_nothing),
    cmocka_unit_test(test_unknown_keys_are_passed_over),
    cmocka_unit_test(test_both_plugins_read_each_others_states),
    cmocka_unit_test_setup_teardown(test_a_host_sets_the_file_of_a_drum, user_files_make,
                                    user_files_remove),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
