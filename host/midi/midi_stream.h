/* SPDX-License-Identifier: MIT */
/**
 * @file midi_stream.h
 * MIDI bytes, as they come from a cable or port, into channel messages.
 *
 * Knows running status, real-time bytes inside of other messages, system exclusive data of any length,
 * which is passed over, and messages that break off. Every byte is a bounded amount of work; nothing is
 * allocated. AUDIO: all functions. One stream for each source.
 */
#ifndef TABOR_HOST_MIDI_STREAM_H
#define TABOR_HOST_MIDI_STREAM_H

#include <stdbool.h>
#include <stdint.h>

#include "base/realtime.h"

#define MIDI_CHANNELS 16
#define MIDI_VALUES 128 /**< of a data byte; notes, controllers, programs */

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
  uint8_t data[2]; /**< 0 to 127 each; the second is 0 in messages that have one */
} MidiMessage;

/** A source of bytes. All zero is its beginning. */
typedef struct MidiStream {
  uint8_t status;  /**< running status, or 0: data bytes are passed over */
  uint8_t data[2]; /**< what has come of the message */
  uint8_t count;
} MidiStream;

static inline uint8_t midi_kind(const MidiMessage *message) { return message->status & 0xF0u; }
/** 0 to 15. */
static inline uint8_t midi_channel(const MidiMessage *message) { return message->status & 0x0Fu; }
/** Data bytes of a channel message, 1 or 2. */
static inline uint8_t midi_data_count(uint8_t status) {
  const uint8_t kind = status & 0xF0u;
  return kind == MIDI_PROGRAM || kind == MIDI_CHANNEL_PRESSURE ? 1 : 2;
}

/** Takes the next byte; true if it completes @p message, which is untouched otherwise. */
bool midi_stream_take(MidiStream *stream, uint8_t byte, MidiMessage *message) REALTIME;

#endif
