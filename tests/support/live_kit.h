/* SPDX-License-Identifier: MIT */
/* The kit `standard` at `live`, for benchmarks. A program that cannot build it says why and ends.
 */
#ifndef TABOR_TESTS_LIVE_KIT_H
#define TABOR_TESTS_LIVE_KIT_H

#include <stdio.h>
#include <stdlib.h>

#include "kit/kit_build.h"

static inline TaborKit *live_kit_create(TaborKitDef *def) {
  TaborModel *models[TABOR_KIT_DRUMS] = {NULL};
  TaborModelOptions options;
  TaborKit *kit = NULL;
  TaborError error;
  tabor_model_options_default(&options);
  options.quality = TABOR_QUALITY_LIVE;
  if (tabor_kit_def_preset(def, "standard", &error) != TABOR_OK ||
      kit_models_build(def, &options, 1, models) != OUTCOME_OK ||
      tabor_kit_create(def, models, &kit, &error) != TABOR_OK) {
    (void)fprintf(stderr, "the kit cannot be built\n");
    exit(1);
  }
  kit_models_release(models);
  return kit;
}

#endif
