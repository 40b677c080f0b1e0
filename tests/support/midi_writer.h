/* SPDX-License-Identifier: MIT */
/**
 * @file midi_writer.h
 * Standard MIDI Files in memory, event by event or at random, for the tests of their reader.
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
  size_t track; /**< where the present one's length stands */
} MidiWriter;

void midi_write_header(MidiWriter *writer, unsigned format, unsigned tracks, unsigned division);
void midi_write_track(MidiWriter *writer); /**< begins one */
void midi_write_bytes(MidiWriter *writer, const void *bytes, size_t count);
void midi_write_length(MidiWriter *writer, uint32_t number); /**< seven bits a byte */
/** An event of up to three bytes, @p delta ticks after the one before. */
void midi_write_event(MidiWriter *writer, uint32_t delta, unsigned count, const uint8_t *bytes);
void midi_write_tempo(MidiWriter *writer, uint32_t delta, uint32_t quarter);
void midi_write_end(MidiWriter *writer, uint32_t delta); /**< of the track */

/** The next number of a generator (SplitMix64). */
uint64_t midi_random(uint64_t *state);
/** A whole valid file of ticks of a quarter, with everything in it that one may hold. */
void midi_write_random(MidiWriter *writer, uint64_t seed);

#endif
