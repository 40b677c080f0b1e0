/* SPDX-License-Identifier: MIT */
/**
 * @file midi_writer.h
 * Writes Standard MIDI Files in memory, event by event or at random, for the tests of the reader.
 */
#ifndef TABOR_TESTS_MIDI_WRITER_H
#define TABOR_TESTS_MIDI_WRITER_H

#include <stddef.h>
#include <stdint.h>

#include "midi/midi_stream.h"

#define MIDI_WRITER_ROOM (1u << 17)

typedef struct MidiWriter {
  uint8_t bytes[MIDI_WRITER_ROOM];
  size_t length;
  size_t track; /**< offset of the current track's length */
} MidiWriter;

void midi_write_header(MidiWriter *writer, unsigned format, unsigned tracks, unsigned division);
void midi_write_track(MidiWriter *writer); /**< starts a track */
void midi_write_bytes(MidiWriter *writer, const void *bytes, size_t count);
void midi_write_length(MidiWriter *writer, uint32_t number); /**< seven bits per byte */
/** Writes an event of up to three bytes, @p delta ticks after the previous one. */
void midi_write_event(MidiWriter *writer, uint32_t delta, unsigned count, const uint8_t *bytes);
void midi_write_tempo(MidiWriter *writer, uint32_t delta, uint32_t quarter);
void midi_write_end(MidiWriter *writer, uint32_t delta); /**< ends the track */

/** Returns the next random number (SplitMix64). */
uint64_t midi_random(uint64_t *state);
/** Writes a complete valid file, with ticks per quarter and all elements that a file may hold. */
void midi_write_random(MidiWriter *writer, uint64_t seed);

#endif
