/* SPDX-License-Identifier: MIT */
/**
 * @file sound_input.h
 * --input: a sound that a loudspeaker plays to the drum.
 */
#ifndef TABOR_HOST_SOUND_INPUT_H
#define TABOR_HOST_SOUND_INPUT_H

#include "base/options.h"

#define SOUND_INPUT_LEVEL 20.0 /**< default of --input-level [Pa]: 120 dB */

/** Rows of an option table for the options that sound_input_read() reads. */
#define OPTION_INPUT                                                                               \
  { "input", 0, "FILE", "a sound that a loudspeaker plays to the drum; see below" }
#define OPTION_INPUT_LEVEL                                                                         \
  { "input-level", 0, "PA", "pressure of its full scale at the drum, 0.001 to 1000 (default 20)" }
#define OPTION_INPUT_MIC                                                                           \
  {                                                                                                \
    "input-mic", 0, "NAME",                                                                        \
      "microphone at whose place the loudspeaker stands (default: the first)"                      \
  }

typedef struct SoundInput {
  float *pressure; /**< [Pa] at the centre of the batter head; NULL: none */
  uint32_t count;  /**< frames */
  uint32_t mic;    /**< index among the definition's microphones */
} SoundInput;

/** Reads the first channel of the file of --input, if given, for @p def at @p rate [Hz], which the
 * file must have. Free with sound_input_free(), whatever the outcome. */
Outcome sound_input_read(const Arguments *arguments, const TaborDrumDef *def, double rate,
                         SoundInput *input);
/** Copies @p count frames from frame @p first on to @p to; 0 past the end. */
void sound_input_take(const SoundInput *input, uint64_t first, uint32_t count, float *to);
void sound_input_free(SoundInput *input);

#endif
