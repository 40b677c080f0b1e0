/* SPDX-License-Identifier: MIT */
#include "midi_writer.h"

#include <assert.h>
#include <string.h>

void midi_write_bytes(MidiWriter *writer, const void *bytes, size_t count) {
  assert(count <= MIDI_WRITER_ROOM - writer->length);
  memcpy(writer->bytes + writer->length, bytes, count);
  writer->length += count;
}

static void write_number(MidiWriter *writer, uint32_t number, unsigned count) {
  while (count-- > 0) {
    const uint8_t byte = (uint8_t)(number >> (8 * count));
    midi_write_bytes(writer, &byte, 1);
  }
}

void midi_write_length(MidiWriter *writer, uint32_t number) {
  for (unsigned shift = 21; shift > 0; shift -= 7) {
    if (number >> shift) write_number(writer, 0x80u | (number >> shift & 0x7Fu), 1);
  }
  write_number(writer, number & 0x7Fu, 1);
}

void midi_write_header(MidiWriter *writer, unsigned format, unsigned tracks, unsigned division) {
  writer->length = 0;
  midi_write_bytes(writer, "MThd", 4);
  write_number(writer, 6, 4);
  write_number(writer, format, 2);
  write_number(writer, tracks, 2);
  write_number(writer, division, 2);
}

void midi_write_track(MidiWriter *writer) {
  midi_write_bytes(writer, "MTrk", 4);
  writer->track = writer->length;
  write_number(writer, 0, 4);
}

void midi_write_event(MidiWriter *writer, uint32_t delta, unsigned count, const uint8_t *bytes) {
  midi_write_length(writer, delta);
  midi_write_bytes(writer, bytes, count);
}

void midi_write_tempo(MidiWriter *writer, uint32_t delta, uint32_t quarter) {
  midi_write_length(writer, delta);
  midi_write_bytes(writer, "\xFF\x51\x03", 3);
  write_number(writer, quarter, 3);
}

void midi_write_end(MidiWriter *writer, uint32_t delta) {
  midi_write_length(writer, delta);
  midi_write_bytes(writer, "\xFF\x2F\x00", 3);
  const size_t end = writer->length;
  writer->length = writer->track;
  write_number(writer, (uint32_t)(end - writer->track - 4), 4);
  writer->length = end;
}

/* ---- at random ---- */

uint64_t midi_random(uint64_t *state) {
  uint64_t z = *state += 0x9E3779B97F4A7C15u;
  z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
  z = (z ^ z >> 27) * 0x94D049BB133111EBu;
  return z ^ z >> 31;
}

static uint32_t below(uint64_t *state, uint32_t limit) {
  return (uint32_t)(midi_random(state) % limit);
}

/* Often none, mostly short, sometimes of two or three bytes. */
static uint32_t random_delta(uint64_t *state) {
  static const uint32_t limits[] = {1, 2, 100, 1000, 50000};
  return below(state, limits[below(state, 5)]);
}

/* With running status where the one before allows it. */
static void write_message(MidiWriter *writer, uint64_t *state, uint8_t *running) {
  uint8_t bytes[3] = {(uint8_t)(0x80u + below(state, 0x70)), (uint8_t)below(state, 128),
                      (uint8_t)below(state, 128)};
  if (*running && below(state, 2)) bytes[0] = *running;
  const unsigned count = 1u + midi_data_count(bytes[0]);
  const unsigned skipped = bytes[0] == *running && below(state, 4) ? 1 : 0;
  midi_write_event(writer, random_delta(state), count - skipped, bytes + skipped);
  *running = bytes[0];
}

/* Text, a marker, or data of a maker's. */
static void write_block(MidiWriter *writer, uint64_t *state) {
  uint8_t data[300];
  const bool text = below(state, 2);
  /* libsmf takes the length of a text for one byte, which says nothing about ours */
  const uint32_t count = 1 + below(state, text ? 127 : sizeof data - 1);
  midi_write_length(writer, random_delta(state));
  midi_write_bytes(writer, text ? "\xFF\x01" : "\xF0", text ? 2 : 1);
  midi_write_length(writer, count);
  for (uint32_t i = 0; i < count; i++)
    data[i] = (uint8_t)(text ? ' ' + below(state, 90) : below(state, 128));
  if (!text) data[count - 1] = 0xF7;
  midi_write_bytes(writer, data, count);
}

static void write_random_track(MidiWriter *writer, uint64_t *state) {
  uint8_t running = 0;
  midi_write_track(writer);
  for (uint32_t left = below(state, 200); left > 0; left--) {
    switch (below(state, 12)) {
    case 0:
      midi_write_tempo(writer, random_delta(state), 1 + below(state, 2000000));
      running = 0;
      break;
    case 1:
      write_block(writer, state);
      running = 0;
      break;
    default: write_message(writer, state, &running);
    }
  }
  midi_write_end(writer, random_delta(state));
}

void midi_write_random(MidiWriter *writer, uint64_t seed) {
  uint64_t state = seed;
  const unsigned format = below(&state, 2), tracks = format ? 1 + below(&state, 5) : 1;
  midi_write_header(writer, format, tracks, 1 + below(&state, 1000));
  for (unsigned i = 0; i < tracks; i++) write_random_track(writer, &state);
}
