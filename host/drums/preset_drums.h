/* SPDX-License-Identifier: MIT */
/**
 * @file preset_drums.h
 * Drums of the built-in presets, where there is time to wait for the model, which is built once.
 */
#ifndef TABOR_HOST_PRESET_DRUMS_H
#define TABOR_HOST_PRESET_DRUMS_H

#include "base/message.h"

/** All zero but for the options is empty. */
typedef struct PresetDrums {
  const TaborModelOptions *options;
  TaborModel **models; /**< of each built-in preset, or NULL */
} PresetDrums;

/** Creates a drum at rest of built-in preset @p preset. On an error *drum is NULL. */
Outcome preset_drums_create(PresetDrums *presets, uint32_t preset, TaborDrum **drum);
/** The drums stay. */
void preset_drums_free(PresetDrums *presets);

#endif
