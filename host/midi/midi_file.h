/* SPDX-License-Identifier: MIT */
/**
 * @file midi_file.h
 * Standard MIDI Files, formats 0 and 1: channel messages with their times in seconds.
 *
 * All tracks are merged: by time, then by their order in the file. Tempo changes of any track count from
 * their tick on; before the first it is 120 quarters a minute. Times with an SMPTE division have no tempo.
 * Meta events but tempo and end of track, and system exclusive data, are passed over, as are chunks that
 * are not tracks and bytes behind the last track.
 *
 * Refused, with the byte where it stands: anything that breaks off, and what no file may hold. Work and
 * memory are in proportion to the file's size.
 */
#ifndef TABOR_HOST_MIDI_FILE_H
#define TABOR_HOST_MIDI_FILE_H

#include <stddef.h>

#include "base/message.h"
#include "midi/midi_stream.h"

#define MIDI_FILE_LIMIT (16 * 1024 * 1024) /**< bytes */
#define MIDI_FILE_MOST_TRACKS 1024
#define MIDI_FILE_MOST_EVENTS 1000000 /**< channel messages and tempo changes together */

typedef struct MidiFileEvent {
  double time; /**< [s] */
  MidiMessage message;
} MidiFileEvent;

typedef struct MidiFile {
  MidiFileEvent *events; /**< in order of time */
  size_t count;
  double length; /**< until the end of the longest track [s] */
} MidiFile;

/** Reads file @p name, "-" for the standard input. Free with midi_file_free(), whatever the outcome. */
Outcome midi_file_read(const char *name, MidiFile *file);
/** The same of @p size bytes in memory, which @p name names in messages. */
Outcome midi_file_parse(const char *name, const void *bytes, size_t size, MidiFile *file);
void midi_file_free(MidiFile *file);

#endif
