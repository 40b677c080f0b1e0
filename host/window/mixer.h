/* SPDX-License-Identifier: MIT */
/**
 * @file mixer.h
 * Mute and solo of the levels of an instrument: of a drum's microphones, of a kit's drums. Both
 * turn levels off and back again, so that the host knows and records what sounds.
 */
#ifndef TABOR_WINDOW_MIXER_H
#define TABOR_WINDOW_MIXER_H

#include "plugin/instrument.h"

/** Begins with zeros. */
typedef struct Mixer {
  bool is_mute[INSTRUMENT_KNOBS], is_solo[INSTRUMENT_KNOBS];
  bool is_off[INSTRUMENT_KNOBS]; /**< by this mixer */
  float level[INSTRUMENT_KNOBS]; /**< before that */
} Mixer;

/** The value of a level that the mixer wants, which now has @p value. */
float mixer_wanted(Mixer *mixer, const InstrumentKind *kind, uint32_t id, float value);
/** Somebody else has turned a level: one that is off no longer is so by this mixer, and mute. */
void mixer_note(Mixer *mixer, const InstrumentKind *kind, uint32_t id, float value);

#endif
