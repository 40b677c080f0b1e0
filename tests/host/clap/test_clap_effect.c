/* SPDX-License-Identifier: MIT */
/*
 * The CLAP plugin Tabor Rattle: a loudspeaker plays what comes in to a snare drum. The drum alone
 * equals `tabor render
 * --input` to the bit, whatever the sizes of the blocks are; the mix, silence and bad samples do
 * what they should.
 *
 * test_clap_effect PROGRAM PLUGINS [brief]
 */
#include "clap_host.h"
#include "sound_burst.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#define SONG_FRAMES 24000u /* of a take */

static const clap_plugin_entry_t *entry;
static const char *program;

static ClapHost *open_effect(double mix) {
  ClapHost *const host = clap_host_open(entry, ID_EFFECT);
  clap_host_set(host, 0, KNOB_QUALITY, 0);
  clap_host_set(host, 0, KNOB_ROOM, TABOR_ROOM_NONE);
  clap_host_set(host, 0, KNOB_LEVEL_PAIR, 12);
  clap_host_set(host, 0, KNOB_LEVEL_BOTTOM, -60);
  clap_host_set(host, 0, KNOB_MIX, mix);
  clap_host_flush(host);
  clap_host_render(host, true);
  clap_host_activate(host);
  return host;
}

/* Plays the burst on both sides, in blocks of `block` frames. */
static void play_burst(ClapHost *host, uint32_t block, Take *take) {
  for (uint32_t at = 0; at < take->frames; at += block) {
    const uint32_t run = block < take->frames - at ? block : take->frames - at;
    for (uint32_t i = 0; i < run; i++) {
      host->input[0][i] = host->input[1][i] = burst_at(at + i);
    }
    clap_host_run(host, run);
    for (uint32_t side = 0; side < 2; side++) {
      memcpy(take->sound[side] + at, host->sound[side], run * sizeof(float));
    }
  }
}

/* Whatever the mix is, to the bit, and the host knows the switch. */
static void bypassed_it_passes_on_what_comes_in(void **state) {
  (void)state;
  Take take;
  take_open(&take, 2);
  ClapHost *const host = open_effect(1);
  const clap_plugin_params_t *const params = clap_host_extension(host, CLAP_EXT_PARAMS);
  clap_param_info_t info = {.id = CLAP_INVALID_ID};
  for (uint32_t i = 0; params->get_info(host->plugin, i, &info); i++)
    if (info.flags & CLAP_PARAM_IS_BYPASS) break;
  assert_true(info.flags & CLAP_PARAM_IS_BYPASS);
  assert_true(info.min_value == 0 && info.max_value == 1 && info.default_value == 0);
  clap_host_set_id(host, 0, info.id, 1);
  clap_host_run(host, CLAP_BLOCK); /* its fade */
  play_burst(host, 100, &take);
  double peak = 0;
  for (uint32_t i = 0; i < take.frames; i++) {
    assert_true(take.sound[0][i] == burst_at(i) && take.sound[1][i] == burst_at(i));
    peak = fmax(peak, fabs((double)take.sound[0][i]));
  }
  assert_true(peak > 0.01);
  clap_host_set_id(host, 0, info.id, 0);
  clap_host_run(host, CLAP_BLOCK);
  play_burst(host, 100, &take);
  uint32_t same = 0;
  for (uint32_t i = 0; i < take.frames; i++) same += take.sound[0][i] == burst_at(i);
  assert_true(same < take.frames / 2);
  clap_host_close(host);
  take_close(&take);
}

static void the_drum_is_that_of_render(void **state) {
  (void)state;
  static const uint32_t blocks[] = {CLAP_BLOCK, 100, 1};
  Take expected, take;
  take_open(&expected, 2);
  take_open(&take, 2);
  assert_int_equal(take.frames, SONG_FRAMES);
  burst_render(program, &expected);
  for (size_t i = 0; i < sizeof blocks / sizeof blocks[0]; i++) {
    ClapHost *const host = open_effect(1);
    play_burst(host, blocks[i], &take);
    take_compare(&expected, &take, blocks[i]);
    clap_host_close(host);
  }
  take_close(&expected);
  take_close(&take);
}

/* At 0 what comes in goes out; in between both add up in proportion. */
static void the_mix_is_a_sum(void **state) {
  (void)state;
  Take dry, wet, half;
  take_open(&dry, 2);
  take_open(&wet, 2);
  take_open(&half, 2);
  Take *const takes[] = {&dry, &half, &wet};
  for (int i = 0; i < 3; i++) {
    ClapHost *const host = open_effect(0.5 * i);
    play_burst(host, 480, takes[i]);
    clap_host_close(host);
  }
  for (uint32_t at = 0; at < dry.frames; at++) {
    const float in = burst_at(at);
    assert_true(dry.sound[0][at] == in && dry.sound[1][at] == in);
    const double sum = 0.5 * (double)in + 0.5 * (double)wet.sound[0][at];
    assert_true(fabs((double)half.sound[0][at] - sum) < 1e-7);
  }
  for (int i = 0; i < 3; i++) take_close(takes[i]);
}

/* Silence in is silence out, and the plugin sleeps; sound that is not a number does not reach the
 * drum. */
static void silence_and_bad_samples(void **state) {
  (void)state;
  ClapHost *const host = open_effect(0.5);
  clap_host_run(host, CLAP_BLOCK);
  for (uint32_t i = 0; i < CLAP_BLOCK; i++) assert_true(host->sound[0][i] == 0);
  assert_int_equal(host->status, CLAP_PROCESS_SLEEP);
  for (uint32_t i = 0; i < CLAP_BLOCK; i++) host->input[i % 2][i] = i % 3 ? NAN : INFINITY;
  clap_host_run(host, CLAP_BLOCK);
  memset(host->input, 0, sizeof host->input);
  for (int blocks = 0; blocks < 100 && host->status != CLAP_PROCESS_SLEEP; blocks++) {
    clap_host_run(host, CLAP_BLOCK);
    for (uint32_t i = 0; i < CLAP_BLOCK; i++) assert_true(isfinite(host->sound[0][i]));
  }
  assert_int_equal(host->status, CLAP_PROCESS_SLEEP);
  host->input[0][0] = 0.5f;
  clap_host_run(host, 64);
  assert_int_equal(host->status, CLAP_PROCESS_CONTINUE);
  clap_host_close(host);
}

/* The part of a mix may be too faint for a float, as clap-validator's fuzz has found. */
static void no_sample_is_subnormal(void **state) {
  (void)state;
  ClapHost *const host = open_effect(0.9);
  clap_host_run(host, 480); /* the mix glides */
  for (uint32_t i = 0; i < CLAP_BLOCK; i++) host->input[0][i] = host->input[1][i] = 2e-38f;
  clap_host_run(host, CLAP_BLOCK);
  for (uint32_t side = 0; side < 2; side++) {
    for (uint32_t i = 0; i < CLAP_BLOCK; i++) {
      assert_true(host->sound[side][i] == 0 || isnormal(host->sound[side][i]));
    }
  }
  clap_host_close(host);
}

/* The loudspeaker's level is one of pressure: 20 dB more is more rattle. */
static void louder_sound_rattles_more(void **state) {
  (void)state;
  double energies[2] = {0};
  Take take;
  take_open(&take, 2);
  for (int i = 0; i < 2; i++) {
    ClapHost *const host = open_effect(1);
    clap_host_set(host, 0, KNOB_SOUND, 100 + 20 * i);
    clap_host_run(host, 480); /* it glides */
    play_burst(host, 480, &take);
    for (uint32_t at = 0; at < take.frames; at++) energies[i] += pow((double)take.sound[0][at], 2);
    clap_host_close(host);
  }
  print_message("20 dB more: %.1f dB more\n", 10 * log10(energies[1] / energies[0]));
  assert_true(energies[1] > 30 * energies[0]);
  take_close(&take);
}

int main(int argc, char **argv) {
  if (argc < 3) return 1;
  program = argv[1];
  entry = clap_host_entry(argv[2]);
  if (!songs_begin(argv[1], true)) return 1;
  burst_make();
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(bypassed_it_passes_on_what_comes_in),
    cmocka_unit_test(the_drum_is_that_of_render),
    cmocka_unit_test(the_mix_is_a_sum),
    cmocka_unit_test(silence_and_bad_samples),
    cmocka_unit_test(no_sample_is_subnormal),
    cmocka_unit_test(louder_sound_rattles_more),
  };
  const int failed = cmocka_run_group_tests(tests, NULL, NULL);
  return songs_end() ? failed : 1;
}
