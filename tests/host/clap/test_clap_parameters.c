/* SPDX-License-Identifier: MIT */
/*
 * The parameters of the CLAP plugins: their ids, ranges, texts, and which can be modulated.
 *
 * test_clap_parameters PLUGINS
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

/* Of the range: texts have six digits, per cent have four, and notes have whole cents. */
#define TEXT_TOLERANCE 1e-5
#define PER_CENT_TOLERANCE 1e-4 /* of the root of a value: half of 0.01 %, twice for the square */
#define NOTE_TOLERANCE 7.7e-5   /* of the way from 20 to 900 Hz: half a cent */

static const clap_plugin_entry_t *entry;

static const clap_plugin_params_t *params_of(const ClapHost *host) {
  return clap_host_extension(host, CLAP_EXT_PARAMS);
}

static clap_param_info_t info_of(const ClapHost *host, uint32_t index) {
  clap_param_info_t info;
  assert_true(params_of(host)->get_info(host->plugin, index, &info));
  return info;
}

static void text_of(const ClapHost *host, clap_id id, double value, char text[64]) {
  assert_true(params_of(host)->value_to_text(host->plugin, id, value, text, 64));
}

/* ---- ids ------------------------------------------------------------------------------------ */

/* A session of any version has them. The order is that of ids. */
static const char *const symbols[] = {"batter_tension",
                                      "resonant_tension",
                                      "batter_muffle_strength",
                                      "resonant_muffle_strength",
                                      "wires_strainer",
                                      "wires_tension",
                                      "striker_contact_stiffness",
                                      "strike_radius",
                                      "strike_angle",
                                      "velocity_curve",
                                      "humanize",
                                      "quality_level",
                                      "gain",
                                      "level_pair",
                                      "level_top",
                                      "level_bottom",
                                      "level_near",
                                      "level_far",
                                      "velocity_range",
                                      "level_inside",
                                      "batter_pitch",
                                      "resonant_pitch",
                                      "room",
                                      "wires_unevenness"};

#define SYMBOLS (sizeof symbols / sizeof symbols[0])

static void test_ids_do_not_change(void **state) {
  (void)state;
  ClapHost *const host = clap_host_open(entry, ID_DRUM);
  assert_true(params_of(host)->count(host->plugin) >= SYMBOLS);
  for (uint32_t i = 0; i < SYMBOLS; i++) {
    const clap_param_info_t info = info_of(host, i);
    assert_int_equal(info.id, i);
    assert_string_equal(knobs[knob_ports[i]].symbol, symbols[i]);
    assert_string_equal(info.name, knobs[knob_ports[i]].name);
  }
  const clap_param_info_t stick = info_of(host, SYMBOLS); /* behind the two of the effect */
  assert_int_equal(stick.id, SYMBOLS + 2);
  assert_string_equal(stick.name, "Stick");
  const clap_param_info_t drum = info_of(host, SYMBOLS + 1); /* behind another one of the effect */
  assert_int_equal(drum.id, SYMBOLS + 4);
  assert_string_equal(drum.name, "Drum");
  clap_host_close(host);
}

/* In the plugin with an output per microphone, the same control has the same id. */
static void test_the_multi_plugin_has_no_mix(void **state) {
  (void)state;
  ClapHost *const host = clap_host_open(entry, ID_DRUM_MULTI);
  const uint32_t count = params_of(host)->count(host->plugin);
  double value;
  assert_int_equal(count, SYMBOLS + 2 - 7); /* and the stick and the drum */
  for (uint32_t i = 0; i < count; i++) {
    const clap_param_info_t info = info_of(host, i);
    assert_string_equal(info.name, knobs[knob_ports[info.id]].name);
    assert_true(knob_is_in(KNOBS_MULTI, knob_ports[info.id]));
  }
  assert_false(params_of(host)->get_value(host->plugin, clap_host_id(KNOB_ROOM), &value));
  clap_host_close(host);
}

static void test_there_are_no_others(void **state) {
  (void)state;
  static const clap_id none[] = {KNOB_COUNT, 1000, CLAP_INVALID_ID};
  ClapHost *const host = clap_host_open(entry, ID_DRUM);
  const clap_plugin_params_t *const params = params_of(host);
  clap_param_info_t info;
  char text[64];
  double value;
  for (size_t i = 0; i < sizeof none / sizeof none[0]; i++) {
    assert_false(params->get_info(host->plugin, none[i], &info));
    assert_false(params->get_value(host->plugin, none[i], &value));
    assert_false(params->value_to_text(host->plugin, none[i], 0, text, sizeof text));
    assert_false(params->text_to_value(host->plugin, none[i], "1", &value));
  }
  clap_host_close(host);
}

/* ---- ranges --------------------------------------------------------------------------------- */

static void test_defaults_are_in_range(void **state) {
  (void)state;
  ClapHost *const host = clap_host_open(entry, ID_DRUM);
  for (uint32_t i = 0; i < SYMBOLS; i++) {
    const clap_param_info_t info = info_of(host, i);
    double value;
    assert_true(params_of(host)->get_value(host->plugin, info.id, &value));
    assert_true(info.min_value < info.max_value);
    assert_true(info.min_value <= info.default_value && info.default_value <= info.max_value);
    assert_true(value == info.default_value);
    assert_true(strlen(info.module) > 0);
  }
  clap_host_close(host);
}

/* Scales in equal ratios begin at 0, to the bit, and end at 1. */
static void test_logarithmic_scales_are_whole(void **state) {
  (void)state;
  static const KnobId ids[] = {KNOB_BATTER_TENSION, KNOB_RESONANT_TENSION, KNOB_WIRE_TENSION,
                               KNOB_STICK_HARDNESS, KNOB_BATTER_PITCH,     KNOB_RESONANT_PITCH};
  ClapHost *const host = clap_host_open(entry, ID_DRUM);
  for (size_t i = 0; i < sizeof ids / sizeof *ids; i++) {
    const clap_param_info_t info = info_of(host, clap_host_id(ids[i]));
    assert_int_equal(info.id, clap_host_id(ids[i]));
    if (info.min_value != 0 || info.max_value != 1)
      fail_msg("%s: %.9g to %.9g", info.name, info.min_value, info.max_value);
  }
  clap_host_close(host);
}

/* An octave has the same way everywhere, and off is the beginning alone. */
static void test_pitches_are_in_equal_ratios(void **state) {
  (void)state;
  const double octave = clap_host_pitch(440) - clap_host_pitch(220);
  ClapHost *const host = clap_host_open(entry, ID_DRUM);
  char text[64];
  assert_true(fabs(clap_host_pitch(80) - clap_host_pitch(40) - octave) < 1e-12);
  assert_true(clap_host_pitch(900) == 1 && clap_host_pitch(0) == 0);
  assert_true(octave > 0.15); /* it was 0.024 from 22 Hz on, and 0.5 from 450 Hz on */
  text_of(host, clap_host_id(KNOB_BATTER_PITCH), clap_host_pitch(20), text);
  assert_string_equal(text, "Eb0 +49 ct");
  clap_host_close(host);
}

static void set(ClapHost *host, KnobId knob, double value) {
  clap_host_set(host, 0, knob, value);
  clap_host_flush(host);
}

static void test_values_stay_in_range(void **state) {
  (void)state;
  ClapHost *const host = clap_host_open(entry, ID_DRUM);
  set(host, KNOB_GAIN, 1000);
  assert_true(clap_host_value(host, KNOB_GAIN) == 20);
  set(host, KNOB_GAIN, -INFINITY);
  assert_true(clap_host_value(host, KNOB_GAIN) == 20);
  set(host, KNOB_GAIN, NAN);
  assert_true(clap_host_value(host, KNOB_GAIN) == 20);
  set(host, KNOB_GAIN, -1e300);
  assert_true(clap_host_value(host, KNOB_GAIN) == -60);
  set(host, KNOB_GAIN, 1e300); /* infinite as a float */
  assert_true(clap_host_value(host, KNOB_GAIN) == 20);
  set(host, KNOB_QUALITY, 1e300);
  assert_true(clap_host_value(host, KNOB_QUALITY) == 3);
  set(host, KNOB_BATTER_TENSION, 2);
  assert_true(clap_host_value(host, KNOB_BATTER_TENSION) == 1);
  set(host, KNOB_QUALITY, 2.9);
  assert_true(clap_host_value(host, KNOB_QUALITY) == 2);
  clap_host_close(host);
}

/* ---- texts ---------------------------------------------------------------------------------- */

static void says(const ClapHost *host, KnobId knob, double value, const char *expected) {
  char text[64];
  text_of(host, clap_host_id(knob), value, text);
  assert_string_equal(text, expected);
}

/* Half way from 100 to 20,000 on a logarithmic scale is the root of their product. */
static void test_texts_have_units(void **state) {
  (void)state;
  ClapHost *const host = clap_host_open(entry, ID_DRUM);
  says(host, KNOB_BATTER_TENSION, 0, "100 N/m");
  says(host, KNOB_BATTER_TENSION, 0.5, "1414.21 N/m");
  says(host, KNOB_BATTER_TENSION, 1, "20000 N/m");
  says(host, KNOB_BATTER_PITCH, 0, "Off");
  says(host, KNOB_BATTER_PITCH, clap_host_pitch(220), "A3");
  says(host, KNOB_BATTER_PITCH, clap_host_pitch(221.53), "A3 +12 ct");
  says(host, KNOB_BATTER_MUFFLING, 0, "Open");
  says(host, KNOB_BATTER_MUFFLING, 7.5, "50 %"); /* a quarter of the range */
  says(host, KNOB_STRAINER, 0, "Off");
  says(host, KNOB_STRAINER, 0.25, "25 %");
  says(host, KNOB_STRAINER, 0.99999, "On");
  says(host, KNOB_STRAINER, 1, "On");
  says(host, KNOB_STICK_HARDNESS, 0.75, "75 %");
  says(host, KNOB_UNEVENNESS, 0, "Straight");
  says(host, KNOB_UNEVENNESS, 1.5, "150 %");
  says(host, KNOB_GAIN, -60, "Off");
  says(host, KNOB_GAIN, -3, "-3 dB");
  says(host, KNOB_QUALITY, 1, "Live");
  says(host, KNOB_ROOM, 3, "Hall");
  says(host, KNOB_STICK, 0, "The drum's own");
  says(host, KNOB_STICK, 6, "5A nylon");
  says(host, KNOB_ROOM, 1e300, "Hall");
  says(host, KNOB_GAIN, 1e300, "20 dB");
  says(host, KNOB_GAIN, -INFINITY, "Off");
  clap_host_close(host);
}

static double tolerance_of(KnobId id, double value, double range) {
  if (knobs[id].scale == KNOB_IN_NOTES) return NOTE_TOLERANCE;
  if (knobs[id].scale == KNOB_IN_ROOTS) return PER_CENT_TOLERANCE * sqrt(value * range);
  return TEXT_TOLERANCE * range;
}

static void come_back(const ClapHost *host, const clap_param_info_t *info, double part) {
  const bool is_stepped = (info->flags & CLAP_PARAM_IS_STEPPED) != 0;
  const double range = info->max_value - info->min_value;
  const double exact = info->min_value + part * range, value = is_stepped ? trunc(exact) : exact;
  char text[64], again[64];
  double read = NAN;
  text_of(host, info->id, value, text);
  if (!params_of(host)->text_to_value(host->plugin, info->id, text, &read)) fail_msg("%s", text);
  if (!(fabs(read - value) <= tolerance_of(knob_ports[info->id], value, range)))
    fail_msg("%s: %.9g, not %.9g", text, read, value);
  text_of(host, info->id, read, again);
  assert_string_equal(text, again);
}

/* The text is the same again. Per cent are coarser than six digits, so these parts have no more. */
static void test_texts_are_read_back(void **state) {
  (void)state;
  static const double parts[] = {0, 0.01, 0.1234, 0.5, 0.8, 0.99, 1};
  ClapHost *const host = clap_host_open(entry, ID_DRUM);
  for (uint32_t i = 0; i < SYMBOLS; i++) {
    const clap_param_info_t info = info_of(host, i);
    for (size_t k = 0; k < sizeof parts / sizeof parts[0]; k++) come_back(host, &info, parts[k]);
  }
  clap_host_close(host);
}

static void reads(const ClapHost *host, KnobId knob, const char *text, double expected) {
  double value = NAN;
  if (!params_of(host)->text_to_value(host->plugin, clap_host_id(knob), text, &value))
    fail_msg("%s", text);
  if (!(fabs(value - expected) <= 1e-9 * fabs(expected))) fail_msg("%s: %.9g", text, value);
}

static void test_texts_of_players_are_read(void **state) {
  (void)state;
  ClapHost *const host = clap_host_open(entry, ID_DRUM);
  reads(host, KNOB_BATTER_PITCH, "A3", clap_host_pitch(220));
  reads(host, KNOB_BATTER_PITCH, "A#3 -5", clap_host_pitch(220 * pow(2, 95 / 1200.0)));
  reads(host, KNOB_BATTER_PITCH, "220 Hz", clap_host_pitch(220));
  reads(host, KNOB_BATTER_PITCH, "off", 0);
  reads(host, KNOB_BATTER_PITCH, "2000", 1); /* the highest */
  reads(host, KNOB_BATTER_MUFFLING, "open", 0);
  reads(host, KNOB_BATTER_MUFFLING, "50 %", 7.5);
  reads(host, KNOB_BATTER_MUFFLING, "-50", 0);
  reads(host, KNOB_BATTER_MUFFLING, "2 N s/m", 2);
  reads(host, KNOB_STRAINER, "on", 1);
  reads(host, KNOB_STRAINER, "50", 0.5);
  reads(host, KNOB_GAIN, "-3", -3);
  clap_host_close(host);
}

static void test_other_texts_are_refused(void **state) {
  (void)state;
  static const char *const texts[] = {"", "loud", "nan", "inf"};
  ClapHost *const host = clap_host_open(entry, ID_DRUM);
  double value;
  for (uint32_t i = 0; i < SYMBOLS; i++) {
    const clap_id id = info_of(host, i).id;
    for (size_t k = 0; k < sizeof texts / sizeof texts[0]; k++) {
      assert_false(params_of(host)->text_to_value(host->plugin, id, texts[k], &value));
    }
  }
  clap_host_close(host);
}

/* ---- modulation ----------------------------------------------------------------------------- */

static void test_what_is_live_can_be_modulated(void **state) {
  (void)state;
  static const KnobId live[] = {KNOB_BATTER_MUFFLING,
                                KNOB_RESONANT_MUFFLING,
                                KNOB_STRAINER,
                                KNOB_WIRE_TENSION,
                                KNOB_GAIN,
                                KNOB_LEVEL_PAIR,
                                KNOB_LEVEL_TOP,
                                KNOB_LEVEL_BOTTOM,
                                KNOB_LEVEL_NEAR,
                                KNOB_LEVEL_FAR,
                                KNOB_LEVEL_INSIDE};
  ClapHost *const host = clap_host_open(entry, ID_DRUM);
  uint32_t count = 0;
  for (uint32_t i = 0; i < SYMBOLS; i++) {
    count += (info_of(host, i).flags & CLAP_PARAM_IS_MODULATABLE) != 0;
  }
  for (size_t i = 0; i < sizeof live / sizeof live[0]; i++) {
    const uint32_t flags = info_of(host, clap_host_id(live[i])).flags;
    if (!(flags & CLAP_PARAM_IS_MODULATABLE)) fail_msg("%s", knobs[live[i]].symbol);
  }
  assert_int_equal(count, sizeof live / sizeof live[0]);
  clap_host_close(host);
}

/* The value is the knob's; the modulation comes on top of it. */
static void test_modulation_moves_no_value(void **state) {
  (void)state;
  ClapHost *const host = clap_host_open(entry, ID_DRUM);
  const double before = clap_host_value(host, KNOB_STRAINER);
  clap_host_modulate(host, 0, KNOB_STRAINER, -0.5);
  clap_host_flush(host);
  assert_true(clap_host_value(host, KNOB_STRAINER) == before);
  clap_host_close(host);
}

int main(int argc, char **argv) {
  if (argc < 2) return 1;
  entry = clap_host_entry(argv[1]);
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(test_ids_do_not_change),
    cmocka_unit_test(test_the_multi_plugin_has_no_mix),
    cmocka_unit_test(test_there_are_no_others),
    cmocka_unit_test(test_defaults_are_in_range),
    cmocka_unit_test(test_logarithmic_scales_are_whole),
    cmocka_unit_test(test_pitches_are_in_equal_ratios),
    cmocka_unit_test(test_values_stay_in_range),
    cmocka_unit_test(test_texts_have_units),
    cmocka_unit_test(test_texts_are_read_back),
    cmocka_unit_test(test_texts_of_players_are_read),
    cmocka_unit_test(test_other_texts_are_refused),
    cmocka_unit_test(test_what_is_live_can_be_modulated),
    cmocka_unit_test(test_modulation_moves_no_value),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
