/* SPDX-License-Identifier: MIT */
#include "drums/preset_drums.h"

#include <stdlib.h>

#include "drums/drum_args.h"

/* The model of @p preset, built when it is first asked for. */
static Outcome find_model(PresetDrums *presets, uint32_t preset, TaborModel **model) {
  TaborDrumDef def;
  TaborError error;
  if (!presets->models) presets->models = calloc(tabor_preset_count(), sizeof *presets->models);
  if (!presets->models) return fail_memory();
  *model = presets->models[preset];
  if (*model) return OUTCOME_OK;
  if (tabor_drum_def_preset(&def, tabor_preset(preset)->name, &error) != TABOR_OK) {
    return report_engine_error(&error);
  }
  const Outcome outcome = model_create(&def, presets->options, &presets->models[preset]);
  *model = presets->models[preset];
  return outcome;
}

Outcome preset_drums_create(PresetDrums *presets, uint32_t preset, TaborDrum **drum) {
  TaborModel *model = NULL;
  TaborError error;
  *drum = NULL;
  const Outcome outcome = find_model(presets, preset, &model);
  if (outcome != OUTCOME_OK) return outcome;
  const TaborStatus status = tabor_drum_create(model, drum, &error);
  return status == TABOR_OK ? OUTCOME_OK : report_engine_error(&error);
}

void preset_drums_free(PresetDrums *presets) {
  for (uint32_t i = 0; presets->models && i < tabor_preset_count(); i++) {
    tabor_model_release(presets->models[i]);
  }
  free(presets->models);
  *presets = (PresetDrums){0};
}
