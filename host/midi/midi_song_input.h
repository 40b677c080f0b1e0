/* SPDX-License-Identifier: MIT */
/**
 * @file midi_song_input.h
 * The MIDI file of the command line, for a drum (midi_song.h).
 */
#ifndef TABOR_HOST_MIDI_SONG_INPUT_H
#define TABOR_HOST_MIDI_SONG_INPUT_H

#include "midi/midi_file_input.h"
#include "midi/midi_song.h"

/**
 * Reads the file of --midi-file, if given, with @p map for the drum @p def at @p rate [Hz]. Refuses
 * a file without any stroke. Free with midi_song_free(), whatever the outcome.
 */
Outcome midi_song_read(const Arguments *arguments, const MidiMap *map, const TaborDrumDef *def,
                       double rate, MidiSong *song);
/**
 * Moves the events out of the song, which keeps the other actions. The caller frees *events with
 * free().
 */
Outcome midi_song_take_events(MidiSong *song, TaborEvent **events, size_t *count);
/** Prints the number of ignored notes, if there were any. */
void midi_song_note(const Arguments *arguments, const MidiSong *song);

#endif
