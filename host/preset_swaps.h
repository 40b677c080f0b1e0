/* SPDX-License-Identifier: MIT */
/**
 * @file preset_swaps.h
 * A drum that becomes another preset while it rings, where there is time to wait for the model.
 */
#ifndef TABOR_HOST_PRESET_SWAPS_H
#define TABOR_HOST_PRESET_SWAPS_H

#include <stddef.h>

#include "message.h"

/** A drum, the models that were built, and changes under way. All zero is empty. */
typedef struct PresetSwaps {
  TaborDrum *drum;
  const TaborModelOptions *options;
  TaborModel *first;   /**< that the drum began on */
  TaborModel *model;   /**< that it runs on now */
  TaborModel **models; /**< of each built-in preset, or NULL */
  TaborSwap **swaps;   /**< that the drum may still need */
  size_t count, capacity;
} PresetSwaps;

/** Builds the drum that @p def describes. Free with preset_swaps_free(), whatever the outcome. */
Outcome preset_swaps_begin(PresetSwaps *swaps, const TaborDrumDef *def,
                           const TaborModelOptions *options);
/** Changes it to built-in preset @p preset, before its next frame. */
Outcome preset_swaps_act(PresetSwaps *swaps, uint32_t preset);
/** Frees the drum, too. */
void preset_swaps_free(PresetSwaps *swaps);

#endif
