/* SPDX-License-Identifier: MIT */
/**
 * @file kit_song.h
 * A MIDI file converted to events of a kit, each at its frame.
 */
#ifndef TABOR_HOST_KIT_SONG_H
#define TABOR_HOST_KIT_SONG_H

#include "kit/kit_midi.h"
#include "midi/midi_file.h"
#include "strokes/humanize.h"
#include "strokes/strokes.h"

#define KIT_SONG_LINE 1024

typedef struct KitSong {
  TaborKitEvent *events; /**< sorted by frame, which counts from the start */
  size_t count;
  uint32_t last_frame; /**< of the last event */
} KitSong;

/**
 * Converts @p file, whose times are checked (midi_song_check_time()), for the kit of @p midi at @p
 * rate [Hz]; strokes are scattered by
 * @p humanizer. False without memory. Free with kit_song_free(), whatever the outcome.
 */
bool kit_song_compose(KitSong *song, const MidiFile *file, KitMidi *midi, Humanizer humanizer,
                      double rate);
/** Adds @p strokes to each drum of @p kit, behind the song's own events of their frame; they are
 * scattered by @p humanizer. False without memory. */
bool kit_song_add_strokes(KitSong *song, const TaborKitDef *kit, Humanizer humanizer,
                          const Strokes strokes[TABOR_KIT_DRUMS]);
/** Frame of the last event that is not a release; 0 if there is none. */
uint32_t kit_song_last_stroke(const KitSong *song);
/** Refuses what has no stroke, or too many: false, and the reason in @p error. */
bool kit_song_check(const KitMidi *midi, char error[MIDI_FILE_TEXT]);
/** A line for a person about the notes that @p midi has heard and that play nothing. False if there
 * are none. */
bool kit_song_unplayed(const KitMidi *midi, char line[KIT_SONG_LINE]);
void kit_song_free(KitSong *song);

#endif
