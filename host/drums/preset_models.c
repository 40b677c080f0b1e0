/* SPDX-License-Identifier: MIT */
#include "drums/preset_models.h"

#include <stdlib.h>

#include "drums/drum_args.h"
#include "drums/model_build.h"

Outcome preset_models_find(PresetModels *presets, uint32_t preset, TaborModel **model) {
  TaborDrumDef def;
  TaborError error;
  if (!presets->models) presets->models = calloc(tabor_preset_count(), sizeof *presets->models);
  if (!presets->models) return fail_memory();
  *model = presets->models[preset];
  if (*model) return OUTCOME_OK;
  if (tabor_drum_def_preset(&def, tabor_preset(preset)->name, &error) != TABOR_OK) {
    return report_engine_error(&error);
  }
  const Outcome outcome = model_build(&def, presets->options, &presets->models[preset]);
  *model = presets->models[preset];
  return outcome;
}

void preset_models_free(PresetModels *presets) {
  for (uint32_t i = 0; presets->models && i < tabor_preset_count(); i++) {
    tabor_model_release(presets->models[i]);
  }
  free(presets->models);
  *presets = (PresetModels){0};
}
