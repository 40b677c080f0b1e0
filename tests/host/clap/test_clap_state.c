/* SPDX-License-Identifier: MIT */
/*
 * What the CLAP plugins save and load: an instance is found as it was left, and a state that is
 * wrong changes nothing.
 *
 * test_clap_state PLUGINS
 */
#include "clap_host.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#define FRAMES 6000u
#define PART 500u           /* frames of a block */
#define GLIDE 4000u         /* frames in which live parameters reach their values */
#define HIGHEST_PITCH 522.5 /* [Hz] that the batter head of the usual drum can have */
#define FRAME_DRUM 1        /* place of the preset among the built-in ones */

static const clap_plugin_entry_t *entry;
static float first[FRAMES], second[FRAMES];
static ClapState saved, again;
/* Of an instance that open_changed() opens: its state, values and sound. */
static ClapState left;
static double left_values[KNOB_COUNT];
static float left_sound[FRAMES];

/* Not active. Its quality is set, and is saved with the rest. */
static ClapHost *open_drum(void) {
  ClapHost *const host = clap_host_open(entry, ID_DRUM);
  clap_host_set(host, 0, KNOB_QUALITY, CLAP_QUALITY(TABOR_QUALITY_DRAFT));
  clap_host_flush(host);
  clap_host_render(host, true);
  return host;
}

static ClapHost *open_active(void) {
  ClapHost *const host = open_drum();
  clap_host_activate(host);
  return host;
}

static void save_and_load(ClapHost *host) {
  clap_host_save(host, &saved);
  assert_true(clap_host_load(host, &saved));
}

/* Of the left side: a stroke, in the middle of which the state is saved and loaded or not. */
static void record(ClapHost *host, float *sound, bool loads) {
  double peak = 0;
  clap_host_midi(host, 0, &(MidiMessage){0x99, {38, 100}});
  for (uint32_t at = 0; at < FRAMES; at += PART) {
    if (loads && at == 4 * PART) save_and_load(host);
    clap_host_run(host, PART);
    memcpy(sound + at, host->sound[0], PART * sizeof(float));
    for (uint32_t i = 0; i < PART; i++) peak = fmax(peak, fabs((double)sound[at + i]));
  }
  assert_true(peak > 1e-3);
}

/* What the drum plays from the beginning, once live parameters have glided to their values. */
static void record_anew(ClapHost *host, float *sound) {
  if (host->is_active) clap_host_deactivate(host);
  clap_host_activate(host);
  clap_host_run(host, GLIDE);
  record(host, sound, false);
}

static void assert_same(const float *one, const float *other) {
  for (uint32_t i = 0; i < FRAMES; i++) {
    if (one[i] != other[i])
      fail_msg("frame %u: %.9g, %.9g", (unsigned)i, (double)one[i], (double)other[i]);
  }
}

static bool is_same(const float *one, const float *other) {
  return memcmp(one, other, FRAMES * sizeof *one) == 0;
}

static void assert_same_state(const ClapState *one, const ClapState *other) {
  assert_int_equal(one->size, other->size);
  assert_memory_equal(one->bytes, other->bytes, one->size);
}

static void set(ClapHost *host, KnobId knob, double value) {
  clap_host_set(host, 0, knob, value);
  clap_host_run(host, 100);
}

/* Knobs that were turned before and after another preset was chosen by MIDI. */
static ClapHost *open_changed(void) {
  ClapHost *const host = open_active();
  set(host, KNOB_STICK_HARDNESS, 0.3);
  set(host, KNOB_BATTER_TENSION, 0.7);
  clap_host_midi(host, 0, &(MidiMessage){0xC9, {FRAME_DRUM, 0}});
  clap_host_run(host, 100);
  set(host, KNOB_BATTER_TENSION, 0.5);
  set(host, KNOB_STRIKE_RADIUS, 0.11);
  set(host, KNOB_BATTER_MUFFLING, 1.5);
  set(host, KNOB_GAIN, -3);
  return host;
}

/* A group's set-up. */
static int leave(void **state) {
  (void)state;
  ClapHost *const host = open_changed();
  clap_host_save(host, &left);
  for (uint32_t i = 0; i < KNOB_COUNT; i++) {
    if (knob_is_in(KNOBS_STEREO, (KnobId)i)) left_values[i] = clap_host_value(host, (KnobId)i);
  }
  record_anew(host, left_sound);
  clap_host_close(host);
  return 0;
}

/* ---- found as left -------------------------------------------------------------------------- */

static void test_loading_into_a_ringing_drum_changes_no_bit(void **state) {
  (void)state;
  ClapHost *const one = open_active(), *const other = open_active();
  record(one, first, false);
  record(other, second, true);
  assert_same(first, second);
  assert_true(other->requests > 0);
  clap_host_close(one);
  clap_host_close(other);
}

static void found_as_left(ClapHost *copy) {
  assert_true(clap_host_load(copy, &left));
  assert_int_equal(copy->rescans, 1);
  clap_host_save(copy, &again);
  assert_same_state(&left, &again); /* also before the drum is built */
  record_anew(copy, second);
  assert_same(left_sound, second);
  clap_host_close(copy);
}

static void test_an_instance_is_found_as_it_was_left(void **state) {
  (void)state;
  ClapHost *const used = open_drum();
  record_anew(used, first);
  assert_false(is_same(left_sound, first));
  found_as_left(open_drum());
  found_as_left(open_active());
  clap_host_deactivate(used);
  found_as_left(used);
}

/* The drum that a control chooses stands in its own room at once, not only once the session is
 * opened again. */
static void test_a_chosen_drum_is_found_in_its_room(void **state) {
  (void)state;
  ClapHost *const host = open_active(), *const copy = open_drum();
  set(host, KNOB_DRUM, FRAME_DRUM);
  clap_host_run(host, GLIDE);
  record(host, first, false);
  clap_host_save(host, &saved);
  assert_true(clap_host_load(copy, &saved));
  record_anew(copy, second);
  assert_same(first, second);
  clap_host_close(host);
  clap_host_close(copy);
}

static void test_values_of_parameters_come_back(void **state) {
  (void)state;
  ClapHost *const copy = open_drum();
  assert_true(clap_host_load(copy, &left));
  for (uint32_t i = 0; i < KNOB_COUNT; i++) {
    if (!knob_is_in(KNOBS_STEREO, (KnobId)i)) continue;
    if (left_values[i] != clap_host_value(copy, (KnobId)i)) fail_msg("%s", knobs[i].symbol);
  }
  assert_true(clap_host_value(copy, KNOB_STRIKE_RADIUS) == 0.11);
  clap_host_close(copy);
}

/* Chosen in a block that cannot wait, and not built yet. */
static void test_a_preset_that_is_on_its_way_is_saved(void **state) {
  (void)state;
  ClapHost *const host = open_active();
  clap_host_render(host, false);
  clap_host_midi(host, 0, &(MidiMessage){0xC9, {FRAME_DRUM, 0}});
  clap_host_run(host, 1);
  clap_host_save(host, &saved);
  assert_non_null(strstr(saved.bytes, "\nname = frame-drum\n"));
  clap_host_close(host);
}

static void test_a_parameter_acts_on_a_restored_drum(void **state) {
  (void)state;
  ClapHost *const host = open_changed(), *const copy = open_active();
  assert_true(clap_host_load(copy, &left));
  set(host, KNOB_BATTER_TENSION, 0.6);
  set(copy, KNOB_BATTER_TENSION, 0.6);
  record_anew(host, first);
  record_anew(copy, second);
  assert_same(first, second);
  assert_false(is_same(first, left_sound));
  clap_host_close(host);
  clap_host_close(copy);
}

static void test_both_plugins_read_each_others_states(void **state) {
  (void)state;
  ClapHost *const multi = clap_host_open(entry, ID_DRUM_MULTI), *const copy = open_drum();
  assert_true(clap_host_load(multi, &left));
  clap_host_save(multi, &saved);
  assert_same_state(&left, &saved);
  assert_true(clap_host_load(copy, &saved));
  clap_host_save(copy, &again);
  assert_same_state(&left, &again);
  clap_host_close(copy);
  clap_host_close(multi);
}

/* ---- what is wrong -------------------------------------------------------------------------- */

static void set_state(ClapState *state, const char *text) {
  state->size = strlen(text);
  assert_true(state->size < CLAP_STATE);
  memcpy(state->bytes, text, state->size + 1);
}

/* The state @p from with @p other in place of the first @p part. */
static void replace_in(ClapState *from, const char *part, const char *other) {
  static char text[CLAP_STATE];
  from->bytes[from->size] = '\0';
  const char *const at = strstr(from->bytes, part);
  if (!at) fail_msg("the state has no '%s'", part);
  (void)snprintf(text, sizeof text, "%.*s%s%s", (int)(at - from->bytes), from->bytes, other,
                 at + strlen(part));
  set_state(&again, text);
}

/* The same with the state of the instance that was left. */
static void replace(const char *part, const char *other) { replace_in(&left, part, other); }

static void refused(ClapHost *host, const char *said) {
  host->said[0] = '\0';
  assert_false(clap_host_load(host, &again));
  if (!strstr(host->said, said)) fail_msg("'%s', not '%s'", host->said, said);
  assert_int_equal(host->rescans, 0);
}

static void refuse_all(ClapHost *host) {
  static const char *const parts[][3] = {
    {"tabor-state 1\n", "tabor-state 2\n", "not one of this version"},
    {"batter_tension ", "batter_tension x", "is no number"},
    {"batter_tension ", "batter_tension 7fc00000 7fc00000\nbatter_tension ", "is no number"},
    {"batter_tension ", "batter_tension", "is no number"},
    {"definition\n", "", "is no number"},
    {"[shell]\nradius = ", "[shell]\nradius = 7", "shell.radius"},
    {"[shell]\nradius = ", "[shell]\nradius = wide", "shell.radius"},
    {"[shell]\nradius = ", "[shell]\nradius", "is neither"}};
  static char endless[CLAP_STATE - 1];
  memset(endless, 'x', sizeof endless - 1);
  set_state(&again, "");
  refused(host, "not one of this version");
  set_state(&again, endless);
  refused(host, "cannot be read");
  for (size_t i = 0; i < sizeof parts / sizeof parts[0]; i++) {
    replace(parts[i][0], parts[i][1]);
    refused(host, parts[i][2]);
  }
}

static void test_wrong_states_change_nothing(void **state) {
  (void)state;
  ClapHost *const host = open_active(), *const other = open_active();
  record(host, first, false);
  refuse_all(other);
  record(other, second, false);
  assert_same(first, second);
  clap_host_close(host);
  clap_host_close(other);
}

/* What later versions add is passed over. */
static void test_unknown_lines_are_passed_over(void **state) {
  (void)state;
  replace("definition\n", "colour 3f800000 3f800000\ndefinition\nshell.colour = red\n");
  ClapHost *const copy = open_drum();
  assert_true(clap_host_load(copy, &again));
  assert_string_equal(copy->said, "");
  record_anew(copy, second);
  assert_same(left_sound, second);
  clap_host_close(copy);
}

/* ---- the number of the drum ----------------------------------------------------------------- */

static void set_all_as_left(ClapHost *host) {
  for (uint32_t i = 0; i < KNOB_COUNT; i++) {
    if (knob_is_in(KNOBS_STEREO, (KnobId)i)) clap_host_set(host, 0, (KnobId)i, left_values[i]);
  }
}

/* As hosts do that set all parameters, too; and in real time, where the drum is on its way. */
static void test_a_restored_drum_stays_when_its_number_is_set(void **state) {
  (void)state;
  ClapHost *const copy = open_active();
  assert_true(left_values[KNOB_DRUM] == FRAME_DRUM);
  clap_host_render(copy, false);
  assert_true(clap_host_load(copy, &left));
  set_all_as_left(copy);
  clap_host_run(copy, 1);
  clap_host_save(copy, &again);
  assert_same_state(&left, &again);
  clap_host_render(copy, true);
  clap_host_run(copy, 1);
  set_all_as_left(copy);
  clap_host_run(copy, 1);
  clap_host_save(copy, &again);
  assert_same_state(&left, &again);
  record_anew(copy, second);
  assert_same(left_sound, second);
  clap_host_close(copy);
}

/* Sessions from before have no such line: what comes first is where the drum was left. */
static void test_old_sessions_keep_their_drum(void **state) {
  (void)state;
  for (int number = 0; number <= 5; number += 5) {
    ClapHost *const copy = open_drum();
    replace("\ndrum ", "\ncolour ");
    assert_true(clap_host_load(copy, &again));
    clap_host_set(copy, 0, KNOB_DRUM, number);
    clap_host_flush(copy);
    record_anew(copy, second);
    assert_same(left_sound, second);
    set(copy, KNOB_DRUM, number + 1);
    record_anew(copy, second);
    assert_false(is_same(left_sound, second));
    clap_host_close(copy);
  }
}

/* ---- pitches -------------------------------------------------------------------------------- */

static void sounds_as_left_without_pitch(void) {
  ClapHost *const copy = open_drum();
  assert_true(clap_host_load(copy, &again));
  assert_string_equal(copy->said, "");
  assert_true(clap_host_value(copy, KNOB_BATTER_PITCH) == 0);
  assert_true(clap_host_value(copy, KNOB_RESONANT_PITCH) == 0);
  record_anew(copy, second);
  assert_same(left_sound, second);
  clap_host_close(copy);
}

/* Where pitches began at 0, sessions saved it: the tension leads. The name of the line is changed,
 * so that it is passed over, and an old one is put before it. Still older sessions have no pitch.
 */
static void test_old_sessions_have_no_pitch(void **state) {
  (void)state;
  replace("batter_pitch ", "batter_pitch 00000000 00000000\ncolour ");
  replace_in(&again, "resonant_pitch ", "resonant_pitch 00000000 00000000\ncolour ");
  sounds_as_left_without_pitch();
  replace("batter_pitch ", "colour ");
  replace_in(&again, "resonant_pitch ", "colour ");
  sounds_as_left_without_pitch();
}

/* As a host sets parameters to the values that they have, with the rounding of its own scale. */
static void test_values_that_stay_change_no_bit(void **state) {
  (void)state;
  static const double rounding = 1e-12;
  ClapHost *const one = open_active(), *const other = open_active();
  for (uint32_t i = 0; i < KNOB_COUNT; i++) {
    const KnobId id = (KnobId)i;
    if (!knob_is_in(KNOBS_STEREO, id)) continue;
    clap_host_set(other, 0, id, clap_host_value(other, id) * (1 + rounding));
  }
  clap_host_run(other, 100);
  clap_host_run(one, 100);
  record(one, first, false);
  record(other, second, false);
  assert_same(first, second);
  clap_host_close(one);
  clap_host_close(other);
}

/* The tension is that of the pitch, until the pitch is off. */
static void test_a_pitch_leads_the_tension(void **state) {
  (void)state;
  ClapHost *const host = open_active();
  record_anew(host, first);
  set(host, KNOB_BATTER_PITCH, clap_host_pitch(250));
  record_anew(host, second);
  assert_false(is_same(first, second));
  set(host, KNOB_BATTER_TENSION, 0.9);
  record_anew(host, first);
  assert_same(first, second);
  set(host, KNOB_BATTER_PITCH, 0);
  record_anew(host, first);
  assert_false(is_same(first, second));
  clap_host_close(host);
}

/* The head takes the nearest pitch, and the knob goes there, of which the host is told. */
static void test_a_pitch_out_of_reach_is_the_nearest(void **state) {
  (void)state;
  ClapHost *const host = open_active(), *const other = open_active(), *const copy = open_drum();
  set(host, KNOB_BATTER_PITCH, clap_host_pitch(850));
  set(other, KNOB_BATTER_PITCH, clap_host_pitch(HIGHEST_PITCH));
  record_anew(host, first);
  record_anew(other, second);
  assert_same(first, second);
  assert_true(clap_host_value(host, KNOB_BATTER_PITCH) == clap_host_pitch(HIGHEST_PITCH));
  assert_int_equal(host->callbacks, 1);
  host->plugin->on_main_thread(host->plugin);
  assert_int_equal(host->rescans, 1);
  host->plugin->on_main_thread(host->plugin);
  assert_int_equal(host->rescans, 1);
  assert_non_null(strstr(host->said, "the nearest pitch plays: batter.pitch = 850"));
  clap_host_save(host, &saved);
  assert_true(clap_host_load(copy, &saved));
  assert_true(clap_host_value(copy, KNOB_BATTER_PITCH) == clap_host_pitch(HIGHEST_PITCH));
  record_anew(copy, second);
  assert_same(first, second);
  clap_host_close(host);
  clap_host_close(other);
  clap_host_close(copy);
}

/* In sessions from before it did nothing: the drum is as it was, and the knob shows its pitch. */
static void test_an_old_pitch_out_of_reach_is_none(void **state) {
  (void)state;
  replace("batter_pitch ", "batter_pitch 44548000 44548000\ncolour "); /* 850 */
  replace_in(&again, "\npitch = ", "\npitch = 850\ncolour = ");
  ClapHost *const copy = open_drum();
  assert_true(clap_host_load(copy, &again));
  const double shown = clap_host_value(copy, KNOB_BATTER_PITCH);
  assert_true(shown > 0 && shown <= clap_host_pitch(HIGHEST_PITCH));
  record_anew(copy, second);
  assert_same(left_sound, second);
  assert_true(clap_host_value(copy, KNOB_BATTER_PITCH) == shown);
  clap_host_close(copy);
}

/* A value outside of a parameter's range, from a version whose range was wider, is brought into it.
 */
static void test_values_are_in_range(void **state) {
  (void)state;
  ClapHost *const host = open_drum();
  replace("gain ", "gain 7f7fffff 7f7fffff\ncolour ");
  assert_true(clap_host_load(host, &again));
  assert_true(clap_host_value(host, KNOB_GAIN) == 20);
  clap_host_close(host);
}

/* ---- sample rates --------------------------------------------------------------------------- */

static void activate_at(ClapHost *host, double rate) {
  if (host->is_active) clap_host_deactivate(host);
  assert_true(host->plugin->activate(host->plugin, rate, 1, CLAP_BLOCK));
  assert_true(host->plugin->start_processing(host->plugin));
  host->is_active = true;
}

static void test_the_drum_outlives_a_change_of_rate(void **state) {
  (void)state;
  ClapHost *const host = open_drum();
  assert_true(clap_host_load(host, &left));
  clap_host_activate(host);
  activate_at(host, 44100);
  record(host, second, false);
  assert_false(is_same(left_sound, second));
  activate_at(host, 8000); /* no models for it */
  assert_non_null(strstr(host->said, "8000 Hz"));
  host->plugin->reset(host->plugin);
  clap_host_midi(host, 0, &(MidiMessage){0x99, {38, 100}});
  clap_host_run(host, PART);
  for (uint32_t i = 0; i < PART; i++) assert_true(host->sound[0][i] == 0);
  activate_at(host, 48000);
  clap_host_run(host, GLIDE);
  record(host, second, false);
  assert_same(left_sound, second);
  clap_host_close(host);
}

/* As a preset a state brings the drum, and leaves how it is played and computed here. */
static void test_a_preset_leaves_the_players_knobs(void **state) {
  (void)state;
  ClapHost *const host = open_drum();
  clap_host_set(host, 0, KNOB_STRAINER, 0.25);
  clap_host_set(host, 0, KNOB_VELOCITY_CURVE, 2);
  clap_host_flush(host);
  clap_host_save(host, &saved);
  clap_host_set(host, 0, KNOB_STRAINER, 0.75);
  clap_host_set(host, 0, KNOB_VELOCITY_CURVE, 0);
  clap_host_set(host, 0, KNOB_QUALITY, CLAP_QUALITY(TABOR_QUALITY_STUDIO));
  clap_host_flush(host);
  assert_true(clap_host_load_in(host, &saved, CLAP_STATE_CONTEXT_FOR_PRESET));
  assert_true(clap_host_value(host, KNOB_STRAINER) == 0.25);
  assert_true(clap_host_value(host, KNOB_VELOCITY_CURVE) == 0);
  assert_true(clap_host_value(host, KNOB_QUALITY) == CLAP_QUALITY(TABOR_QUALITY_STUDIO));
  assert_true(clap_host_load_in(host, &saved, CLAP_STATE_CONTEXT_FOR_PROJECT));
  assert_true(clap_host_value(host, KNOB_VELOCITY_CURVE) == 2);
  assert_true(clap_host_value(host, KNOB_QUALITY) == CLAP_QUALITY(TABOR_QUALITY_DRAFT));
  clap_host_close(host);
}

int main(int argc, char **argv) {
  if (argc < 2) return 1;
  entry = clap_host_entry(argv[1]);
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(test_loading_into_a_ringing_drum_changes_no_bit),
    cmocka_unit_test(test_an_instance_is_found_as_it_was_left),
    cmocka_unit_test(test_a_preset_leaves_the_players_knobs),
    cmocka_unit_test(test_a_chosen_drum_is_found_in_its_room),
    cmocka_unit_test(test_values_of_parameters_come_back),
    cmocka_unit_test(test_a_preset_that_is_on_its_way_is_saved),
    cmocka_unit_test(test_a_parameter_acts_on_a_restored_drum),
    cmocka_unit_test(test_both_plugins_read_each_others_states),
    cmocka_unit_test(test_a_restored_drum_stays_when_its_number_is_set),
    cmocka_unit_test(test_old_sessions_keep_their_drum),
    cmocka_unit_test(test_wrong_states_change_nothing),
    cmocka_unit_test(test_unknown_lines_are_passed_over),
    cmocka_unit_test(test_old_sessions_have_no_pitch),
    cmocka_unit_test(test_values_that_stay_change_no_bit),
    cmocka_unit_test(test_a_pitch_leads_the_tension),
    cmocka_unit_test(test_a_pitch_out_of_reach_is_the_nearest),
    cmocka_unit_test(test_an_old_pitch_out_of_reach_is_none),
    cmocka_unit_test(test_values_are_in_range),
    cmocka_unit_test(test_the_drum_outlives_a_change_of_rate),
  };
  return cmocka_run_group_tests(tests, leave, NULL);
}
