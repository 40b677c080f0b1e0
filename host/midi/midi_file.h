/* SPDX-License-Identifier: MIT */
/**
 * @file midi_file.h
 * Standard MIDI Files, formats 0 and 1, also inside RIFF (RMID): channel messages with their times
 * in seconds. The one reader of the program, the Python package and the web page: it opens and
 * prints nothing.
 *
 * Tracks are merged by time, then by their order in the file. All tracks that are there play,
 * whatever the header announces. A tempo change in any track applies to all tracks from its tick
 * on; the initial tempo is 120 quarters a minute. An SMPTE division has no tempo. The reader skips
 * meta events other than tempo and end of track, system exclusive data and chunks that are not
 * tracks.
 *
 * What is wrong and touches no note is passed over with a warning: a data byte over 127 in any
 * other message, a system message, a tempo of 0 or of another length than three bytes, a meta event
 * of a wrong length, a time of five to eight bytes, bytes between chunks and behind the end of a
 * track, a wrong number of tracks, an event other than a note in which a track breaks off.
 * Everything else that is wrong or truncated is refused. Messages begin with the byte's offset in
 * the file. Work and memory are proportional to the file's size.
 */
#ifndef TABOR_HOST_MIDI_FILE_H
#define TABOR_HOST_MIDI_FILE_H

#include <stddef.h>

#include "midi/midi_stream.h"

#define MIDI_FILE_LIMIT (16 * 1024 * 1024) /**< bytes */
#define MIDI_FILE_MOST_TRACKS 1024
#define MIDI_FILE_MOST_EVENTS 1000000 /**< channel messages and tempo changes together */
#define MIDI_FILE_MOST_WARNINGS 8     /**< that are kept; more are counted */
#define MIDI_FILE_TEXT 160            /**< bytes of a message */

typedef struct MidiFileEvent {
  double time; /**< [s] */
  MidiMessage message;
} MidiFileEvent;

typedef struct MidiFile {
  MidiFileEvent *events; /**< in order of time */
  size_t count;
  double length; /**< time of the end of the longest track [s] */
} MidiFile;

typedef enum MidiFileStatus { MIDI_FILE_OK, MIDI_FILE_REFUSED, MIDI_FILE_NO_MEMORY } MidiFileStatus;

/** What was wrong. */
typedef struct MidiFileReport {
  char error[MIDI_FILE_TEXT];                                /**< of a file that was refused */
  uint32_t warnings;                                         /**< all of them */
  uint32_t lines;                                            /**< that tell of them */
  char warning[MIDI_FILE_MOST_WARNINGS + 1][MIDI_FILE_TEXT]; /**< the last may count others */
} MidiFileReport;

/** Reads a file from @p size bytes in memory. Free with midi_file_free(), whatever the status. */
MidiFileStatus midi_file_decode(const void *bytes, size_t size, MidiFile *file,
                                MidiFileReport *report);
void midi_file_free(MidiFile *file);

#endif
