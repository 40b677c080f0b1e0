/* SPDX-License-Identifier: MIT */
/**
 * @file kit_map.h
 * Maps by name for what people play kits with: drum modules and drum plugins. A map has a row for
 * each note of the instrument: the note of General MIDI's percussion that it stands for, which
 * names the drum or the sample of the kit, and how the drum is struck. Choke notes of cymbals and
 * layers of the user are left out; such notes play nothing.
 *
 * The rim of a module's pad is a rimshot: "head shot and rim shot" are the head and the rim in
 * [RolandTD27]. Yamaha's open rim is a rimshot, its closed rim a cross-stick.
 */
#ifndef TABOR_HOST_KIT_MAP_H
#define TABOR_HOST_KIT_MAP_H

#include "midi/midi_map.h"

#define KIT_MAP_NOTHING 0xff

typedef struct KitMapNote {
  uint8_t note;      /**< of the instrument */
  uint8_t general;   /**< note of General MIDI's percussion, or KIT_MAP_NOTHING */
  MidiStroke stroke; /**< MIDI_STROKE_NONE: as the kit plays the General MIDI note */
} KitMapNote;

typedef struct KitMap {
  const char *name; /**< "roland" */
  const KitMapNote *notes;
  size_t count;
} KitMap;

/** The maps, in the order of the help. */
extern const KitMap kit_maps[];
extern const size_t kit_map_count;

/** The map called @p name, or NULL. */
const KitMap *kit_map_find(const char *name);
/** Writes a row for every note to @p table; @p map NULL: General MIDI, each note stands for itself.
 */
void kit_map_table(const KitMap *map, KitMapNote table[MIDI_VALUES]);

#endif
