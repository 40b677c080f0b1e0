/* SPDX-License-Identifier: MIT */
/**
 * @file song_events.h
 * The bytes of a MIDI file as events of a drum or a kit, for callers in other languages: the Python
 * package and the web page. They read files with the reader and the maps of `tabor render
 * --midi-file`, and refuse and warn in its words.
 *
 * A program change is an event of the type TABOR_EVENT_REPLACE, whose index is the number of the
 * preset.
 */
#ifndef TABOR_HOST_SONG_EVENTS_H
#define TABOR_HOST_SONG_EVENTS_H

#include <stdbool.h>
#include <stddef.h>
#include <tabor/kit.h>

/** A file that was read, and its events once it was composed. */
typedef struct SongEvents SongEvents;

/** The largest size of a file [bytes]. */
TABOR_API size_t song_events_most_bytes(void);
/** Reads @p size bytes; more than allowed are refused. NULL without memory. Free with
 * song_events_free(). */
TABOR_API SongEvents *song_events_read(const void *bytes, size_t size);
/** Why the file or its song is refused; "" if it is not. */
TABOR_API const char *song_events_error(const SongEvents *song);
/** Number of lines that tell of what was passed over: by the reader, and of the notes that a kit
 * does not play once it is composed. */
TABOR_API uint32_t song_events_warning_count(const SongEvents *song);
/** One of these lines. */
TABOR_API const char *song_events_warning(const SongEvents *song, uint32_t index);
/**
 * Composes the song for the drum @p def at @p rate [Hz], by the default map; program changes do
 * nothing unless @p programs.
 * @p preset is the number of the built-in preset that @p def is, or -1. False without memory, or
 * with an error.
 */
TABOR_API bool song_events_of_drum(SongEvents *song, const TaborDrumDef *def, bool programs,
                                   int preset, double rate);
/**
 * Composes the song for the drums of @p kit at @p rate [Hz]. @p map is the number of a map by name,
 * or -1 for General MIDI; with a map @p snare_place and @p toms_place are the controllers of a
 * stroke's radius. False without memory, or with an error.
 */
TABOR_API bool song_events_of_kit(SongEvents *song, const TaborKitDef *kit, int map,
                                  uint32_t snare_place, uint32_t toms_place, double rate);
/** The name of a map, from 0 on; NULL past the last one. */
TABOR_API const char *song_events_map_name(uint32_t map);
/** The events of the composed song, in the order in which they act; frames count from the start.
 * The drum is 0 unless it is a kit's. */
TABOR_API const TaborKitEvent *song_events_list(const SongEvents *song);
/** How many these are. */
TABOR_API size_t song_events_count(const SongEvents *song);
/** Frees a song; NULL is allowed. */
TABOR_API void song_events_free(SongEvents *song);

#endif
