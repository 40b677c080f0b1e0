/* SPDX-License-Identifier: MIT */
/**
 * @file preset_drums.h
 * Creates drums of the built-in presets. The first drum of a preset waits while its model is built.
 */
#ifndef TABOR_HOST_PRESET_DRUMS_H
#define TABOR_HOST_PRESET_DRUMS_H

#include "base/message.h"

/** Empty if all members but the options are zero. */
typedef struct PresetDrums {
  const TaborModelOptions *options;
  TaborModel **models; /**< model of each built-in preset, or NULL */
} PresetDrums;

/** Creates a drum at rest of built-in preset @p preset. On an error *drum is NULL. */
Outcome preset_drums_create(PresetDrums *presets, uint32_t preset, TaborDrum **drum);
/** Frees the models; drums stay valid. */
void preset_drums_free(PresetDrums *presets);

#endif
