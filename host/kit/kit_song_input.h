/* SPDX-License-Identifier: MIT */
/**
 * @file kit_song_input.h
 * The MIDI file of the command line, for a kit (kit_song.h).
 */
#ifndef TABOR_HOST_KIT_SONG_INPUT_H
#define TABOR_HOST_KIT_SONG_INPUT_H

#include "kit/kit_song.h"
#include "midi/midi_file_input.h"

/**
 * Reads the file of --midi-file for the kit of @p midi at @p rate [Hz]; strokes are scattered by @p humanizer. Refuses a file in
 * which no note plays a drum. Free with kit_song_free(), whatever the outcome.
 */
Outcome kit_song_read(const Arguments *arguments, KitMidi *midi, Humanizer humanizer, double rate,
                      KitSong *song);
/** Prints the notes that play no drum, each once, with its name and number of strokes. */
void kit_song_note(const char *name, const KitMidi *midi);

#endif
