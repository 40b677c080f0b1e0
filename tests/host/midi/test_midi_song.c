/* SPDX-License-Identifier: MIT */
/* A MIDI file as actions of a drum (host/midi/midi_song.h): their frames, and what acts first at
 * one frame. */
#include "midi/midi_song_input.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static MidiSong song;

static void compose_at(double rate) {
  MidiMap map;
  TaborDrumDef def;
  midi_map_default(&map);
  assert_int_equal(tabor_drum_def_preset(&def, tabor_preset(0)->name, NULL), TABOR_OK);
  assert_true(midi_song_compose(&song, &map, &def, rate));
}

/* Composes the song of these messages, at 1000 Hz. */
static void compose(const MidiFileEvent *events, size_t count) {
  midi_song_free(&song);
  song.first_preset = 0;
  song.file.events = malloc(count * sizeof *events);
  song.file.count = count;
  memcpy(song.file.events, events, count * sizeof *events);
  compose_at(1000.0);
}

static void expect(size_t index, uint32_t frame, MidiActionType type) {
  assert_true(index < song.count);
  assert_int_equal(song.items[index].frame, frame);
  assert_int_equal(song.items[index].action.type, type);
}

static void actions_come_at_their_frames(void **state) {
  (void)state;
  const MidiFileEvent events[] = {
    {0.1, {0x99, {38, 100}}}, {0.25, {0xB9, {7, 64}}}, {0.25, {0x99, {38, 1}}}};
  compose(events, 3);
  assert_int_equal(song.count, 3);
  expect(0, 100, MIDI_ACTION_EVENT);
  expect(1, 250, MIDI_ACTION_GAIN);
  expect(2, 250, MIDI_ACTION_EVENT);
  assert_int_equal(song.counts.strokes, 2);
  TaborEvent *strokes;
  size_t count;
  assert_int_equal(midi_song_take_events(&song, &strokes, &count), OUTCOME_OK);
  assert_int_equal(count, 2);
  assert_true(strokes[0].frame == 100 && strokes[1].frame == 250);
  assert_true(strokes[0].velocity > strokes[1].velocity);
  assert_int_equal(song.count, 1);
  expect(0, 250, MIDI_ACTION_GAIN);
  free(strokes);
}

static void a_song_is_composed_again_for_another_rate(void **state) {
  (void)state;
  const MidiFileEvent events[] = {{0.1, {0x99, {38, 100}}}, {0.25, {0x99, {38, 1}}}};
  compose(events, 2);
  compose_at(2000.0);
  assert_int_equal(song.count, 2);
  expect(0, 200, MIDI_ACTION_EVENT);
  expect(1, 500, MIDI_ACTION_EVENT);
  assert_int_equal(song.counts.strokes, 2);
}

/* The last program change at a frame wins, and acts before all else there; one to the current
 * preset does nothing. */
static void the_last_program_at_a_frame_acts_first(void **state) {
  (void)state;
  const MidiFileEvent events[] = {
    {0.1, {0xB9, {7, 64}}}, {0.1, {0xC9, {1, 0}}}, {0.1, {0xC9, {2, 0}}}, {0.1, {0x99, {38, 100}}},
    {0.2, {0xC9, {2, 0}}},  {0.3, {0xC9, {1, 0}}}, {0.3, {0xC9, {2, 0}}},
  };
  compose(events, 7);
  assert_int_equal(song.count, 3);
  expect(0, 100, MIDI_ACTION_PRESET);
  assert_int_equal(song.items[0].action.preset, 2);
  expect(1, 100, MIDI_ACTION_GAIN);
  expect(2, 100, MIDI_ACTION_EVENT);
  TaborDrumDef chosen;
  assert_int_equal(tabor_drum_def_preset(&chosen, tabor_preset(2)->name, NULL), TABOR_OK);
  assert_true(song.items[2].head_radius == chosen.shell.radius);
}

static int clean_up(void **state) {
  (void)state;
  midi_song_free(&song);
  return 0;
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(actions_come_at_their_frames),
    cmocka_unit_test(a_song_is_composed_again_for_another_rate),
    cmocka_unit_test(the_last_program_at_a_frame_acts_first),
  };
  return cmocka_run_group_tests(tests, NULL, clean_up);
}
