/* SPDX-License-Identifier: MIT */
/**
 * @file midi_song.h
 * A MIDI file as a drum plays it: what happens at which frame.
 *
 * At one frame controllers and program changes count before notes, in whatever track they stand; of a
 * kind the order is the file's. A program change binds what follows to the preset that it chooses, as
 * that is listed: without the changes that --set made to the first one. Of the program changes at one frame the
 * last one counts, and acts before all else; one to the preset that is there already does nothing.
 */
#ifndef TABOR_HOST_MIDI_SONG_H
#define TABOR_HOST_MIDI_SONG_H

#include "base/options.h"
#include "midi/midi_file.h"
#include "midi/midi_to_events.h"

#define MIDI_SONG_LONGEST 3600 /**< [s] until the last message */
#define MIDI_SONG_MOST_STROKES 100000
#define MIDI_SONG_MOST_PRESETS 1000 /**< program changes that change something */

#define OPTION_MIDI_FILE                                                                           \
  { "midi-file", 0, "FILE", "strokes from a MIDI file, '-' for standard input; see below" }

typedef struct MidiSongItem {
  uint32_t frame;     /**< since the beginning */
  size_t place;       /**< among the messages, as they count */
  double head_radius; /**< of the drum that the action is meant for, or changes to [m] */
  MidiAction action;
} MidiSongItem;

typedef struct MidiSong {
  MidiFile file;
  MidiSongItem
    *items; /**< by frames; of one frame changes of preset, then all but events, then events */
  size_t count;
  uint32_t presets; /**< of these, changes of preset */
  int first_preset; /**< place of the preset that it begins with, -1 if it is none that is listed */
  MidiCounts counts;
} MidiSong;

/**
 * Reads the file of --midi-file, if there is one, by @p map for @p def at @p rate [Hz]. Refuses one without any
 * stroke. Free with midi_song_free(), whatever the outcome.
 */
Outcome midi_song_read(const Arguments *arguments, const MidiMap *map, const TaborDrumDef *def,
                       double rate, MidiSong *song);
/** The same song at another @p rate. */
Outcome midi_song_compose(MidiSong *song, const MidiMap *map, const TaborDrumDef *def, double rate);
/**
 * Moves the events out of the song, which keeps the other actions. *events is the caller's to free().
 */
Outcome midi_song_take_events(MidiSong *song, TaborEvent **events, size_t *count);
/** Says how many notes were passed over, if any were. */
void midi_song_note(const Arguments *arguments, const MidiSong *song);
void midi_song_free(MidiSong *song);

#endif
