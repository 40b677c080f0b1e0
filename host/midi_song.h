/* SPDX-License-Identifier: MIT */
/**
 * @file midi_song.h
 * A MIDI file as a drum plays it: what happens at which frame.
 *
 * At one time controllers and program changes act before notes, in whatever track they stand; of a
 * kind the order is the file's. A program change binds what follows to the preset that it chooses, as
 * that is listed: without the changes that --set made to the first one.
 */
#ifndef TABOR_HOST_MIDI_SONG_H
#define TABOR_HOST_MIDI_SONG_H

#include <math.h>

#include "midi_drum.h"
#include "options.h"

#define MIDI_SONG_LONGEST 3600 /**< [s] until the last message */
#define MIDI_SONG_MOST_STROKES 100000
#define MIDI_SONG_MOST_PRESETS 1000 /**< program changes that change something */

#define OPTION_MIDI_FILE                                                                           \
  { "midi-file", 0, "FILE", "strokes from a MIDI file, '-' for standard input; see below" }

typedef struct MidiSongItem {
  double time; /**< since the beginning [s], 0 to MIDI_SONG_LONGEST */
  MidiAction action;
} MidiSongItem;

typedef struct MidiSong {
  MidiSongItem *items; /**< in order */
  size_t count;
  uint32_t presets; /**< of these, changes of preset */
  int first_preset; /**< place of the preset that it begins with, -1 if it is none that is listed */
  MidiCounts counts;
} MidiSong;

/** Its frame at @p rate [Hz]. */
static inline uint32_t midi_song_frame(const MidiSongItem *item, double rate) {
  return (uint32_t)llround(item->time * rate);
}

/**
 * Reads the file of --midi-file, if there is one, by @p map for @p def. Refuses one without any stroke.
 * Free with midi_song_free(), whatever the outcome.
 */
Outcome midi_song_read(const Arguments *arguments, const MidiMap *map, const TaborDrumDef *def,
                       MidiSong *song);
/**
 * Moves the events, with their frames at @p rate, out of the song, which keeps the other actions.
 * *events is the caller's to free().
 */
Outcome midi_song_take_events(MidiSong *song, double rate, TaborEvent **events, size_t *count);
/**
 * Of the program changes at one frame of @p rate [Hz] the last one counts, and acts before all else; one to the
 * preset that is there already does nothing. To be called before the song is played.
 */
void midi_song_settle(MidiSong *song, double rate);
/** Says how many notes were passed over, if any were. */
void midi_song_note(const Arguments *arguments, const MidiSong *song);
void midi_song_free(MidiSong *song);

#endif
