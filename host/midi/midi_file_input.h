/* SPDX-License-Identifier: MIT */
/**
 * @file midi_file_input.h
 * MIDI files of the command line: warnings are printed, or with --strict refused.
 */
#ifndef TABOR_HOST_MIDI_FILE_INPUT_H
#define TABOR_HOST_MIDI_FILE_INPUT_H

#include "base/options.h"
#include "midi/midi_file.h"

#define OPTION_MIDI_FILE                                                                           \
  { "midi-file", 0, "FILE", "strokes from a MIDI file, '-' for standard input; see below" }
#define OPTION_STRICT                                                                              \
  { "strict", 0, NULL, "refuse a MIDI file in which anything is wrong, instead of a warning" }

/** Reads the file @p name, "-" for standard input. Free with midi_file_free(), whatever the
 * outcome. */
Outcome midi_file_read(const char *name, bool strict, MidiFile *file);
/** Reads the file of --midi-file, which is there, with --strict and --mask-time. Free it in the
 * same way. */
Outcome midi_file_of_arguments(const Arguments *arguments, MidiFile *file);
/** Reads a file from @p size bytes in memory; messages call it @p name. */
Outcome midi_file_parse(const char *name, const void *bytes, size_t size, bool strict,
                        MidiFile *file);

#endif
