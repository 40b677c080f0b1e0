/* SPDX-License-Identifier: MIT */
/**
 * @file stereo_pair.h
 * The option --stereo: a drum's microphones left and right, in the room of the drum, or in a studio
 * if it has none and
 * `--set room.kind` does not ask for that.
 */
#ifndef TABOR_HOST_STEREO_PAIR_H
#define TABOR_HOST_STEREO_PAIR_H

#include "base/options.h"

/** A pair a metre away is quieter than a close microphone: a snare drum's by 18 dB. */
#define STEREO_GAIN_DB 12.0

/** A row of the option tables for stereo_pair_take(). */
#define OPTION_STEREO                                                                              \
  { "stereo", 0, NULL, "the microphones left and right, in the drum's room or a studio" }
/** For --stereo: chooses the pair of @p def, in its room or in a studio, and raises @p gain by
 * STEREO_GAIN_DB. */
Outcome stereo_pair_take(const Arguments *arguments, TaborDrumDef *def, uint32_t mics[2],
                         double *gain);

#endif
