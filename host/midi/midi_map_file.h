/* SPDX-License-Identifier: MIT */
/**
 * @file midi_map_file.h
 * `--midi-map`: reads a MIDI map from a file. The file changes the default map or, with `defaults =
 * no`, replaces it. It is an INI file and checked like a preset (preset_file.h):
 *
 *     [map]                   ; comes first
 *     channel = 10            ; 1 to 16, or omni
 *     velocity = soft         ; soft, linear, hard
 *     velocity_range = full   ; normal, full
 *     defaults = yes          ; no: start with an empty map
 *     pressure = yes          ; no: pressure does nothing
 *     programs = yes          ; no: program changes do nothing
 *
 *     [note.60]               ; 0 to 127
 *     stroke = head           ; head (the default), rimshot, cross-stick, rim, buzz, sweep,
 *                             ; none
 *     radius = 30             ; per cent of the head, 0 to 100
 *     angle = 90              ; degrees, -360 to 360
 *     speed = 0.5             ; factor, 0.01 to 10
 *     striker = mallet        ; one of the drum's, by name
 *
 *     [controller.74]         ; 0 to 127
 *     moves = wires.tension   ; a live key; radius, angle, grip, strainer, gain, silence, none
 *     from = 2                ; the key's value for 0, and
 *     to = 12                 ; for 127; without these, its whole range
 */
#ifndef TABOR_HOST_MIDI_MAP_FILE_H
#define TABOR_HOST_MIDI_MAP_FILE_H

#include "base/message.h"
#include "midi/midi_map.h"

/** Reads file @p path into *map; refuses an error with its line number. */
Outcome midi_map_file_read(const char *path, MidiMap *map);
/** Reads what follows `moves =`: a live key, which moves over its whole range, or radius, angle,
 * grip, strainer, gain, silence or none. Refuses other text with a message that starts with @p
 * where. */
Outcome midi_control_read(const char *where, const char *text, MidiControl *control);
/** Adds to map file @p path that @p controller moves what @p text says; it wins over what the file
 * has said before. */
Outcome midi_map_file_add(const char *path, int controller, const char *text);
/** Reads soft, linear or hard; refuses other text with a message that starts with @p where. */
Outcome midi_curve_read(const char *where, const char *text, MidiCurve *curve);
/** Reads normal or full; refuses other text likewise. */
Outcome midi_range_read(const char *where, const char *text, MidiRange *range);
/** Reads "omni" or a number from 1 to 16; *channel counts from 0. Refuses other text likewise. */
Outcome midi_channel_read(const char *where, const char *text, int *channel);

#endif
