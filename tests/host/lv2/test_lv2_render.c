/* SPDX-License-Identifier: MIT */
/*
 * The plugins play a MIDI file as `tabor render --midi-file` does, to the bit, whatever the sizes
 * of the runs are.
 *
 * test_lv2_render PROGRAM PLUGINS [brief | songs NUMBER]
 */
#include "plugin_host.h"

#include "drums/stereo_pair.h" /* before cmocka, which takes the name of fail() */

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "lv2/uris.h"
#include "plugin_songs.h"

static const char *plugins;
static bool brief;
static unsigned random_songs = 2;

/* ---- both ways ------------------------------------------------------------------------------ */

static const char rendered[] = "render -o", performed[] = "play --backend file --record";

static void play(PluginHost *host, uint32_t block, Take *take) {
  host->freewheel = 1;
  host_play(host, song.messages, song.count, take->frames, block, take->sound);
}

static const char *const pair[] = {"left", "right"};
static const char *const all[] = {"top", "bottom", "near", "far", "left", "right", "inside"};

/* ---- tests ---------------------------------------------------------------------------------- */

/* The plugin, set by @p prepare before the first run, in runs of these sizes. */
static void same_in_plugin(const char *uri, const Take *expected, void (*prepare)(PluginHost *),
                           const uint32_t *blocks, size_t count) {
  Take take;
  take_open(&take, expected->channels);
  for (size_t i = 0; i < (brief ? 1 : count); i++) {
    PluginHost *const host = host_open(host_descriptor(plugins, uri), HOST_WITHOUT_WORKER);
    host->knobs[KNOB_LEVEL_PAIR] = STEREO_GAIN_DB;
    if (prepare) prepare(host);
    play(host, blocks[i], &take);
    take_compare(expected, &take, blocks[i]);
    host_close(host);
  }
  take_close(&take);
}

static void same_as_render(const char *uri, const char *options, void (*prepare)(PluginHost *),
                           const uint32_t *blocks, size_t count) {
  const bool stereo = strcmp(uri, URI_DRUM) == 0;
  Take expected;
  take_open(&expected, instrument_kinds[stereo ? INSTRUMENT_STEREO : INSTRUMENT_MULTI].channels);
  take_from(rendered, options, stereo ? pair : all, &expected);
  same_in_plugin(uri, &expected, prepare, blocks, count);
  take_close(&expected);
}

static void at_draft(PluginHost *host) { host->knobs[KNOB_QUALITY] = 0; }

static void test_runs_of_every_size(void **state) {
  (void)state;
  static const uint32_t blocks[] = {37, 1, 64, 1000, HOST_BLOCK, 0, 0};
  song_write_all();
  same_as_render(URI_DRUM, "--quality draft", at_draft, blocks, 7);
}

static void test_the_usual_quality_is_live(void **state) {
  (void)state;
  static const uint32_t blocks[] = {256};
  song_write_all();
  same_as_render(URI_DRUM, "--quality live", NULL, blocks, 1);
}

static void in_a_studio(PluginHost *host) {
  at_draft(host);
  host->knobs[KNOB_ROOM] = TABOR_ROOM_STUDIO;
}

/* But for the quality, which keeps the test short. */
static void test_the_usual_sound_is_stereo(void **state) {
  (void)state;
  static const uint32_t blocks[] = {512, 0};
  song_write_all();
  same_as_render(URI_DRUM, "--quality draft --stereo", in_a_studio, blocks, 2);
}

static void test_an_output_per_microphone(void **state) {
  (void)state;
  static const uint32_t blocks[] = {512, 0};
  song_write_all();
  same_as_render(URI_DRUM_MULTI, "--quality draft", at_draft, blocks, 2);
}

static void test_program_changes(void **state) {
  (void)state;
  static const uint32_t blocks[] = {100, 4096, 0};
  song_write_presets();
  same_as_render(URI_DRUM, "--quality draft", at_draft, blocks, 3);
}

/* In a room, which hears the same, and in runs of random sizes. */
static void same_everywhere(void) {
  static const char options[] = "--quality draft --set room.kind=studio";
  static const uint32_t blocks[] = {0};
  Take expected, take;
  take_open(&expected, 2);
  take_open(&take, 2);
  take_from(rendered, options, pair, &expected);
  same_in_plugin(URI_DRUM, &expected, in_a_studio, blocks, 1);
  if (!brief) {
    take_from(performed, options, pair, &take);
    take_compare(&expected, &take, 0);
  }
  take_close(&expected);
  take_close(&take);
}

static void test_changes_of_all_kinds(void **state) {
  (void)state;
  static void (*const songs[])(void) = {song_write_other_mics,       song_write_two_at_once,
                                        song_write_there_and_back,   song_write_one_after_the_other,
                                        song_write_moved_before,     song_write_silences,
                                        song_write_stacked_silences, song_write_panic,
                                        song_write_many_gains,       song_write_within_a_frame};
  for (size_t i = 0; i < sizeof songs / sizeof songs[0]; i++) {
    print_message("song %u\n", (unsigned)i + 1);
    songs[i]();
    same_everywhere();
  }
}

static void test_random_songs(void **state) {
  (void)state;
  for (uint64_t seed = 1; seed <= (brief ? 1 : random_songs); seed++) {
    print_message("seed %u\n", (unsigned)seed);
    song_write_random(seed);
    same_everywhere();
  }
}

static void scattered(PluginHost *host) {
  at_draft(host);
  host->knobs[KNOB_HUMANIZE] = 0.3f;
}

/* By the size of the drum that they fall on. */
static void test_strokes_are_scattered_on_their_drum(void **state) {
  (void)state;
  static const uint32_t blocks[] = {100};
  Take expected, take;
  take_open(&expected, 2);
  take_open(&take, 2);
  song_write_sizes();
  same_as_render(URI_DRUM, "--quality draft --humanize 0.3", scattered, blocks, 1);
  take_from(rendered, "--quality draft --humanize 0.3", pair, &expected);
  take_from("play --backend file --record", "--quality draft --humanize 0.3", pair, &take);
  take_compare(&expected, &take, 0);
  take_close(&expected);
  take_close(&take);
}

static void test_a_change_at_live(void **state) {
  (void)state;
  static const uint32_t blocks[] = {512};
  if (brief) {
    print_message("SKIPPED: it takes too long under sanitizers\n");
    skip();
  }
  song_write_two_at_once();
  same_as_render(URI_DRUM, "--quality live", NULL, blocks, 1);
}

/* ---- what a program change is ---- */

enum { CHANGED = 60, FADE = 1440 }; /* ticks; frames of 30 ms */

static const uint32_t change_frame = CHANGED * 48000 / 2 / DIVISION;

/* Of two numbers of single precision, 2^-24 each: after the fade and not before it. */
static const double ROUNDING = 1.2e-7;

/* The old drum at its own microphones, under the fade and nothing else; the new one is not struck.
 */
static void test_the_old_drum_rings_out(void **state) {
  (void)state;
  Take ringing, changed;
  take_open(&ringing, 2);
  take_open(&changed, 2);
  song_begin_ringing();
  song_end();
  take_from(rendered, "--quality draft", pair, &ringing);
  song_begin_ringing();
  song_add(CHANGED, 0xC9, TOM, 0);
  song_end();
  take_from(rendered, "--quality draft", pair, &changed);
  for (uint32_t channel = 0; channel < 2; channel++) {
    for (uint32_t at = 0; at < changed.frames; at++) {
      const uint32_t gone = at < change_frame ? 0 : at - change_frame;
      const double part = at < change_frame ? 1 : gone < FADE ? (FADE - gone) / (FADE + 1.0) : 0;
      const double expected = part * (double)ringing.sound[channel][at];
      const double off = (double)changed.sound[channel][at] - expected;
      if (fabs(off) > ROUNDING * fabs(expected)) fail_msg("frame %u", (unsigned)at);
    }
    assert_true(host_peak(changed.sound[channel] + change_frame, FADE) > 1e-3);
  }
  take_close(&ringing);
  take_close(&changed);
}

static void write_change(bool moves) {
  song_begin_ringing();
  if (moves) {
    song_add(10, 0xB9, 20, 0);
    song_add(0, 0xB9, 1, 127);
  }
  song_add(CHANGED - (moves ? 10 : 0), 0xC9, LOOSE, 0);
  song_end_struck();
}

/* These two drums are alike enough to be continued, which would keep what was moved. */
static void test_live_values_begin_anew(void **state) {
  (void)state;
  Take plain, moved;
  take_open(&plain, 2);
  take_open(&moved, 2);
  write_change(false);
  take_from(rendered, "--quality draft", pair, &plain);
  write_change(true);
  take_from(rendered, "--quality draft", pair, &moved);
  const uint32_t first = change_frame + FADE;
  const size_t size = (plain.frames - first) * sizeof(float);
  for (uint32_t channel = 0; channel < 2; channel++) {
    const float *const a = plain.sound[channel], *const b = moved.sound[channel];
    assert_memory_not_equal(a, b, change_frame * sizeof(float));
    assert_memory_equal(a + first, b + first, size);
    assert_true(host_peak(a + first, plain.frames - first) > 1e-3);
  }
  take_close(&plain);
  take_close(&moved);
}

static void turned(PluginHost *host) {
  in_a_studio(host);
  host->knobs[KNOB_BATTER_TENSION] = 4321;
  host->knobs[KNOB_STICK_HARDNESS] = 5e6f;
  host->knobs[KNOB_STRIKE_RADIUS] = 0.08f;
  host->knobs[KNOB_STRIKE_ANGLE] = -45;
  host->knobs[KNOB_VELOCITY_CURVE] = 2;
  host->knobs[KNOB_VELOCITY_RANGE] = 1;
  host->knobs[KNOB_HUMANIZE] = 0.7f;
  host->knobs[KNOB_GAIN] = -3.3f;
  host->knobs[KNOB_STICK] = 5; /* 7A nylon: a tip as hard as 16/9 of one of wood */
}

static void test_knobs_are_options(void **state) {
  (void)state;
  static const uint32_t blocks[] = {256, 0};
  song_write_all();
  same_as_render(URI_DRUM,
                 "--quality draft --set batter.tension=4321 --set "
                 "striker.stick.contact_stiffness=8888888.888888888 "
                 "--set striker.stick.mass=0.0084 --set striker.stick.bending_frequency=387 "
                 "--set strike.radius=0.08 --set strike.angle=-45 --velocity-curve hard "
                 "--velocity-range full --humanize 0.7 --gain -3.3 --stereo",
                 turned, blocks, 2);
}

static void test_silence_is_exactly_zero(void **state) {
  (void)state;
  PluginHost *const host = host_open(host_descriptor(plugins, URI_DRUM), HOST_WITHOUT_WORKER);
  at_draft(host);
  host->freewheel = 1;
  for (int run = 0; run < 20; run++) {
    host_run(host, 512);
    for (uint32_t i = 0; i < 2; i++) assert_true(host_peak(host->sound[i], 512) == 0);
  }
  host_note(host, 5, 38, 100);
  host_run(host, 5);
  assert_true(host_peak(host->sound[0], 5) == 0);
  host_close(host);
}

int main(int argc, char **argv) {
  if (argc < 3) return 1;
  plugins = argv[2];
  brief = argc == 4;
  if (argc == 5) random_songs = (unsigned)atoi(argv[4]);
  if (!songs_begin(argv[1], brief)) return 1;
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(test_runs_of_every_size),
    cmocka_unit_test(test_the_usual_quality_is_live),
    cmocka_unit_test(test_the_usual_sound_is_stereo),
    cmocka_unit_test(test_an_output_per_microphone),
    cmocka_unit_test(test_program_changes),
    cmocka_unit_test(test_changes_of_all_kinds),
    cmocka_unit_test(test_random_songs),
    cmocka_unit_test(test_strokes_are_scattered_on_their_drum),
    cmocka_unit_test(test_a_change_at_live),
    cmocka_unit_test(test_the_old_drum_rings_out),
    cmocka_unit_test(test_live_values_begin_anew),
    cmocka_unit_test(test_knobs_are_options),
    cmocka_unit_test(test_silence_is_exactly_zero),
  };
  const struct CMUnitTest songs[] = {cmocka_unit_test(test_random_songs)};
  const int failed = argc == 5 ? cmocka_run_group_tests(songs, NULL, NULL)
                               : cmocka_run_group_tests(tests, NULL, NULL);
  return songs_end() ? failed : 1;
}
