/* SPDX-License-Identifier: MIT */
#include "preset_swaps.h"

#include <stdlib.h>

#include "drum_source.h"

Outcome preset_swaps_begin(PresetSwaps *swaps, const TaborDrumDef *def,
                           const TaborModelOptions *options) {
  TaborError error;
  *swaps = (PresetSwaps){.options = options};
  const Outcome outcome = model_create(def, options, &swaps->first);
  if (outcome != OUTCOME_OK) return outcome;
  swaps->model = swaps->first;
  const TaborStatus status = tabor_drum_create(swaps->model, &swaps->drum, &error);
  return status == TABOR_OK ? OUTCOME_OK : report_engine_error(&error);
}

/* The model of @p preset, built when it is first asked for. */
static Outcome find_model(PresetSwaps *swaps, uint32_t preset, TaborModel **model) {
  TaborDrumDef def;
  TaborError error;
  if (!swaps->models) swaps->models = calloc(tabor_preset_count(), sizeof *swaps->models);
  if (!swaps->models) return fail_memory();
  *model = swaps->models[preset];
  if (*model) return OUTCOME_OK;
  if (tabor_drum_def_preset(&def, tabor_preset(preset)->name, &error) != TABOR_OK) {
    return report_engine_error(&error);
  }
  const Outcome outcome = model_create(&def, swaps->options, &swaps->models[preset]);
  *model = swaps->models[preset];
  return outcome;
}

/* Those that the drum is done with make room. */
static void discard_done(PresetSwaps *swaps) {
  size_t kept = 0;
  for (size_t i = 0; i < swaps->count; i++) {
    TaborSwap *const swap = swaps->swaps[i];
    if (tabor_swap_done(swap)) {
      tabor_swap_destroy(swap);
    } else {
      swaps->swaps[kept++] = swap;
    }
  }
  swaps->count = kept;
}

static Outcome make_room(PresetSwaps *swaps) {
  discard_done(swaps);
  if (swaps->count < swaps->capacity) return OUTCOME_OK;
  const size_t capacity = swaps->capacity + 8;
  TaborSwap **const grown = realloc(swaps->swaps, capacity * sizeof *grown);
  if (!grown) return fail_memory();
  swaps->swaps = grown;
  swaps->capacity = capacity;
  return OUTCOME_OK;
}

static Outcome swap(PresetSwaps *swaps, TaborModel *model) {
  TaborError error;
  TaborSwap *created = NULL;
  if (tabor_swap_create(swaps->model, model, &created, &error) != TABOR_OK) {
    return report_engine_error(&error);
  }
  const TaborEvent event = {.type = TABOR_EVENT_SWAP, .swap = created};
  tabor_drum_process(swaps->drum, &event, 1, NULL, 0);
  swaps->swaps[swaps->count++] = created;
  swaps->model = model;
  return OUTCOME_OK;
}

Outcome preset_swaps_act(PresetSwaps *swaps, uint32_t preset) {
  TaborModel *model = NULL;
  Outcome outcome = find_model(swaps, preset, &model);
  if (outcome == OUTCOME_OK) outcome = make_room(swaps);
  return outcome == OUTCOME_OK ? swap(swaps, model) : outcome;
}

void preset_swaps_free(PresetSwaps *swaps) {
  tabor_drum_destroy(swaps->drum);
  for (size_t i = 0; i < swaps->count; i++) tabor_swap_destroy(swaps->swaps[i]);
  for (uint32_t i = 0; swaps->models && i < tabor_preset_count(); i++) {
    tabor_model_release(swaps->models[i]);
  }
  tabor_model_release(swaps->first);
  free(swaps->swaps);
  free(swaps->models);
  *swaps = (PresetSwaps){0};
}
