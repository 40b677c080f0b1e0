/* SPDX-License-Identifier: MIT */
/* A MIDI file as events of a kit: every message of a long file, each at its frame. */
#include "kit/kit_song_input.h" /* before cmocka, whose fail() is a macro */
#include "midi/midi_options.h"
#include "strokes/stroke_options.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "base/message.h"
#include "midi/midi_mask.h"
#include "midi_writer.h"

enum { STROKES = 1000, RATE = 48000, TICKS = 96 }; /* 96 ticks of a quarter: half a second */

static const char NAME[] = "test_kit_song.mid";

static TaborKitDef kit;
static KitMidi midi;
static KitSong song;

/* A file of so many notes, 24 ticks apart, in turn of the bass drum, of the snare drum and of none.
 */
static void write_song(uint32_t strokes, uint8_t first) {
  static MidiWriter writer;
  memset(&writer, 0, sizeof writer);
  midi_write_header(&writer, 0, 1, TICKS);
  midi_write_track(&writer);
  for (uint32_t i = 0; i < strokes; i++) {
    const uint8_t notes[] = {first, 38, 54};
    midi_write_event(&writer, i == 0 ? 0 : TICKS / 4, 3, (uint8_t[]){0x99, notes[i % 3], 100});
  }
  midi_write_end(&writer, 0);
  FILE *file = fopen(NAME, "wb");
  assert_non_null(file);
  assert_int_equal(fwrite(writer.bytes, 1, writer.length, file), writer.length);
  fclose(file);
}

static Outcome read_song(double amount) {
  static const Option options[] = {
    OPTION_MIDI_FILE,      OPTION_STRICT, OPTION_MASK_TIME, OPTION_VELOCITY_CURVE,
    OPTION_VELOCITY_RANGE, OPTION_STRIKE, OPTION_EVENTS,    {0}};
  static const Command command = {.name = "render", .options = options};
  static char program[] = "render", option[] = "--midi-file", name[] = "test_kit_song.mid";
  char *const words[] = {program, option, name};
  Arguments arguments;
  assert_int_equal(tabor_kit_def_preset(&kit, "standard", NULL), TABOR_OK);
  assert_int_equal(arguments_read(&command, 3, words, &arguments), OUTCOME_OK);
  kit_midi_begin(&midi, &kit, &kit_midi_setup_default);
  const Outcome outcome = kit_song_read(&arguments, &kit, &midi, humanizer(amount, 1), RATE, &song);
  arguments_free(&arguments);
  return outcome;
}

static void a_long_song_keeps_every_stroke(void **state) {
  (void)state;
  write_song(STROKES, 36);
  assert_int_equal(read_song(0), OUTCOME_OK);
  assert_int_equal(song.count, STROKES - STROKES / 3);
  size_t next = 0;
  for (uint32_t i = 0; i < STROKES; i++) {
    if (i % 3 == 2) continue;
    const TaborKitEvent *event = &song.events[next++];
    assert_int_equal(event->event.frame, i * (RATE / 8));
    assert_int_equal(event->drum, tabor_kit_def_find(&kit, i % 3 ? "snare" : "kick"));
  }
  assert_int_equal(song.last_frame, (STROKES - 1) * (RATE / 8));
  assert_int_equal(midi.unknown[54], STROKES / 3);
  kit_song_free(&song);
}

static void strokes_are_scattered_by_the_humanizer(void **state) {
  (void)state;
  write_song(30, 38);
  assert_int_equal(read_song(1), OUTCOME_OK);
  assert_int_equal(song.count, 20);
  bool differs = false;
  for (size_t i = 1; i < song.count; i++) {
    differs |= song.events[i].event.velocity != song.events[0].event.velocity;
  }
  assert_true(differs);
  kit_song_free(&song);
}

static void a_song_without_a_stroke_is_refused(void **state) {
  (void)state;
  char message[200] = "";
  write_song(0, 36);
  const MessageCapture before = message_capture(message, sizeof message);
  const Outcome outcome = read_song(0);
  message_release(before);
  assert_int_not_equal(outcome, OUTCOME_OK);
  assert_non_null(strstr(message, NAME));
  kit_song_free(&song);
}

static int clean_up(void **state) {
  (void)state;
  return remove(NAME);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(a_long_song_keeps_every_stroke),
    cmocka_unit_test(strokes_are_scattered_by_the_humanizer),
    cmocka_unit_test(a_song_without_a_stroke_is_refused),
  };
  return cmocka_run_group_tests(tests, NULL, clean_up);
}
