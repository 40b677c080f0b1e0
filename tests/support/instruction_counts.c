/* SPDX-License-Identifier: MIT */
/* instruction_counts PRESET: plays half a second of the preset's own stroke at `live`, with the
 * kernels for AVX2, and has callgrind count nothing but that. */
#include <stdio.h>
#include <valgrind/callgrind.h>

#include "tabor/tabor.h"

enum { FRAMES = 24000 };

static TaborModel *model_of(const char *preset, TaborError *error) {
  TaborDrumDef def;
  TaborModelOptions options;
  TaborModel *model = NULL;
  tabor_model_options_default(&options);
  options.quality = TABOR_QUALITY_LIVE;
  options.instructions = TABOR_INSTRUCTIONS_AVX2;
  if (tabor_drum_def_preset(&def, preset, error) != TABOR_OK) return NULL;
  return tabor_model_create(&def, &options, &model, error) == TABOR_OK ? model : NULL;
}

static TaborEvent stroke_of(const TaborModel *model) {
  const TaborDrumDef *def = tabor_model_definition(model);
  const int striker = tabor_drum_def_find_striker(def, def->strike.striker);
  return (TaborEvent){.type = TABOR_EVENT_STRIKE,
                      .striker = striker > 0 ? (uint32_t)striker : 0,
                      .velocity = def->strike.velocity,
                      .radius = def->strike.radius,
                      .angle = def->strike.angle};
}

int main(int argc, char **argv) {
  static float sound[FRAMES];
  float *outputs[TABOR_MAX_MICS] = {sound};
  TaborError error = {0};
  TaborModel *model = argc == 2 ? model_of(argv[1], &error) : NULL;
  TaborDrum *drum = NULL;
  if (!model || tabor_drum_create(model, &drum, &error) != TABOR_OK) {
    fprintf(stderr, "instruction_counts: %s\n", argc == 2 ? error.message : "which preset?");
    return 1;
  }
  const TaborEvent stroke = stroke_of(model);
  CALLGRIND_START_INSTRUMENTATION;
  CALLGRIND_ZERO_STATS;
  tabor_drum_process(drum, &stroke, 1, outputs, FRAMES);
  CALLGRIND_DUMP_STATS;
  CALLGRIND_STOP_INSTRUMENTATION;
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  return 0;
}
