/* SPDX-License-Identifier: MIT */
#include "lv2/midi_sequence.h"

#include <stddef.h>

#include "midi/midi_map.h"

/* Its frame in the run: not past its end, not before `at`. */
static uint32_t frame_of(const LV2_Atom_Event *event, uint32_t at, uint32_t frames) REALTIME;
static uint32_t frame_of(const LV2_Atom_Event *event, uint32_t at, uint32_t frames) {
  const int64_t frame = event->time.frames;
  if (frame <= at) return at;
  return frame < frames ? (uint32_t)frame : frames - (frames > 0);
}

bool midi_sequence_find(const MidiSequence *sequence, uint32_t *frame) {
  const LV2_Atom_Event *const event = sequence_event(&sequence->sequence);
  if (event) *frame = frame_of(event, *frame, sequence->frames);
  return event != NULL;
}

/* All messages of an event that go with notes, or all others. */
static void take_event(const LV2_Atom_Event *event, bool notes, MidiSequenceTakeFn *take,
                       void *context) REALTIME;
static void take_event(const LV2_Atom_Event *event, bool notes, MidiSequenceTakeFn *take,
                       void *context) {
  const uint8_t *const bytes = (const uint8_t *)(event + 1);
  MidiStream stream = {0};
  MidiMessage message;
  for (uint32_t i = 0; i < event->body.size; i++) {
    if (!midi_stream_take(&stream, bytes[i], &message)) continue;
    if (midi_goes_with_notes(&message) == notes) take(context, &message);
  }
}

void midi_sequence_take(MidiSequence *sequence, uint32_t frame, MidiSequenceTakeFn *take,
                        void *context) {
  Sequence *const rest = &sequence->sequence;
  const Sequence first = *rest;
  const LV2_Atom_Event *event;
  for (int notes = 0; notes <= 1; notes++) {
    *rest = first;
    while ((event = sequence_event(rest)) && frame_of(event, frame, sequence->frames) == frame) {
      if (event->body.type == sequence->midi) take_event(event, notes == 1, take, context);
      sequence_step(rest);
    }
  }
}
