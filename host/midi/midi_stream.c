/* SPDX-License-Identifier: MIT */
#include "midi/midi_stream.h"

#define FIRST_SYSTEM 0xF0u
#define FIRST_REAL_TIME 0xF8u

/* System messages end the running status; so their data, exclusive or common, are passed over. */
static void take_status(MidiStream *stream, uint8_t byte) {
  stream->status = byte >= FIRST_SYSTEM ? 0 : byte;
  stream->count = 0;
}

bool midi_stream_take(MidiStream *stream, uint8_t byte, MidiMessage *message) {
  if (byte >= FIRST_REAL_TIME) return false;
  if (byte & 0x80u) {
    take_status(stream, byte);
    return false;
  }
  if (stream->status == 0) return false;
  stream->data[stream->count++] = byte;
  if (stream->count < midi_data_count(stream->status)) return false;
  const bool two = stream->count == 2;
  *message = (MidiMessage){stream->status, {stream->data[0], two ? stream->data[1] : 0}};
  stream->count = 0;
  return true;
}
