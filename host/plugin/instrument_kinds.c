/* SPDX-License-Identifier: MIT */
/* The plugins in hosts' lists. */
#include "plugin/drum_instrument.h"
#include "plugin/kit_instrument.h"
#include "plugin/kit_knobs.h"
#include "plugin/knobs.h"
#include "plugin/plugin_player.h"

static const InstrumentOutput pair[] = {{"Stereo", 0, 2}};

static const InstrumentOutput mics[] = {{"Stereo", PLUGIN_LEFT, 2},   {"Top", PLUGIN_TOP, 1},
                                        {"Bottom", PLUGIN_BOTTOM, 1}, {"Near", PLUGIN_NEAR, 1},
                                        {"Far", PLUGIN_FAR, 1},       {"Inside", PLUGIN_INSIDE, 1}};

static const InstrumentOutput drums[] = {{"Mix", 0, 2},     {"Drum 1", 2, 2},  {"Drum 2", 4, 2},
                                         {"Drum 3", 6, 2},  {"Drum 4", 8, 2},  {"Drum 5", 10, 2},
                                         {"Drum 6", 12, 2}, {"Drum 7", 14, 2}, {"Drum 8", 16, 2}};

#define LENGTH(list) (sizeof(list) / sizeof(list)[0])

#define OUTPUTS(list) .outputs = (list), .output_count = LENGTH(list)

#define DRUM(set)                                                                                  \
  .calls = &drum_instrument, .variant = (set), .knob_count = KNOB_COUNT, .knobs = knobs,           \
  .order = knob_ports, .main_knob = KNOB_DRUM, .seen_count = KNOB_SEEN, .groups = knob_groups,     \
  .group_count = KNOB_GROUPS, .pages = knob_pages, .page_count = KNOB_PAGES,                       \
  .preset = tabor_preset, .preset_count = tabor_preset_count

#define COMMENT                                                                                    \
  "Heads that move air, wires that bounce on them, a stick that strikes: no samples. Notes 36 to " \
  "50 are strokes; controllers 16 and 17 move the place, 20 the strainer; program changes choose " \
  "drums."

_Static_assert((int)KNOB_COUNT <= INSTRUMENT_KNOBS && (int)KIT_KNOB_COUNT <= INSTRUMENT_KNOBS,
               "an instrument has room for its knobs");

const InstrumentKind instrument_kinds[INSTRUMENT_KINDS] = {
  [INSTRUMENT_STEREO] = {.id = INSTRUMENT_STEREO,
                         .name = "Tabor",
                         .brief = "A snare drum computed from physics",
                         .comment = COMMENT,
                         .channels = 2,
                         OUTPUTS(pair),
                         DRUM(KNOBS_STEREO)},
  [INSTRUMENT_MULTI] = {.id = INSTRUMENT_MULTI,
                        .name = "Tabor Multi",
                        .brief = "A snare drum computed from physics, an output per microphone",
                        .comment = COMMENT,
                        .channels = PLUGIN_MICS,
                        OUTPUTS(mics),
                        DRUM(KNOBS_MULTI)},
  [INSTRUMENT_EFFECT] =
    {.id = INSTRUMENT_EFFECT,
     .name = "Tabor Rattle",
     .brief = "A loudspeaker plays the sound to a snare drum, whose snares rattle",
     .comment = "What comes in drives the heads as sound does, the snares with them. " COMMENT,
     .has_input = true,
     .channels = 2,
     OUTPUTS(pair),
     DRUM(KNOBS_EFFECT)},
  [INSTRUMENT_KIT] = {.id = INSTRUMENT_KIT,
                      .name = "Tabor Kit",
                      .brief = "A drum kit computed from physics, an output per drum",
                      .comment = "Drums that stand in one room and hear each other: no samples. "
                                 "Notes are those of General MIDI or of a drum module; each drum "
                                 "has an output, a level and a tuning.",
                      .calls = &kit_instrument,
                      .channels = 2 + 2 * KIT_KNOB_DRUMS,
                      OUTPUTS(drums),
                      .knob_count = KIT_KNOB_COUNT,
                      .knobs = kit_knobs,
                      .main_knob = KIT_KNOB_KIT,
                      .groups = kit_knob_groups,
                      .group_count = KIT_KNOB_GROUPS,
                      .pages = kit_knob_pages,
                      .page_count = KIT_KNOB_PAGES,
                      .preset = tabor_kit,
                      .preset_count = tabor_kit_count}};
