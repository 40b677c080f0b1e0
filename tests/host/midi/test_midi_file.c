/* SPDX-License-Identifier: MIT */
/* The reader of Standard MIDI Files (host/midi/midi_file_input.h): times by hand, everything that
 * is refused, and damaged files, which end in a message and never in a wrong access (under the
 * sanitizers). */
#include "midi/midi_file_input.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "midi_writer.h"
#include "said.h"

#define PPQ 96u
static const double ROUNDING = 1e-12; /* relative: a product and a quotient of doubles */

static MidiWriter writer;
static MidiFile file;

static const uint8_t full_note[] = {0x99, 38, 100}, running_note[] = {38, 100};

static Outcome parse(void) {
  said_nothing();
  /* an exact copy, so that the sanitizer sees any byte too many */
  uint8_t *const copy = malloc(writer.length + 1);
  assert_non_null(copy);
  uint8_t *const bytes = realloc(copy, writer.length ? writer.length : 1);
  memcpy(bytes, writer.bytes, writer.length);
  const Outcome outcome = midi_file_parse("song.mid", bytes, writer.length, false, &file);
  free(bytes);
  return outcome;
}

static void expect_event(size_t index, double time, uint8_t status, uint8_t first, uint8_t second) {
  assert_true(index < file.count);
  const MidiFileEvent *const event = &file.events[index];
  if (!(fabs(event->time - time) <= ROUNDING * time)) {
    fail_msg("event %zu at %.17g s, expected %.17g", index, event->time, time);
  }
  assert_int_equal(event->message.status, status);
  assert_int_equal(event->message.data[0], first);
  assert_int_equal(event->message.data[1], second);
}

static void accept(size_t count) {
  if (parse() != OUTCOME_OK) fail_msg("%s", said);
  assert_int_equal(file.count, count);
}

static void refuse_file(const char *part) {
  const Outcome outcome = parse();
  if (outcome != OUTCOME_REFUSED || said_count != 1 || strncmp(said, "song.mid: ", 10) != 0 ||
      !strstr(said, part)) {
    fail_msg("outcome %d, %u messages, '%s'; expected '%s'", outcome, said_count, said, part);
  }
  assert_int_equal(file.count, 0);
  midi_file_free(&file);
}

/* It is read with this warning, and with --strict it is refused in the same words. */
static void warn_of_file(const char *part, size_t count) {
  Outcome outcome = parse();
  if (outcome != OUTCOME_OK || said_count != 1 || !strstr(said, part)) {
    fail_msg("outcome %d, %u messages, '%s'; expected '%s'", outcome, said_count, said, part);
  }
  assert_int_equal(file.count, count);
  midi_file_free(&file);
  said_nothing();
  outcome = midi_file_parse("song.mid", writer.bytes, writer.length, true, &file);
  assert_int_equal(outcome, OUTCOME_REFUSED);
  assert_int_equal(said_count, 1);
  assert_non_null(strstr(said, part));
  assert_int_equal(file.count, 0);
}

/* ---- what is read ---- */

static void test_times(void **state) {
  (void)state;
  midi_write_header(&writer, 0, 1, PPQ);
  midi_write_track(&writer);
  midi_write_event(&writer, 0, 3, full_note);
  midi_write_event(&writer, PPQ, 2, running_note); /* 120 quarters a minute until told otherwise */
  midi_write_tempo(&writer, PPQ, 1000000);
  midi_write_event(&writer, 0, 3, full_note);
  midi_write_event(&writer, PPQ / 2, 2, running_note);
  midi_write_tempo(&writer, 0, 250000);
  midi_write_end(&writer, 4 * PPQ);
  accept(4);
  expect_event(0, 0, 0x99, 38, 100);
  expect_event(1, 0.5, 0x99, 38, 100);
  expect_event(2, 1, 0x99, 38, 100);
  expect_event(3, 1.5, 0x99, 38, 100);
  assert_true(fabs(file.length - 2.5) < 1e-12);
  midi_file_free(&file);
}

static void test_frames(void **state) {
  (void)state;
  static const struct {
    uint8_t frames;
    double rate;
  } kinds[] = {{24, 24}, {25, 25}, {29, 30000.0 / 1001}, {30, 30}};
  for (size_t i = 0; i < 4; i++) {
    midi_write_header(&writer, 0, 1, (256u - kinds[i].frames) << 8 | 40);
    midi_write_track(&writer);
    midi_write_tempo(&writer, 0, 1000); /* means nothing here */
    midi_write_event(&writer, 1000, 3, full_note);
    midi_write_end(&writer, 0);
    accept(1);
    expect_event(0, 1000 / (kinds[i].rate * 40), 0x99, 38, 100);
    midi_file_free(&file);
  }
}

static void test_tracks_merge(void **state) {
  (void)state;
  static const uint8_t program[] = {0xC3, 5}, bend[] = {0xE1, 1, 2};
  midi_write_header(&writer, 1, 3, PPQ);
  midi_write_track(&writer);
  midi_write_event(&writer, PPQ, 3, full_note);
  midi_write_end(&writer, 0);
  midi_write_bytes(&writer, "XYZ!\0\0\0\3abc", 11); /* no track */
  midi_write_track(&writer);
  midi_write_event(&writer, 0, 2, program);
  midi_write_event(&writer, PPQ, 3, bend);
  midi_write_end(&writer, 0);
  midi_write_track(&writer);
  midi_write_tempo(&writer, PPQ / 2, 1000000); /* of any track */
  midi_write_end(&writer, 0);
  accept(3);
  expect_event(0, 0, 0xC3, 5, 0);
  expect_event(1, 0.75, 0x99, 38, 100);
  expect_event(2, 0.75, 0xE1, 1, 2);
  midi_file_free(&file);
}

static void test_passed_over(void **state) {
  (void)state;
  midi_write_header(&writer, 0, 1, PPQ);
  midi_write_track(&writer);
  midi_write_event(&writer, 0, 3, full_note);
  midi_write_bytes(&writer,
                   "\0\xFF\x01\x03"
                   "abc",
                   7);
  midi_write_event(&writer, PPQ, 2, running_note); /* after a meta event, as some write it */
  midi_write_bytes(&writer, "\0\xF0\x03\x01\x02\xF7", 6);
  midi_write_bytes(&writer, "\0\xF7\x02\xF8\xFA", 5);
  midi_write_event(&writer, PPQ, 3, full_note);
  midi_write_end(&writer, 0);
  accept(3);
  expect_event(1, 0.5, 0x99, 38, 100);
  expect_event(2, 1, 0x99, 38, 100);
  midi_file_free(&file);
}

/* ---- what is refused ---- */

static void one_track(const void *bytes, size_t count) {
  midi_write_header(&writer, 0, 1, PPQ);
  midi_write_track(&writer);
  midi_write_bytes(&writer, bytes, count);
  midi_write_end(&writer, 0);
}

static void refuse_header(unsigned format, unsigned tracks, unsigned division, const char *part) {
  midi_write_header(&writer, format, tracks, division);
  midi_write_track(&writer);
  midi_write_end(&writer, 0);
  refuse_file(part);
}

static void refuse_track(const void *bytes, size_t count, const char *part) {
  one_track(bytes, count);
  refuse_file(part);
}

static void warn_of_track(const void *bytes, size_t count, const char *part) {
  midi_write_header(&writer, 0, 1, PPQ);
  midi_write_track(&writer);
  midi_write_event(&writer, 0, 3, full_note);
  midi_write_bytes(&writer, bytes, count);
  midi_write_event(&writer, 1, 3, full_note);
  midi_write_end(&writer, 0);
  warn_of_file(part, 2);
}

static void test_headers(void **state) {
  (void)state;
  writer.length = 0;
  refuse_file("not a Standard MIDI File");
  midi_write_bytes(&writer, "RIFF....RMIDdata....", 20);
  refuse_file("byte 0: not a Standard MIDI File, nor a RIFF file that holds one");
  refuse_header(2, 1, PPQ, "byte 8: format 2; allowed: 0 and 1");
  refuse_header(0, 1, 0, "byte 12: 0 ticks for a quarter; allowed: 1 to 32767");
  refuse_header(0, 1, 0xE300, "0 ticks in each of 29 frames");
  refuse_header(0, 1, 0x8004,
                "4 ticks in each of 128 frames a second; allowed: 1 to 255 in 24, 25, 29 or 30");
  midi_write_header(&writer, 0, 1, PPQ);
  refuse_file("byte 14: the file has no track");
  one_track("", 0);
  writer.bytes[7] = 5;
  refuse_file("a header of less than 6 bytes");
}

static void two_tracks(unsigned format, unsigned announced, const char *part) {
  midi_write_header(&writer, format, announced, PPQ);
  for (int i = 0; i < 2; i++) {
    midi_write_track(&writer);
    midi_write_event(&writer, 0, 3, full_note);
    midi_write_end(&writer, 0);
  }
  warn_of_file(part, 2);
}

/* All tracks play that are there. */
static void test_wrong_numbers_of_tracks(void **state) {
  (void)state;
  two_tracks(1, 1, "byte 10: 1 tracks are announced, 2 are there and play");
  two_tracks(1, 3, "byte 10: 3 tracks are announced, 2 are there and play");
  two_tracks(1, 0, "byte 10: 0 tracks are announced, 2 are there and play");
  two_tracks(1, 0xFF01, "byte 10: 65281 tracks are announced, 2 are there and play");
  two_tracks(0, 2, "byte 10: 2 tracks in a file of format 0, all of which play; allowed: 1");
}

/* Inside RIFF, with other chunks before and after; and bytes that belong to no chunk. */
static void test_containers_and_junk(void **state) {
  (void)state;
  uint8_t song[256];
  one_track("\0\x99\x26\x64", 4);
  const size_t length = writer.length;
  memcpy(song, writer.bytes, length);
  const char size[] = {(char)length, 0, 0, 0};
  writer.length = 0;
  midi_write_bytes(&writer, "RIFF\xFF\0\0\0RMIDdisp\x03\0\0\0abc\0data", 28);
  midi_write_bytes(&writer, size, 4);
  midi_write_bytes(&writer, song, length);
  midi_write_bytes(&writer, "\0LIST\0\0\0\0", 9);
  accept(1);
  midi_file_free(&file);
  writer.length = 0;
  midi_write_bytes(&writer, song, 14);
  midi_write_bytes(&writer, "\0\1\2", 3);
  midi_write_bytes(&writer, song + 14, length - 14);
  warn_of_file("byte 14: 3 bytes that belong to no chunk are passed over", 1);
  writer.length = 0;
  midi_write_bytes(&writer, song, length);
  midi_write_bytes(&writer, "rest", 4);
  warn_of_file("4 bytes that belong to no chunk are passed over", 1);
  writer.length = 0;
  midi_write_bytes(&writer, song, 14);
  midi_write_bytes(&writer, "Odd.\0\0\0\2..", 10); /* a chunk of somebody else's */
  midi_write_bytes(&writer, song + 14, length - 14);
  accept(1);
  midi_file_free(&file);
}

static void test_events(void **state) {
  (void)state;
  refuse_track("\0\x26\x64", 3, "byte 23, track 1: data without a status byte");
  refuse_track("\0\x99\x26\x80", 4, "byte 25, track 1: a data byte over 127 in a note");
  refuse_track("\0\x89\xC0\x10", 4, "byte 24, track 1: a data byte over 127 in a note");
  refuse_track("\x81\x81\x81\x81\x81\x81\x81\x81\0", 9,
               "byte 22, track 1: a time or length of more than 8 bytes");
  one_track("\0\xFF\x01\x7F"
            "abc",
            7);
  refuse_file("byte 23, track 1: an event is longer than the rest of its track");
  refuse_track("\0\xF0\xFF\xFF\xFF\x7F", 6, "an event is longer than the rest of its track");
}

/* What is wrong and touches no note. */
static void test_warnings(void **state) {
  (void)state;
  warn_of_track("\0\xB9\x07\x80", 4, "byte 29, track 1: a data byte of 128 in a message");
  warn_of_track("\0\xD9\xFF", 3, "byte 28, track 1: a data byte of 255 in a message");
  warn_of_track("\0\xF1\1", 3, "byte 27, track 1: a system message F1");
  warn_of_track("\0\xF2\1\1", 4, "byte 27, track 1: a system message F2");
  warn_of_track("\0\xF8", 2, "byte 27, track 1: a system message F8");
  warn_of_track("\0\xFE", 2, "byte 27, track 1: a system message FE");
  warn_of_track("\x80\x80\x80\x80\0\xFF\x06\0", 8, "byte 26, track 1: a time or length of 5 bytes");
  warn_of_track("\0\xFF\x51\x03\0\0\0", 7, "byte 27, track 1: a tempo of 0 us for a quarter");
  warn_of_track("\0\xFF\x51\x02\1\1", 6,
                "byte 27, track 1: tempo of 2 bytes is passed over; allowed: 3");
  warn_of_track("\0\xFF\x51\x04\1\1\1\1", 8, "tempo of 4 bytes is passed over; allowed: 3");
  warn_of_track("\0\xFF\x58\x02\4\2", 6, "time signature of 2 bytes is passed over; allowed: 4");
  warn_of_track("\0\xFF\x59\0", 4, "key signature of 0 bytes is passed over; allowed: 2");
  midi_write_header(&writer, 0, 1, PPQ);
  midi_write_track(&writer);
  midi_write_event(&writer, 0, 3, full_note);
  midi_write_end(&writer, 0);
  midi_write_bytes(&writer, "\0\x99", 2);
  const uint8_t longer = (uint8_t)(writer.bytes[21] + 2);
  writer.bytes[21] = longer;
  warn_of_file("2 bytes behind the end of the track are passed over", 1);
}

/* More warnings than anybody reads are counted. */
static void test_many_warnings(void **state) {
  (void)state;
  enum { BYTES = 20 };
  midi_write_header(&writer, 0, 1, PPQ);
  midi_write_track(&writer);
  for (int i = 0; i < BYTES; i++) midi_write_bytes(&writer, "\0\xF8", 2);
  midi_write_end(&writer, 0);
  assert_int_equal(parse(), OUTCOME_OK);
  assert_int_equal(said_count, MIDI_FILE_MOST_WARNINGS + 1);
  assert_non_null(strstr(said, "song.mid: 12 more warnings"));
  midi_file_free(&file);
}

/* Wherever a file breaks off, a chunk is not complete. */
static void test_truncated(void **state) {
  (void)state;
  for (uint64_t seed = 1; seed <= 20; seed++) {
    midi_write_random(&writer, seed);
    const size_t whole = writer.length;
    for (size_t length = 0; length < whole; length += 1 + length / 64) {
      writer.length = length;
      const Outcome outcome = parse();
      assert_true(outcome != OUTCOME_OK || said_count > 0);
      midi_file_free(&file);
    }
    writer.length = whole;
    assert_int_equal(parse(), OUTCOME_OK);
    assert_int_equal(said_count, 0);
    midi_file_free(&file);
  }
}

/* A track that ends within an event: a note is refused, anything else passed over. */
static void test_broken_off(void **state) {
  (void)state;
  static const struct {
    const char *bytes;
    size_t length;
    bool refused;
  } ENDS[] = {{"\0\x99\x26", 3, true}, {"\0\xB9\x07", 3, false}, {"\0\xD9", 2, false},
              {"\x83", 1, false},      {"\0", 1, false},         {"\0\xFF", 2, true}};
  for (size_t i = 0; i < sizeof ENDS / sizeof *ENDS; i++) {
    midi_write_header(&writer, 0, 1, PPQ);
    midi_write_track(&writer);
    midi_write_event(&writer, 0, 3, full_note);
    midi_write_bytes(&writer, ENDS[i].bytes, ENDS[i].length);
    writer.bytes[21] = (uint8_t)(4 + ENDS[i].length);
    if (ENDS[i].refused) {
      refuse_file("the track breaks off in an event");
    } else {
      warn_of_file("the track breaks off in an event, which is passed over", 1);
    }
  }
}

static void test_too_many_events(void **state) {
  (void)state;
  enum { COUNT = MIDI_FILE_MOST_EVENTS };
  const size_t size = 22 + 3 + 3 * (size_t)COUNT;
  uint8_t *const bytes = calloc(size + 3, 1);
  assert_non_null(bytes);
  midi_write_header(&writer, 0, 1, PPQ);
  midi_write_track(&writer);
  memcpy(bytes, writer.bytes, 22);
  memcpy(bytes + 22, "\0\xC0\x01", 3);
  for (size_t i = 25; i + 1 < size; i += 2) memcpy(bytes + i, "\0\x01", 2);
  const size_t used = 25 + 2 * (size_t)(COUNT - 1);
  for (size_t more = 0; more < 2; more++) {
    const size_t length = used + 2 * more - 22;
    for (int i = 0; i < 4; i++) bytes[18 + i] = (uint8_t)(length >> (24 - 8 * i));
    said_nothing();
    const Outcome outcome = midi_file_parse("song.mid", bytes, used + 2 * more, false, &file);
    assert_int_equal(outcome, more ? OUTCOME_REFUSED : OUTCOME_OK);
    if (more) assert_non_null(strstr(said, "too many events; allowed: up to 1000000"));
    midi_file_free(&file);
  }
  free(bytes);
}

/* Any outcome but a crash, hang or wrong access; what is read is in order. */
static void test_damaged(void **state) {
  (void)state;
  uint64_t random = 20260101;
  unsigned read = 0;
  for (uint64_t trial = 0; trial < 3000; trial++) {
    midi_write_random(&writer, 1000 + trial % 50);
    for (uint64_t hits = 1 + midi_random(&random) % 6; hits > 0; hits--) {
      const uint64_t near = midi_random(&random) % 2 ? 64 : writer.length;
      writer.bytes[midi_random(&random) % near % writer.length] = (uint8_t)midi_random(&random);
    }
    const Outcome outcome = parse();
    assert_true(outcome == OUTCOME_OK || outcome == OUTCOME_REFUSED);
    if (outcome != OUTCOME_OK) assert_int_equal(said_count, 1);
    read += outcome == OUTCOME_OK;
    for (size_t i = 1; i < file.count; i++) {
      assert_true(file.events[i].time >= file.events[i - 1].time);
      assert_true((file.events[i].message.data[0] | file.events[i].message.data[1]) < 0x80);
    }
    midi_file_free(&file);
  }
  printf("seed 20260101: %u of 3000 damaged files could be read\n", read);
  assert_in_range(read, 10, 2900); /* else the damage is too small or too large to test anything */
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(test_times),
    cmocka_unit_test(test_frames),
    cmocka_unit_test(test_tracks_merge),
    cmocka_unit_test(test_passed_over),
    cmocka_unit_test(test_headers),
    cmocka_unit_test(test_events),
    cmocka_unit_test(test_wrong_numbers_of_tracks),
    cmocka_unit_test(test_containers_and_junk),
    cmocka_unit_test(test_warnings),
    cmocka_unit_test(test_many_warnings),
    cmocka_unit_test(test_broken_off),
    cmocka_unit_test(test_truncated),
    cmocka_unit_test(test_too_many_events),
    cmocka_unit_test(test_damaged),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
