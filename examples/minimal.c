/* SPDX-License-Identifier: MIT */
/**
 * @file minimal.c
 * A stroke into a buffer: half a second of the built-in drum "tabor", and how loud it became.
 */
#include <math.h>
#include <stdio.h>
#include <tabor/tabor.h>

enum { FRAMES = 24000 }; /* half a second at 48 kHz, which is the default */

static float sound[FRAMES];

int main(void) {
  TaborDrumDef def;
  TaborModelOptions options;
  TaborModel *model = NULL;
  TaborDrum *drum = NULL;
  TaborError error;
  tabor_model_options_default(&options);
  options.quality = TABOR_QUALITY_LIVE;
  if (tabor_drum_def_preset(&def, "tabor", &error) != TABOR_OK ||
      tabor_model_create(&def, &options, &model, &error) != TABOR_OK ||
      tabor_drum_create(model, &drum, &error) != TABOR_OK) {
    (void)fprintf(stderr, "minimal: %s\n", error.message);
    tabor_model_release(model);
    return 1;
  }

  const TaborEvent strike = {.type = TABOR_EVENT_STRIKE, .velocity = 2.5, .radius = 0.05};
  float *outputs[TABOR_MAX_MICS] = {sound}; /* the first microphone; the others are not computed */
  tabor_drum_process(drum, &strike, 1, outputs, FRAMES);

  float peak = 0;
  for (int i = 0; i < FRAMES; i++) peak = fmaxf(peak, fabsf(sound[i]));
  printf("half a second of '%s', peak %.1f dBFS\n", def.comment, 20 * log10((double)peak));
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  return 0;
}
