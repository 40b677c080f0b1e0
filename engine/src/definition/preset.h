/* SPDX-License-Identifier: MIT */
/**
 * @file preset.h
 * The built-in presets: a table of the files of presets/, written by engine/embed-presets.cmake
 * when the library is built.
 */
#ifndef TABOR_SRC_PRESET_H
#define TABOR_SRC_PRESET_H

#include "tabor/tabor.h"

/** A line of a preset: "batter.tension", "3000". A section's line is "batter", NULL. */
typedef struct TbPresetPair {
  const char *key, *value;
} TbPresetPair;

typedef struct TbPreset {
  TaborPresetInfo info;
  const TbPresetPair *pairs;
  uint32_t pair_count;
} TbPreset;

extern const TbPreset tb_presets[];
extern const uint32_t tb_preset_count;

#endif /* TABOR_SRC_PRESET_H */
