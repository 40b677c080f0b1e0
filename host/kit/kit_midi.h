/* SPDX-License-Identifier: MIT */
/**
 * @file kit_midi.h
 * Converts MIDI messages to events of a kit. Each drum has its own converter (midi_to_events.h)
 * with the default map of controllers and the kit's notes: a note, its end and its key pressure go
 * to the drum that the note plays; controllers, channel pressure and silences go to all drums.
 * Program changes do nothing. A sample is the user's own and takes its note from a drum.
 *
 * With a map by name (kit_map.h) notes are those of that instrument. The controllers 16 and 17 then
 * do not move all drums: one controller moves the strokes of drums that play General MIDI's snare
 * notes, another one those that play its toms.
 */
#ifndef TABOR_HOST_KIT_MIDI_H
#define TABOR_HOST_KIT_MIDI_H

#include <tabor/kit.h>

#include "midi/kit_map.h"
#include "midi/midi_to_events.h"
#include "strokes/humanize.h"

#define KIT_MIDI_NOBODY 0xff
#define KIT_MIDI_NOWHERE (UINT32_MAX - 2u)                         /**< no address of an event */
#define KIT_MIDI_MOST_EVENTS (MIDI_MOST_ACTIONS * TABOR_KIT_DRUMS) /**< of one message */

/** What the options for MIDI say. */
typedef struct KitMidiSetup {
  MidiResponse response;
  int channel;                     /**< 0 to 15, or MIDI_OMNI */
  const KitMap *map;               /**< NULL: General MIDI */
  uint8_t snare_place, toms_place; /**< controllers of a stroke's radius; of a map by name only */
} KitMidiSetup;

/** Linear curve, normal range, every channel, General MIDI; places by 16 and 18. */
extern const KitMidiSetup kit_midi_setup_default;

typedef struct KitMidi {
  uint32_t count;                      /**< drums */
  uint8_t owner[MIDI_VALUES];          /**< drum of each note, or KIT_MIDI_NOBODY */
  uint8_t general[MIDI_VALUES];        /**< what each note stands for (kit_map.h) */
  bool has_sample[MIDI_VALUES];        /**< of a General MIDI note */
  uint64_t unknown[MIDI_VALUES];       /**< strokes on notes that play no drum */
  uint64_t strokes[TABOR_KIT_DRUMS];   /**< on each drum */
  double head_radius[TABOR_KIT_DRUMS]; /**< [m] */
  MidiMap maps[TABOR_KIT_DRUMS];
  MidiToEvents drums[TABOR_KIT_DRUMS];
} KitMidi;

/** SET-UP. What an instrument's note does to a drum of the kit. */
MidiStroke kit_midi_stroke(const TaborKitDrumDef *drum, const KitMapNote *note);
/** SET-UP. Initialises *midi, which has some 500 kB and must not be moved, for @p kit. */
void kit_midi_begin(KitMidi *midi, const TaborKitDef *kit, const KitMidiSetup *setup);
/** AUDIO. Goes on with what controllers and notes have moved in @p from, which is of a kit with the
 * same drums and notes. */
void kit_midi_follow(KitMidi *midi, const KitMidi *from) REALTIME;
/** AUDIO. Forgets what controllers and notes have moved; counts stay. */
void kit_midi_rest(KitMidi *midi) REALTIME;
/** AUDIO. Writes what @p message does to @p events, frames aside; returns how many events. One for
 * a sample is addressed to TABOR_KIT_NOTE and the note of General MIDI. */
uint32_t kit_midi_take(KitMidi *midi, const MidiMessage *message,
                       TaborKitEvent events[KIT_MIDI_MOST_EVENTS]) REALTIME;
/** AUDIO. Scatters @p event if it is a stroke on a drum. */
void kit_midi_humanize(const KitMidi *midi, Humanizer *humanizer, TaborKitEvent *event) REALTIME;
/** Where the events of a note go: a drum, or the sound of a note; KIT_MIDI_NOWHERE if it plays
 * nothing. */
uint32_t kit_midi_address(const KitMidi *midi, uint8_t note) REALTIME;
/** Number of strokes on notes that play no drum. */
uint64_t kit_midi_unknown(const KitMidi *midi) REALTIME;
/** Name of a note of General MIDI's percussion, as "closed hi-hat"; NULL for others. */
const char *kit_midi_note_name(int note);

#endif
