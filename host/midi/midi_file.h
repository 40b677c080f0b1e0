/* SPDX-License-Identifier: MIT */
/**
 * @file midi_file.h
 * Standard MIDI Files, formats 0 and 1: channel messages with their times in seconds.
 *
 * Tracks are merged by time, then by their order in the file. A tempo change in any track applies to all
 * tracks from its tick on; the initial tempo is 120 quarters a minute. An SMPTE division has no tempo.
 * The reader skips meta events other than tempo and end of track, system exclusive data, chunks that are
 * not tracks, and bytes after the last track.
 *
 * Truncated or invalid data is refused with its byte offset. Work and memory are proportional to the
 * file's size.
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
  double length; /**< time of the end of the longest track [s] */
} MidiFile;

/** Reads file @p name, "-" for standard input. Free with midi_file_free(), whatever the outcome. */
Outcome midi_file_read(const char *name, MidiFile *file);
/** Reads a file from @p size bytes in memory; messages call it @p name. */
Outcome midi_file_parse(const char *name, const void *bytes, size_t size, MidiFile *file);
void midi_file_free(MidiFile *file);

#endif
