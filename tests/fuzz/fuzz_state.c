/* SPDX-License-Identifier: MIT */
/* Saved states with forged contents and a right checksum: refused, or harmless (drum/drum.c,
 * step/state_check.h). The input is a list of changes to a state in mid-play, 12 bytes each: place,
 * and 8 bytes that replace those there. */
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"

typedef struct Scene {
  TaborModel *model;
  TaborDrum *drum;
  unsigned char *good, *bytes;
  size_t size;
} Scene;

static TaborEvent stroke(uint32_t frame, uint32_t striker, uint32_t technique) {
  return (TaborEvent){.frame = frame,
                      .type = TABOR_EVENT_STRIKE,
                      .id = frame + 1,
                      .striker = striker,
                      .technique = technique,
                      .velocity = 3.0,
                      .radius = 0.04,
                      .angle = 50.0 * frame,
                      .value = 0.5};
}

static void set_up(Scene *scene) {
  scene->model = fuzz_model(0);
  const TaborDrumDef *const def = tabor_model_definition(scene->model);
  const uint32_t brush = (uint32_t)tabor_drum_def_find_striker(def, "brush");
  const TaborEvent events[] = {
    stroke(0, 0, TABOR_TECHNIQUE_NORMAL), stroke(1, 0, TABOR_TECHNIQUE_BUZZ),
    stroke(2, brush, TABOR_TECHNIQUE_SWEEP), stroke(90, 0, TABOR_TECHNIQUE_RIMSHOT)};
  fuzz_require(tabor_drum_create(scene->model, &scene->drum, NULL) == TABOR_OK, "a drum");
  tabor_drum_process(scene->drum, events, 4, NULL, 100);
  scene->size = tabor_drum_state_size(scene->drum);
  scene->good = malloc(scene->size);
  scene->bytes = malloc(scene->size);
  fuzz_require(scene->good && scene->bytes, "memory");
  tabor_drum_state_save(scene->drum, scene->good);
}

/* FNV-1a over words of 8 bytes. */
static void sign(Scene *scene) {
  uint64_t hash = 14695981039346656037u;
  for (size_t i = 0; i + 16 <= scene->size; i += 8) {
    uint64_t word;
    memcpy(&word, scene->bytes + i, 8);
    hash = (hash ^ word) * 1099511628211u;
  }
  memcpy(scene->bytes + scene->size - 8, &hash, 8);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static Scene scene;
  if (!scene.model) set_up(&scene);
  FuzzInput input = {data, size};
  memcpy(scene.bytes, scene.good, scene.size);
  while (input.left >= 12) {
    const size_t at = 8 + fuzz_word(&input) % (scene.size - 24);
    for (size_t i = 0; i < 8; i++) scene.bytes[at + i] = fuzz_byte(&input);
  }
  sign(&scene);
  if (tabor_drum_state_load(scene.drum, scene.bytes, scene.size) != TABOR_OK) return 0;
  TaborLedger ledger;
  TaborProbe probe;
  float sound[80], *outputs[TABOR_MAX_MICS] = {sound};
  const TaborEvent events[] = {stroke(3, 0, TABOR_TECHNIQUE_CROSS_STICK),
                               {.frame = 40, .type = TABOR_EVENT_RELEASE}};
  tabor_drum_process(scene.drum, events, 2, outputs, 80);
  tabor_drum_ledger(scene.drum, &ledger);
  tabor_drum_probe(scene.drum, &probe);
  return 0;
}
