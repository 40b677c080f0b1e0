/* SPDX-License-Identifier: MIT */
/*
 * The CLAP plugins play a MIDI file as `tabor render --midi-file` does, to the bit, whatever the
 * sizes of the blocks are; parameters act at their frames, as the same move by MIDI does.
 *
 * test_clap_render PROGRAM PLUGINS [brief | songs NUMBER]
 *
 * `songs` plays whole songs in all sizes of blocks, and NUMBER random ones; otherwise songs are
 * cut.
 */
#include "clap_songs.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#define QUICK_BLOCKS 3 /* sizes of blocks that the check tries for a song */

static const clap_plugin_entry_t *entry;
static bool brief, thorough;
static unsigned random_songs = 1;

static const char rendered[] = "render -o";
static const char *const pair[] = {"left", "right"};
static const char *const all[] = {"left", "right", "top", "bottom", "near", "far", "inside"};

/* ---- both ways ------------------------------------------------------------------------------ */

/* Active and offline. */
static ClapHost *open_host(const char *id, double quality, double room) {
  ClapHost *const host = clap_host_open(entry, id);
  clap_host_set(host, 0, KNOB_QUALITY, quality);
  if (host->stereo) clap_host_set(host, 0, KNOB_ROOM, room);
  clap_host_flush(host);
  clap_host_render(host, true);
  clap_host_activate(host);
  return host;
}

/* How many of `count` sizes of blocks are tried. The most telling ones come first. */
static size_t tried(size_t count) {
  if (brief) return 1;
  return thorough || count < QUICK_BLOCKS ? count : QUICK_BLOCKS;
}

static void same(const char *id, const char *options, double quality, double room,
                 const uint32_t *blocks, size_t count) {
  const bool stereo = strcmp(id, ID_DRUM) == 0;
  Take expected, take;
  take_open(&expected, stereo ? 2 : 7);
  take_open(&take, expected.channels);
  take_from(rendered, options, stereo ? pair : all, &expected);
  for (size_t i = 0; i < tried(count); i++) {
    ClapHost *const host = open_host(id, quality, room);
    clap_host_play(host, blocks[i], 0, &take);
    take_compare(&expected, &take, blocks[i]);
    clap_host_close(host);
  }
  take_close(&expected);
  take_close(&take);
}

/* ---- songs ---------------------------------------------------------------------------------- */

static void test_blocks_of_every_size(void **state) {
  (void)state;
  static const uint32_t blocks[] = {1, 0, CLAP_BLOCK, 37, 64, 1000, 0};
  song_write_all();
  same(ID_DRUM, "--quality draft", 0, TABOR_ROOM_NONE, blocks, 7);
}

/* Live takes three times as long as draft. */
static void test_the_usual_quality(void **state) {
  (void)state;
  static const uint32_t blocks[] = {256};
  if (!thorough) return;
  song_write_all();
  same(ID_DRUM, "--quality live", 1, TABOR_ROOM_NONE, blocks, 1);
}

static void test_an_output_per_microphone(void **state) {
  (void)state;
  static const uint32_t blocks[] = {512, 0};
  song_write_all();
  same(ID_DRUM_MULTI, "--quality draft", 0, TABOR_ROOM_NONE, blocks, thorough ? 2 : 1);
}

static void test_program_changes_in_a_room(void **state) {
  (void)state;
  static void (*const songs[])(void) = {song_write_there_and_back, song_write_within_a_frame,
                                        song_write_two_at_once, song_write_moved_before,
                                        song_write_stacked_silences};
  static const uint32_t blocks[] = {0, 100};
  for (size_t i = 0; i < (thorough ? sizeof songs / sizeof songs[0] : 2); i++) {
    print_message("song %u\n", (unsigned)i + 1);
    songs[i]();
    same(ID_DRUM, "--quality draft --set room.kind=studio", 0, TABOR_ROOM_STUDIO, blocks,
         thorough ? 2 : 1);
  }
}

static void test_random_songs(void **state) {
  (void)state;
  static const uint32_t blocks[] = {0};
  for (uint64_t seed = 1; seed <= random_songs; seed++) {
    print_message("seed %u\n", (unsigned)seed);
    song_write_random(seed);
    same(ID_DRUM, "--quality draft --stereo", 0, TABOR_ROOM_STUDIO, blocks, 1);
  }
}

/* ---- CLAP's own events ---------------------------------------------------------------------- */

/* A moment of playing, in one of two ways. */
typedef void Play(ClapHost *host);

static void play_moment(Play *play, uint32_t block, Take *take) {
  ClapHost *const host = open_host(ID_DRUM, 0, TABOR_ROOM_NONE);
  ClapEvent events[CLAP_EVENTS];
  play(host);
  const uint32_t count = host->event_count;
  memcpy(events, host->events, sizeof events);
  host->event_count = 0;
  take->frames = CLAP_BLOCK;
  uint32_t next = 0;
  for (uint32_t at = 0; at < take->frames; at += block) {
    for (; next < count && events[next].header.time < at + block; next++) {
      host->events[host->event_count] = events[next];
      host->events[host->event_count++].header.time -= at;
    }
    clap_host_run(host, block);
    for (uint32_t i = 0; i < 2; i++) {
      memcpy(take->sound[i] + at, host->sound[i], block * sizeof(float));
    }
  }
  clap_host_close(host);
}

static void same_moments(Play *one, Play *other) {
  static const uint32_t blocks[] = {CLAP_BLOCK, 128, 1};
  Take expected, take;
  take_open(&expected, 2);
  take_open(&take, 2);
  play_moment(one, CLAP_BLOCK, &expected);
  for (size_t i = 0; i < (brief ? 2 : 3); i++) {
    play_moment(other, blocks[i], &take);
    take_compare(&expected, &take, blocks[i]);
  }
  take_close(&expected);
  take_close(&take);
}

static void midi(ClapHost *host, uint32_t time, uint8_t status, uint8_t first, uint8_t second) {
  clap_host_midi(host, time, &(MidiMessage){status, {first, second}});
}

/* The strainer is a live parameter, which controller 20 moves, too: 0 is off, 127 on. */
static void by_controller(ClapHost *host) {
  midi(host, 0, 0x99, 38, 100);
  midi(host, 1001, 0xB9, 20, 0);
  midi(host, 3333, 0xB9, 20, 127);
  midi(host, 3333, 0x99, 38, 90);
}

static void by_parameter(ClapHost *host) {
  midi(host, 0, 0x99, 38, 100);
  clap_host_set(host, 1001, KNOB_STRAINER, 0);
  clap_host_set(host, 3333, KNOB_STRAINER, 1);
  midi(host, 3333, 0x99, 38, 90);
}

static void by_modulation(ClapHost *host) {
  midi(host, 0, 0x99, 38, 100);
  clap_host_modulate(host, 1001, KNOB_STRAINER, -1);
  clap_host_modulate(host, 3333, KNOB_STRAINER, 0);
  midi(host, 3333, 0x99, 38, 90);
}

/* Wires that come back to a ringing head touch it at another instant; wires that leave it may be in
 * the air. */
static void a_frame_later(ClapHost *host) {
  midi(host, 0, 0x99, 38, 100);
  clap_host_set(host, 1001, KNOB_STRAINER, 0);
  clap_host_set(host, 3334, KNOB_STRAINER, 1);
  midi(host, 3333, 0x99, 38, 90);
}

static void test_parameters_act_at_their_frames(void **state) {
  (void)state;
  Take one, other;
  same_moments(by_controller, by_parameter);
  same_moments(by_controller, by_modulation);
  take_open(&one, 2);
  take_open(&other, 2);
  play_moment(by_parameter, CLAP_BLOCK, &one);
  play_moment(a_frame_later, CLAP_BLOCK, &other);
  assert_memory_not_equal(one.sound[0], other.sound[0], CLAP_BLOCK * sizeof(float));
  take_close(&one);
  take_close(&other);
}

static void in_midi(ClapHost *host) {
  midi(host, 5, 0xB9, 16, 64);
  midi(host, 5, 0x99, 38, 100);
  midi(host, 900, 0x89, 38, 64);
  midi(host, 1500, 0xB9, 88, 64);
  midi(host, 1500, 0x99, 38, 50);
  midi(host, 2000, 0xA9, 38, 127);
  midi(host, 2500, 0xA9, 38, 0);
  midi(host, 3000, 0x99, 38, 120);
  midi(host, 5000, 0xB9, 120, 0);
}

static void in_clap(ClapHost *host) {
  clap_host_express(host, 5, CLAP_NOTE_EXPRESSION_BRIGHTNESS, 38, 0.5);
  clap_host_note(host, 5, CLAP_EVENT_NOTE_ON, 38, 100 / 127.0);
  clap_host_note(host, 900, CLAP_EVENT_NOTE_OFF, 38, 0.5);
  clap_host_note(host, 1500, CLAP_EVENT_NOTE_ON, 38, 50.5 / 127);
  clap_host_express(host, 2000, CLAP_NOTE_EXPRESSION_PRESSURE, 38, 1);
  clap_host_express(host, 2500, CLAP_NOTE_EXPRESSION_PRESSURE, 38, 0);
  clap_host_note(host, 3000, CLAP_EVENT_NOTE_ON, 38, 120 / 127.0);
  clap_host_note(host, 5000, CLAP_EVENT_NOTE_CHOKE, -1, 0);
}

static void test_both_dialects_mean_the_same(void **state) {
  (void)state;
  same_moments(in_midi, in_clap);
}

static double loudest(const ClapHost *host, uint32_t frames) {
  double peak = 0;
  for (uint32_t i = 0; i < frames; i++) peak = fmax(peak, fabs((double)host->sound[0][i]));
  return peak;
}

/* Notes and a choke in one block, or at one frame of it. Returns the peak of what is heard. */
static double heard(int16_t note, int16_t choke, bool choke_first, bool of_midi) {
  ClapHost *const host = open_host(ID_DRUM, 0, TABOR_ROOM_NONE);
  if (choke_first) clap_host_note(host, 5, CLAP_EVENT_NOTE_CHOKE, choke, 0);
  if (of_midi) {
    midi(host, 5, 0x99, (uint8_t)note, 100);
  } else {
    clap_host_note(host, 5, CLAP_EVENT_NOTE_ON, note, 0.8);
  }
  if (!choke_first) clap_host_note(host, 5, CLAP_EVENT_NOTE_CHOKE, choke, 0);
  clap_host_run(host, CLAP_BLOCK);
  assert_int_equal(host->ended, 1);
  const double peak = loudest(host, CLAP_BLOCK);
  clap_host_close(host);
  return peak;
}

/* At one frame the order of the list counts: a note that is choked as it begins is not heard. */
static void test_a_choke_at_the_frame_of_its_notes(void **state) {
  (void)state;
  assert_true(heard(38, 38, false, false) == 0);
  assert_true(heard(38, -1, false, false) == 0);
  assert_true(heard(38, 38, false, true) == 0);
  assert_true(heard(38, -1, true, false) > 1e-3);
  assert_true(heard(38, 38, true, true) > 1e-3);
  assert_true(heard(38, 41, false, false) > 1e-3);
}

static void test_note_ends_and_sleep(void **state) {
  (void)state;
  ClapHost *const host = open_host(ID_DRUM, 0, TABOR_ROOM_NONE);
  clap_host_run(host, 64);
  assert_int_equal(host->status, CLAP_PROCESS_SLEEP);
  clap_host_note(host, 0, CLAP_EVENT_NOTE_ON, 38, 0.8);
  clap_host_note(host, 10, CLAP_EVENT_NOTE_OFF, 38, 0.8);
  clap_host_run(host, 64);
  assert_int_equal(host->status, CLAP_PROCESS_CONTINUE);
  assert_int_equal(host->ended, 1);
  const clap_plugin_tail_t *const tail = clap_host_extension(host, CLAP_EXT_TAIL);
  const uint32_t longest = tail->get(host->plugin);
  for (uint32_t at = 0; host->status == CLAP_PROCESS_CONTINUE; at += CLAP_BLOCK) {
    assert_true(at < longest + CLAP_BLOCK);
    clap_host_run(host, CLAP_BLOCK);
  }
  clap_host_run(host, 64);
  for (uint32_t at = 0; at < 64; at++) assert_true(host->sound[0][at] == 0);
  clap_host_close(host);
}

int main(int argc, char **argv) {
  if (argc < 3) return 1;
  entry = clap_host_entry(argv[2]);
  brief = argc == 4;
  thorough = argc == 5;
  if (thorough) random_songs = (unsigned)atoi(argv[4]);
  if (!songs_begin(argv[1], !thorough)) return 1;
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(test_blocks_of_every_size),
    cmocka_unit_test(test_the_usual_quality),
    cmocka_unit_test(test_an_output_per_microphone),
    cmocka_unit_test(test_program_changes_in_a_room),
    cmocka_unit_test(test_random_songs),
    cmocka_unit_test(test_parameters_act_at_their_frames),
    cmocka_unit_test(test_both_dialects_mean_the_same),
    cmocka_unit_test(test_a_choke_at_the_frame_of_its_notes),
    cmocka_unit_test(test_note_ends_and_sleep),
  };
  const int failed = cmocka_run_group_tests(tests, NULL, NULL);
  return songs_end() ? failed : 1;
}
