/* SPDX-License-Identifier: MIT */
/**
 * @file midi_order.h
 * The order in which the messages of a MIDI file act: by frames; at one frame, controllers and
 * program changes before notes, in every track; messages of one kind in the order of the file.
 */
#ifndef TABOR_HOST_MIDI_ORDER_H
#define TABOR_HOST_MIDI_ORDER_H

#include "midi/midi_file.h"

/** A message of the file and its place among the others. */
typedef struct MidiPlace {
  uint32_t frame;
  bool is_note; /**< or belongs to one */
  size_t index; /**< in the file */
} MidiPlace;

/** The messages of @p file in their order at @p rate [Hz], as many as the file has; the caller
 * frees them with free(). NULL without memory. */
MidiPlace *midi_order(const MidiFile *file, double rate);

#endif
