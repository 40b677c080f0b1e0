/* SPDX-License-Identifier: MIT */
/**
 * @file midi_song.h
 * A MIDI file converted to actions of a drum, each at its frame.
 *
 * At one frame, controllers and program changes act before notes, in every track; messages of one
 * kind keep the file's order. After a program change the chosen preset plays as listed, without the
 * changes that
 * --set made to the first preset. The last program change at a frame wins and is applied first. A
 * change to the current preset does nothing.
 */
#ifndef TABOR_HOST_MIDI_SONG_H
#define TABOR_HOST_MIDI_SONG_H

#include "midi/midi_file.h"
#include "midi/midi_to_events.h"

#define MIDI_SONG_LONGEST 3600 /**< latest time of the last message [s] */
#define MIDI_SONG_MOST_STROKES 100000
#define MIDI_SONG_MOST_PRESETS 1000 /**< program changes that have an effect */

typedef struct MidiSongItem {
  uint32_t frame;     /**< since the start */
  size_t place;       /**< rank in the order in which messages act */
  double head_radius; /**< of the drum that the action is for, or changes to [m] */
  MidiAction action;
} MidiSongItem;

typedef struct MidiSong {
  MidiFile file;
  /** In order of frames; at one frame: preset changes, then other actions, then events. */
  MidiSongItem *items;
  size_t count;
  uint32_t presets; /**< number of preset changes among the items */
  int first_preset; /**< index of the initial preset among the built-in ones, or -1 */
  MidiCounts counts;
} MidiSong;

/** Refuses a file that is longer than MIDI_SONG_LONGEST: false, and the reason in @p error. To be
 * asked before a song is composed. */
bool midi_song_check_time(const MidiFile *file, char error[MIDI_FILE_TEXT]);
/** Converts the song's file with @p map for the drum @p def at @p rate [Hz], also once more for
 * another one. False without memory. */
bool midi_song_compose(MidiSong *song, const MidiMap *map, const TaborDrumDef *def, double rate);
/** Refuses a composed song that has no stroke, or too much of something: false, and the reason in
 * @p error. */
bool midi_song_check(const MidiSong *song, const MidiMap *map, char error[MIDI_FILE_TEXT]);
/** The same for the number of strokes alone, of a drum or a kit. */
bool midi_song_check_strokes(uint64_t strokes, char error[MIDI_FILE_TEXT]);
void midi_song_free(MidiSong *song);

#endif
