/* SPDX-License-Identifier: MIT */
/**
 * @file kit_options.h
 * Reads the options of the command line for MIDI on a kit.
 */
#ifndef TABOR_HOST_KIT_OPTIONS_H
#define TABOR_HOST_KIT_OPTIONS_H

#include "base/options.h"
#include "kit/kit_midi.h"

/** Rows of the option tables for the options of kits that kit_midi_setup_read() reads. */
#define OPTION_MAP                                                                                 \
  {                                                                                                \
    "map", 0, "MAP",                                                                               \
      "roland, yamaha, alesis, superior or addictive (default: General MIDI's): notes of --kit"    \
  }
#define OPTION_PLACE_CC                                                                            \
  {                                                                                                \
    "place-cc", 0, "LIST",                                                                         \
      "controllers of a stroke's place with --map: snare drum, toms (default 16,18)"               \
  }

/** Reads --map, --place-cc, --midi-channel, --velocity-curve and --velocity-range. */
Outcome kit_midi_setup_read(const Arguments *arguments, KitMidiSetup *setup);
/** Refuses the options that only a kit has. */
Outcome kit_options_refuse(const Arguments *arguments);

#endif
