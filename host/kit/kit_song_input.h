/* SPDX-License-Identifier: MIT */
/**
 * @file kit_song_input.h
 * The MIDI file and the strokes of the command line, for a kit (kit_song.h).
 */
#ifndef TABOR_HOST_KIT_SONG_INPUT_H
#define TABOR_HOST_KIT_SONG_INPUT_H

#include "kit/kit_song.h"
#include "midi/midi_file_input.h"

/**
 * Reads what is played on @p kit at @p rate [Hz]: the file of --midi-file, by @p midi, and the
 * strokes of --strike and --events, which
 * @p humanizer scatters. Refuses a file in which no note plays a drum. Free with kit_song_free(),
 * whatever the outcome.
 */
Outcome kit_song_read(const Arguments *arguments, const TaborKitDef *kit, KitMidi *midi,
                      Humanizer humanizer, double rate, KitSong *song);
/** Prints the notes that play no drum, each once, with its name and number of strokes. */
void kit_song_note(const char *name, const KitMidi *midi);

#endif
