/* SPDX-License-Identifier: MIT */
/**
 * @file midi_options.h
 * Reads the options of the command line for MIDI.
 */
#ifndef TABOR_HOST_MIDI_OPTIONS_H
#define TABOR_HOST_MIDI_OPTIONS_H

#include "base/options.h"
#include "midi/midi_map.h"

/** Rows of the option tables for the options that midi_map_read() reads. */
#define OPTION_MIDI_MAP                                                                            \
  { "midi-map", 0, "FILE", "what notes and controllers do (docs/midi.md)" }
#define OPTION_MIDI_CHANNEL                                                                        \
  { "midi-channel", 0, "N", "hear one channel only, 1 to 16 (default omni: all)" }
#define OPTION_VELOCITY_CURVE                                                                      \
  {                                                                                                \
    "velocity-curve", 0, "CURVE",                                                                  \
      "soft, linear or hard (default linear): how MIDI velocities become speeds"                   \
  }
#define OPTION_VELOCITY_RANGE                                                                      \
  {                                                                                                \
    "velocity-range", 0, "RANGE",                                                                  \
      "normal or full (default normal): 1 to 10 m/s or 0.3 to 12; docs/midi.md"                    \
  }

/** Writes --velocity-curve and --velocity-range, if given, to *response. */
Outcome midi_response_read(const Arguments *arguments, MidiResponse *response);
/**
 * Reads the default map, or the map of --midi-map, and applies the other options above. Refuses a
 * map that names a striker unknown to @p def.
 */
Outcome midi_map_read(const Arguments *arguments, const TaborDrumDef *def, MidiMap *map);

#endif
