/* SPDX-License-Identifier: MIT */
/**
 * @file midi_sequence.h
 * The MIDI messages of a run, frame by frame; at one frame controllers come before notes. AUDIO:
 * all functions.
 */
#ifndef TABOR_LV2_MIDI_SEQUENCE_H
#define TABOR_LV2_MIDI_SEQUENCE_H

#include "lv2/sequence.h"
#include "midi/midi_stream.h"

typedef struct MidiSequence {
  Sequence sequence; /**< events that were not yet taken */
  LV2_URID midi;     /**< of midi:MidiEvent */
  uint32_t frames;   /**< of the run */
} MidiSequence;

/** Finds the next frame that has events, at least @p *frame and within the run. False: there is
 * none. */
bool midi_sequence_find(const MidiSequence *sequence, uint32_t *frame) REALTIME;

/** What takes a message. */
typedef void MidiSequenceTakeFn(void *context, const MidiMessage *message) REALTIME;

/** Passes on the messages of @p frame, which was found. */
void midi_sequence_take(MidiSequence *sequence, uint32_t frame, MidiSequenceTakeFn *take,
                        void *context) REALTIME;

#endif
