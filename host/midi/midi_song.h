/* SPDX-License-Identifier: MIT */
/**
 * @file midi_song.h
 * A MIDI file converted to actions of a drum, each at its frame.
 *
 * At one frame, controllers and program changes act before notes, in every track; messages of one kind keep
 * the file's order. After a program change the chosen preset plays as listed, without the changes that
 * --set made to the first preset. The last program change at a frame wins and is applied first. A change
 * to the current preset does nothing.
 */
#ifndef TABOR_HOST_MIDI_SONG_H
#define TABOR_HOST_MIDI_SONG_H

#include "base/options.h"
#include "midi/midi_file_input.h"
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

/**
 * Reads the file of --midi-file, if given, with @p map for the drum @p def at @p rate [Hz]. Refuses a file
 * without any stroke. Free with midi_song_free(), whatever the outcome.
 */
Outcome midi_song_read(const Arguments *arguments, const MidiMap *map, const TaborDrumDef *def,
                       double rate, MidiSong *song);
/** Converts the same song again, for another @p rate [Hz]. */
Outcome midi_song_compose(MidiSong *song, const MidiMap *map, const TaborDrumDef *def, double rate);
/**
 * Moves the events out of the song, which keeps the other actions. The caller frees *events with free().
 */
Outcome midi_song_take_events(MidiSong *song, TaborEvent **events, size_t *count);
/** Prints the number of ignored notes, if there were any. */
void midi_song_note(const Arguments *arguments, const MidiSong *song);
void midi_song_free(MidiSong *song);

#endif
