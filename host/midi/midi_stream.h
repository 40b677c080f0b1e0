/* SPDX-License-Identifier: MIT */
/**
 * @file midi_stream.h
 * Parses MIDI bytes from a cable or port into channel messages.
 *
 * The parser handles running status, real-time bytes inside other messages and truncated messages.
 * It skips system exclusive data of any length. The work per byte is bounded; nothing is allocated.
 * AUDIO: all functions. Use one stream per source.
 */
#ifndef TABOR_HOST_MIDI_STREAM_H
#define TABOR_HOST_MIDI_STREAM_H

#include <stdbool.h>
#include <stdint.h>

#include "base/realtime.h"

#define MIDI_CHANNELS 16
#define MIDI_VALUES 128 /**< number of values of a data byte: notes, controllers, programs */

/** Kinds of channel message: the status byte without its channel. */
enum {
  MIDI_NOTE_OFF = 0x80,
  MIDI_NOTE_ON = 0x90,
  MIDI_POLY_PRESSURE = 0xA0,
  MIDI_CONTROL = 0xB0,
  MIDI_PROGRAM = 0xC0,
  MIDI_CHANNEL_PRESSURE = 0xD0,
  MIDI_BEND = 0xE0
};

/** A channel message. */
typedef struct MidiMessage {
  uint8_t status;  /**< 0x80 to 0xEF */
  uint8_t data[2]; /**< 0 to 127 each; the second is 0 if the message has only one */
} MidiMessage;

/** Parser state for one source. All members zero is the initial state. */
typedef struct MidiStream {
  uint8_t status;  /**< running status, or 0: data bytes are skipped */
  uint8_t data[2]; /**< data bytes received so far */
  uint8_t count;
} MidiStream;

static inline uint8_t midi_kind(const MidiMessage *message) { return message->status & 0xF0u; }
/** Channel of a message, 0 to 15. */
static inline uint8_t midi_channel(const MidiMessage *message) { return message->status & 0x0Fu; }
/** Number of data bytes of a channel message, 1 or 2. */
static inline uint8_t midi_data_count(uint8_t status) {
  const uint8_t kind = status & 0xF0u;
  return kind == MIDI_PROGRAM || kind == MIDI_CHANNEL_PRESSURE ? 1 : 2;
}

/** Takes the next byte. True if it completes @p message; otherwise @p message is unchanged. */
bool midi_stream_take(MidiStream *stream, uint8_t byte, MidiMessage *message) REALTIME;

#endif
