/* SPDX-License-Identifier: MIT */
/**
 * @file midi_mask.h
 * A mask time against double triggers: a pad that shakes may send a second note for one stroke. A
 * note that begins within the mask time of the last one of its channel and number that was played
 * is not played.
 */
#ifndef TABOR_HOST_MIDI_MASK_H
#define TABOR_HOST_MIDI_MASK_H

#include "base/options.h"
#include "midi/midi_stream.h"

#define OPTION_MASK_TIME                                                                           \
  { "mask-time", 0, "MS", "ignore a note that repeats within so long, 0 to 1000 (default 0: none)" }

/** All members zero but the time is the initial state. */
typedef struct MidiMask {
  double time; /**< [s]; 0: every note passes */
  bool played[MIDI_CHANNELS][MIDI_VALUES];
  double last[MIDI_CHANNELS][MIDI_VALUES]; /**< when each note was played last [s] */
} MidiMask;

/** False for a note to leave out. @p now is the message's time [s], which never falls. */
bool midi_mask_passes(MidiMask *mask, const MidiMessage *message, double now);
/** Writes --mask-time, if given, to *time [s]. */
Outcome midi_mask_read(const Arguments *arguments, double *time);

#endif
