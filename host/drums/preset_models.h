/* SPDX-License-Identifier: MIT */
/**
 * @file preset_models.h
 * Models of the built-in presets. A preset's is built when it is first asked for.
 */
#ifndef TABOR_HOST_PRESET_MODELS_H
#define TABOR_HOST_PRESET_MODELS_H

#include "base/message.h"

/** Empty if all members but the options are zero. */
typedef struct PresetModels {
  const TaborModelOptions *options;
  TaborModel **models; /**< model of each built-in preset, or NULL */
} PresetModels;

/** Finds the model of built-in preset @p preset, which @p presets keeps. */
Outcome preset_models_find(PresetModels *presets, uint32_t preset, TaborModel **model);
void preset_models_free(PresetModels *presets);

#endif
