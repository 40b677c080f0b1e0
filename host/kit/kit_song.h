/* SPDX-License-Identifier: MIT */
/**
 * @file kit_song.h
 * A MIDI file converted to events of a kit, each at its frame.
 */
#ifndef TABOR_HOST_KIT_SONG_H
#define TABOR_HOST_KIT_SONG_H

#include "kit/kit_midi.h"
#include "midi/midi_file_input.h"
#include "strokes/humanize.h"

typedef struct KitSong {
  TaborKitEvent *events; /**< sorted by frame, which counts from the start */
  size_t count;
  uint32_t last_frame; /**< of the last event */
} KitSong;

/**
 * Reads the file of --midi-file for the kit of @p midi at @p rate [Hz]; strokes are scattered by @p humanizer. Refuses a file in
 * which no note plays a drum. Free with kit_song_free(), whatever the outcome.
 */
Outcome kit_song_read(const Arguments *arguments, KitMidi *midi, Humanizer humanizer, double rate,
                      KitSong *song);
/** Prints the notes that play no drum, each once, with its name and number of strokes. */
void kit_song_note(const char *name, const KitMidi *midi);
void kit_song_free(KitSong *song);

#endif
