/* SPDX-License-Identifier: MIT */
/* Builds a model, plays every kind of event on it, and prints hashes of the result. The hashes are
 * the same on every machine (tools/check-arm).
 *
 *   model_bits PRESET QUALITY     quality 1 (draft) to 4 (reference) */
#include <inttypes.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "drum_script.h"

static TaborModel *build(const char *preset, unsigned quality) {
  TaborDrumDef def;
  TaborError error;
  TaborModelOptions options;
  TaborModel *model = NULL;
  tabor_model_options_default(&options);
  options.quality = quality;
  if (tabor_drum_def_preset(&def, preset, &error) != TABOR_OK ||
      tabor_model_create(&def, &options, &model, &error) != TABOR_OK) {
    fprintf(stderr, "model_bits: %s\n", error.message);
    exit(1);
  }
  return model;
}

/* FNV-1a */
static uint64_t hash(const void *bytes, size_t size) {
  uint64_t value = 0xcbf29ce484222325u;
  for (size_t i = 0; i < size; i++) {
    value = (value ^ ((const unsigned char *)bytes)[i]) * 0x100000001b3u;
  }
  return value;
}

static void play(TaborModel *model) {
  Script script;
  script_everything(&script);
  Take take = take_create(model, SCRIPT_FRAMES);
  TaborDrum *const drum = script_drum(model);
  script_play_all(drum, &script, &take);

  const size_t state_size = tabor_drum_state_size(drum);
  void *const state = malloc(state_size);
  if (!state) exit(1);
  tabor_drum_state_save(drum, state);
  printf("%s: peak %.3g, samples %016" PRIx64 ", ledger %016" PRIx64 ", state %016" PRIx64 "\n",
         tabor_model_definition(model)->name, take_peak(&take),
         hash(take.samples, (size_t)take.mics * take.frames * sizeof *take.samples),
         hash(&take.ledger, sizeof take.ledger), hash(state, state_size));
  free(state);
  tabor_drum_destroy(drum);
  take_destroy(&take);
}

int main(int count, char **words) {
  if (count != 3) {
    fprintf(stderr, "usage: model_bits PRESET QUALITY\n");
    return 2;
  }
  TaborModel *const model = build(words[1], (unsigned)atoi(words[2]));
  play(model);
  tabor_model_release(model);
  return 0;
}
