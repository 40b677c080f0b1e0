/* SPDX-License-Identifier: MIT */
#include "midi/midi_mask.h"

bool midi_mask_passes(MidiMask *mask, const MidiMessage *message, double now) {
  const uint8_t channel = midi_channel(message), note = message->data[0];
  if (mask->time <= 0 || midi_kind(message) != MIDI_NOTE_ON || message->data[1] == 0) return true;
  if (mask->played[channel][note] && now - mask->last[channel][note] < mask->time) return false;
  mask->played[channel][note] = true;
  mask->last[channel][note] = now;
  return true;
}

Outcome midi_mask_read(const Arguments *arguments, double *time) {
  static const NumberField field = {"--mask-time", 0, 1000, false};
  double milliseconds = 0;
  const Outcome outcome = arguments_number(arguments, &field, &milliseconds);
  *time = milliseconds / 1000;
  return outcome;
}
