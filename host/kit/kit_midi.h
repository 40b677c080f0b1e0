/* SPDX-License-Identifier: MIT */
/**
 * @file kit_midi.h
 * Converts MIDI messages to events of a kit. Each drum has its own converter (midi_to_events.h) with the default map of
 * controllers and the kit's notes: a note, its end and its key pressure go to the drum that the note plays;
 * controllers, channel pressure and silences go to all drums. Program changes do nothing.
 */
#ifndef TABOR_HOST_KIT_MIDI_H
#define TABOR_HOST_KIT_MIDI_H

#include <tabor/kit.h>

#include "midi/midi_to_events.h"

#define KIT_MIDI_NOBODY 0xff
/** Address of a stroke on a note with a sample (kit_samples.h): this and the note. Its velocity is the strength, 0 to 1. */
#define KIT_MIDI_SAMPLE 0x1000u

typedef struct KitMidi {
  uint32_t count;                      /**< drums */
  uint8_t owner[MIDI_VALUES];          /**< drum of each note, or KIT_MIDI_NOBODY */
  bool has_sample[MIDI_VALUES];        /**< to be set after kit_midi_begin() */
  uint64_t unknown[MIDI_VALUES];       /**< strokes on notes that play no drum */
  uint64_t strokes[TABOR_KIT_DRUMS];   /**< on each drum */
  double head_radius[TABOR_KIT_DRUMS]; /**< [m] */
  MidiMap maps[TABOR_KIT_DRUMS];
  MidiToEvents drums[TABOR_KIT_DRUMS];
} KitMidi;

/** SET-UP. Initialises *midi, which has some 500 kB and must not be moved, for @p kit. @p channel: 0 to 15 or MIDI_OMNI. */
void kit_midi_begin(KitMidi *midi, const TaborKitDef *kit, MidiResponse response, int channel);
/** AUDIO. Writes what @p message does to @p events, frames aside; returns how many events. */
uint32_t kit_midi_take(KitMidi *midi, const MidiMessage *message,
                       TaborKitEvent events[TABOR_KIT_DRUMS]) REALTIME;
/** Name of a note of General MIDI's percussion, as "closed hi-hat"; NULL for others. */
const char *kit_midi_note_name(int note);

#endif
