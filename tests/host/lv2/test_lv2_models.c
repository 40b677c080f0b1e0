/* SPDX-License-Identifier: MIT */
/*
 * The plugins' models: built beside the audio thread, shared by instances with equal definitions,
 * and swapped without a click.
 */
#include "plugin_host.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <cmocka.h>

#include "lv2/uris.h"
#include "plugin/model_cache.h"
#include "processor_time.h"

static const LV2_Descriptor *plugin(const char *uri) {
  const LV2_Descriptor *const descriptor = lv2_descriptor(strcmp(uri, URI_DRUM) == 0 ? 0 : 1);
  assert_string_equal(descriptor->URI, uri);
  return descriptor;
}

static PluginHost *open_at_draft(const char *uri, HostWorker worker) {
  PluginHost *const host = host_open(plugin(uri), worker);
  host->knobs[KNOB_QUALITY] = 0;
  host->knobs[KNOB_HUMANIZE] = 0; /* equal strokes are compared */
  return host;
}

/* ---- when models are built ------------------------------------------------------------------ */

/* The smallest of some trials: others are at work on the machine, too. */
static void test_instantiation_is_quick(void **state) {
  (void)state;
  double least = 1;
  for (int i = 0; i < 5; i++) {
    const double start = processor_time();
    PluginHost *const host = host_open(plugin(URI_DRUM), HOST_WORKER_REFUSES);
    least = fmin(least, processor_time() - start);
    assert_int_equal(model_cache_count(), 0);
    host_close(host);
  }
  printf("instantiate: %.2f ms of the processor\n", 1000 * least);
  assert_true(least < 0.05);
}

static void silent_until_ready(HostWorker worker) {
  PluginHost *const host = open_at_draft(URI_DRUM, worker);
  host_note(host, 0, 38, 100);
  host_run(host, 256);
  if (host->ready < 1) assert_true(host_peak(host->sound[0], 256) == 0);
  host_wait(host);
  host_note(host, 0, 38, 100);
  host_run(host, 4096);
  assert_true(host_peak(host->sound[0], 4096) > 1e-3);
  host_close(host);
}

static void test_silent_until_the_model_is_there(void **state) {
  (void)state;
  silent_until_ready(HOST_WORKER_THREAD);
  silent_until_ready(HOST_WITHOUT_WORKER);
  silent_until_ready(HOST_WORKER_AT_ONCE);
}

/* It is asked again and again, and freewheeling does without it. */
static void test_a_worker_that_refuses(void **state) {
  (void)state;
  PluginHost *const host = open_at_draft(URI_DRUM, HOST_WORKER_REFUSES);
  for (int i = 0; i < 20; i++) host_run(host, 64);
  assert_true(host->ready < 1);
  assert_true(atomic_load(&host->asked) > 10);
  host->freewheel = 1;
  host_note(host, 0, 38, 100);
  host_run(host, 4096);
  assert_true(host->ready >= 1);
  assert_true(host_peak(host->sound[0], 4096) > 1e-3);
  host_close(host);
}

static void test_freewheeling_takes_over_what_a_worker_has_begun(void **state) {
  (void)state;
  PluginHost *const host = open_at_draft(URI_DRUM, HOST_WORKER_THREAD);
  for (int i = 0; i < 20; i++) {
    host->freewheel = 0;
    host->knobs[KNOB_BATTER_TENSION] = 3000 + 10 * (float)i;
    host_run(host, 64);
    host->freewheel = 1;
    host_note(host, 0, 38, 100);
    host_run(host, 64);
    assert_true(host->ready >= 1);
  }
  host_close(host);
}

/* A rate that there are no models for. */
static void test_rates(void **state) {
  (void)state;
  const LV2_Descriptor *const descriptor = plugin(URI_DRUM);
  LV2_URID_Map urids = {NULL, host_map_feature};
  const LV2_Feature map_feature = {LV2_URID__map, &urids};
  const LV2_Feature *const features[] = {&map_feature, NULL}, *const none[] = {NULL};
  const double rates[] = {0, -48000, NAN, 16000, 384000};
  for (size_t i = 0; i < sizeof rates / sizeof rates[0]; i++) {
    assert_null(descriptor->instantiate(descriptor, rates[i], "/", features));
  }
  assert_null(descriptor->instantiate(descriptor, 48000, "/", none));
  LV2_Handle const handle = descriptor->instantiate(descriptor, 44100, "/", features);
  assert_non_null(handle);
  descriptor->cleanup(handle);
}

/* ---- what is shared ------------------------------------------------------------------------- */

static void test_equal_drums_share_a_model(void **state) {
  (void)state;
  PluginHost *const one = open_at_draft(URI_DRUM, HOST_WORKER_AT_ONCE), *const other =
                                                                          open_at_draft(
                                                                            URI_DRUM_MULTI,
                                                                            HOST_WORKER_AT_ONCE);
  host_wait(one);
  host_wait(other);
  assert_int_equal(model_cache_count(), 1);
  other->knobs[KNOB_STRIKE_RADIUS] = 0.1f; /* is in no model */
  other->knobs[KNOB_RESONANT_TENSION] = 2000;
  host_run(other, 64);
  host_wait(other);
  assert_int_equal(model_cache_count(), 2);
  one->knobs[KNOB_RESONANT_TENSION] = 2000;
  host_run(one, 64);
  host_wait(one);
  assert_int_equal(model_cache_count(), 1);
  one->knobs[KNOB_QUALITY] = 1;
  host_run(one, 64);
  host_wait(one);
  assert_int_equal(model_cache_count(), 2);
  host_close(one);
  assert_int_equal(model_cache_count(), 1);
  host_close(other);
  assert_int_equal(model_cache_count(), 0);
}

/* ---- pitches -------------------------------------------------------------------------------- */

static void turn(PluginHost *host, KnobId id, double value) {
  host->knobs[id] = (float)value;
  host_run(host, 64);
  host_wait(host);
}

static double tension_for(const char *key, const char *pitch, bool resonant) {
  TaborDrumDef def;
  assert_int_equal(tabor_drum_def_preset(&def, DEFAULT_PRESET, NULL), TABOR_OK);
  assert_int_equal(tabor_drum_def_set(&def, key, pitch, NULL), TABOR_OK);
  assert_int_equal(tabor_drum_def_tune(&def, NULL), TABOR_OK);
  return resonant ? def.resonant.tension : def.batter.tension;
}

/* Drums with the same tensions share a model. */
static bool are_alike(void) { return model_cache_count() == 1; }

/* A pitch counts whatever the tension says, until it is 0 again; one out of reach is the nearest.
 */
static void test_a_pitch_takes_the_place_of_the_tension(void **state) {
  (void)state;
  PluginHost *const one = open_at_draft(URI_DRUM, HOST_WORKER_AT_ONCE), *const other =
                                                                          open_at_draft(
                                                                            URI_DRUM_MULTI,
                                                                            HOST_WORKER_AT_ONCE);
  turn(one, KNOB_BATTER_PITCH, 220);
  turn(one, KNOB_RESONANT_PITCH, 330);
  turn(other, KNOB_BATTER_TENSION, tension_for("batter.pitch", "220", false));
  assert_false(are_alike());
  turn(other, KNOB_RESONANT_TENSION, tension_for("resonant.pitch", "330", true));
  assert_true(are_alike());
  turn(one, KNOB_BATTER_TENSION, 3000);
  assert_true(are_alike());
  turn(other, KNOB_BATTER_TENSION, 3000);
  assert_false(are_alike());
  turn(one, KNOB_BATTER_PITCH, 850); /* the resonant head keeps its own */
  assert_non_null(strstr(one->said, "the nearest pitch plays: batter.pitch = 850 is outside"));
  turn(other, KNOB_BATTER_PITCH, 522.5);
  assert_true(are_alike());
  turn(other, KNOB_BATTER_PITCH, 0);
  assert_false(are_alike());
  turn(one, KNOB_BATTER_PITCH, 0);
  assert_true(are_alike());
  host_close(one);
  host_close(other);
}

/* A saved drum knows its pitch, and the tension that comes back without it. */
static void test_a_pitch_is_saved(void **state) {
  (void)state;
  PluginHost *const one = open_at_draft(URI_DRUM, HOST_WORKER_AT_ONCE), *const other =
                                                                          open_at_draft(
                                                                            URI_DRUM,
                                                                            HOST_WORKER_AT_ONCE);
  HostState saved;
  host_wait(other);
  turn(one, KNOB_BATTER_PITCH, 220);
  host_save(one, &saved);
  assert_int_equal(host_restore(other, &saved), LV2_STATE_SUCCESS);
  turn(other, KNOB_BATTER_PITCH, 220); /* as a host sets its ports */
  assert_true(are_alike());
  turn(one, KNOB_BATTER_PITCH, 0);
  assert_false(are_alike());
  turn(other, KNOB_BATTER_PITCH, 0);
  assert_true(are_alike());
  host_state_free(&saved);
  host_close(one);
  host_close(other);
}

/* ---- swaps ---------------------------------------------------------------------------------- */

/* The largest bend of the curve: a click is a corner. */
static double sharpest(const float *sound, uint32_t count) {
  double most = 0;
  for (uint32_t i = 2; i < count; i++) {
    most = fmax(most, fabs((double)sound[i] - 2 * (double)sound[i - 1] + (double)sound[i - 2]));
  }
  return most;
}

/* Rings for a moment, so that the stroke itself is over; snares are off, for they rattle. */
static PluginHost *open_ringing(float *sound, uint32_t frames) {
  PluginHost *const host = open_at_draft(URI_DRUM, HOST_WORKER_AT_ONCE);
  host->knobs[KNOB_STRAINER] = 0;
  host_wait(host);
  for (int i = 0; i < 20; i++) host_run(host, 1024);
  host_note(host, 0, 38, 90);
  for (int i = 0; i < 2; i++) host_run(host, 1024);
  host_run(host, frames);
  memcpy(sound, host->sound[0], frames * sizeof(float));
  return host;
}

enum { HALF = 2048 };

static void change_without_click(void (*change)(PluginHost *)) {
  static float sound[2 * HALF];
  PluginHost *const host = open_ringing(sound, HALF);
  const double before = sharpest(sound, HALF);
  change(host);
  for (int at = HALF; at < 2 * HALF; at += HALF / 4) { /* a model that it takes lands meanwhile */
    host_run(host, HALF / 4);
    memcpy(sound + at, host->sound[0], HALF / 4 * sizeof(float));
  }
  assert_true(host->ready >= 1);
  assert_true(host_peak(sound + HALF, HALF) > 1e-4);
  const double across = sharpest(sound + HALF - 2, HALF + 2);
  printf("bends: %.3g before, %.3g from the change on\n", before, across);
  assert_true(across < 1.5 * before);
  host_close(host);
}

static void retune(PluginHost *host) { host->knobs[KNOB_BATTER_TENSION] = 3700; }
static void retune_by_pitch(PluginHost *host) { host->knobs[KNOB_BATTER_PITCH] = 290; }
static void change_preset(PluginHost *host) {
  host_event(host, 0, 2, (const uint8_t[]){0xC9, 10}); /* tom-12 */
}
static void muffle(PluginHost *host) { host->knobs[KNOB_BATTER_MUFFLING] = 10; }
static void turn_down(PluginHost *host) { host->knobs[KNOB_GAIN] = -20; }
static void change_mics(PluginHost *host) {
  host->knobs[KNOB_LEVEL_PAIR] = -6;
  host->knobs[KNOB_LEVEL_FAR] = -12;
}

static void test_changes_make_no_click(void **state) {
  (void)state;
  change_without_click(retune);
  change_without_click(retune_by_pitch);
  change_without_click(change_preset);
  change_without_click(muffle);
  change_without_click(turn_down);
  change_without_click(change_mics);
}

/* A corner would be seen. */
static void test_a_click_would_be_seen(void **state) {
  (void)state;
  static float sound[HALF];
  PluginHost *const host = open_ringing(sound, HALF);
  const double before = sharpest(sound, HALF);
  for (int i = HALF / 2; i < HALF; i++) sound[i] *= 0.7f;
  assert_true(sharpest(sound, HALF) > 1.5 * before);
  host_close(host);
}

/* ---- what acts on what ---------------------------------------------------------------------- */

/* The snares that MIDI has thrown off stay off while the drum is retuned, and are on again with
 * another preset. */
static void test_what_midi_has_moved_outlives_a_retuning(void **state) {
  (void)state;
  enum { LONG = 8000 };
  static float off[LONG], retuned[LONG];
  PluginHost *const host = open_at_draft(URI_DRUM, HOST_WORKER_AT_ONCE), *const other =
                                                                           open_at_draft(
                                                                             URI_DRUM,
                                                                             HOST_WORKER_AT_ONCE);
  other->knobs[KNOB_STRAINER] = 0;
  PluginHost *const both[] = {host, other};
  for (int i = 0; i < 2; i++) {
    host_wait(both[i]);
    if (i == 0) host_event(host, 0, 3, (const uint8_t[]){0xB9, 20, 0});
    host_run(both[i], 500);
    both[i]->knobs[KNOB_BATTER_TENSION] = 4000;
    host_run(both[i], 64);
    host_wait(both[i]);
    for (int run = 0; run < 30; run++) host_run(both[i], 4096); /* until it is quiet */
    host_note(both[i], 0, 38, 110);
    host_run(both[i], LONG);
    memcpy(i == 0 ? retuned : off, both[i]->sound[0], sizeof off);
  }
  double difference = 0;
  for (int i = 0; i < LONG; i++) {
    difference = fmax(difference, fabs((double)off[i] - (double)retuned[i]));
  }
  printf("difference %.3g of a peak of %.3g\n", difference, host_peak(off, LONG));
  assert_true(difference < 1e-3 * host_peak(off, LONG));
  host_close(host);
  host_close(other);
}

static void throw_snares_on(PluginHost *host) {
  host_event(host, 4, 2, (const uint8_t[]){0xC9, SNARE_OFF});
  host_event(host, 5, 3, (const uint8_t[]){0xB9, 20, 127});
  host_run(host, 64);
}

/* While it waits for silences, another drum lands. */
static void throw_snares_on_in_haste(PluginHost *host) {
  host_note(host, 0, 38, 110);
  host_run(host, 64);
  host_event(host, 0, 3, (const uint8_t[]){0xB9, 120, 0});
  host_event(host, 1, 2, (const uint8_t[]){0xC9, LOOSE});
  host_note(host, 2, 38, 110); /* which the next silence is for */
  host_event(host, 3, 3, (const uint8_t[]){0xB9, 120, 0});
  host_event(host, 4, 2, (const uint8_t[]){0xC9, SNARE_OFF});
  host_event(host, 5, 3, (const uint8_t[]){0xB9, 20, 127});
  for (int run = 0; run < 40; run++) host_run(host, 64);
}

static void play_after(void (*prepare)(PluginHost *), float *sound, uint32_t frames) {
  PluginHost *const host = open_at_draft(URI_DRUM, HOST_WORKER_AT_ONCE);
  host_wait(host);
  prepare(host);
  host_wait(host);
  for (int run = 0; run < 30; run++) host_run(host, 4096); /* until it is quiet */
  host_note(host, 0, 38, 110);
  host_run(host, frames);
  memcpy(sound, host->sound[0], frames * sizeof *sound);
  host_close(host);
}

static void test_what_waits_is_for_the_newest_drum(void **state) {
  (void)state;
  enum { LONG = 8000 };
  static float expected[LONG], hasty[LONG];
  play_after(throw_snares_on, expected, LONG);
  play_after(throw_snares_on_in_haste, hasty, LONG);
  double difference = 0;
  for (int i = 0; i < LONG; i++) {
    difference = fmax(difference, fabs((double)expected[i] - (double)hasty[i]));
  }
  printf("difference %.3g of a peak of %.3g\n", difference, host_peak(expected, LONG));
  assert_true(difference < 1e-3 * host_peak(expected, LONG));
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(test_instantiation_is_quick),
    cmocka_unit_test(test_silent_until_the_model_is_there),
    cmocka_unit_test(test_a_worker_that_refuses),
    cmocka_unit_test(test_freewheeling_takes_over_what_a_worker_has_begun),
    cmocka_unit_test(test_rates),
    cmocka_unit_test(test_equal_drums_share_a_model),
    cmocka_unit_test(test_a_pitch_takes_the_place_of_the_tension),
    cmocka_unit_test(test_a_pitch_is_saved),
    cmocka_unit_test(test_changes_make_no_click),
    cmocka_unit_test(test_a_click_would_be_seen),
    cmocka_unit_test(test_what_midi_has_moved_outlives_a_retuning),
    cmocka_unit_test(test_what_waits_is_for_the_newest_drum),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
