/* SPDX-License-Identifier: MIT */
/* Kits for tests of physics. */
#ifndef TABOR_TEST_KITS_H
#define TABOR_TEST_KITS_H

#include <tabor/kit.h>

#include "physics.h"

enum { RATE = 48000, LENGTH = 9600 };

static bool brief; /* under sanitizers: few modes, one trial, nothing that is physics alone */

static inline uint32_t quality(void) { return brief ? TABOR_QUALITY_DRAFT : TABOR_QUALITY_LIVE; }

static inline void set(TaborKitDef *def, const char *key, const char *value) {
  TaborError error = {0};
  if (tabor_kit_def_set(def, key, value, &error) != TABOR_OK) fail_msg("%s", error.message);
}

/* A kit of these presets, half a metre apart in a line. */
static inline TaborKitDef *kit_of(uint32_t count, const char *const *presets) {
  TaborKitDef *def = malloc(sizeof *def);
  tabor_kit_def_default(def);
  for (uint32_t i = 0; i < count; i++) {
    char key[32], place[32];
    snprintf(key, sizeof key, "drum.d%u.preset", i);
    set(def, key, presets[i]);
    snprintf(key, sizeof key, "drum.d%u.x", i);
    snprintf(place, sizeof place, "%g", 0.5 * i);
    set(def, key, place);
  }
  return def;
}

static inline TaborModel *placed_model(const TaborKitDef *def, uint32_t drum) {
  TaborDrumDef placed;
  TaborError error = {0};
  if (tabor_kit_def_place(def, drum, &placed, &error) != TABOR_OK) fail_msg("%s", error.message);
  return physics_model(&placed, RATE, quality());
}

static inline TaborKit *kit_with(const TaborKitDef *def, TaborModel *const *models) {
  TaborKit *kit;
  TaborError error = {0};
  if (tabor_kit_create(def, models, &kit, &error) != TABOR_OK) fail_msg("%s", error.message);
  return kit;
}

static inline void models_of(const TaborKitDef *def, TaborModel **models) {
  for (uint32_t i = 0; i < def->drum_count; i++) models[i] = placed_model(def, i);
}

static inline void release_models(const TaborKitDef *def, TaborModel **models) {
  for (uint32_t i = 0; i < def->drum_count; i++) tabor_model_release(models[i]);
}

static inline TaborKit *new_kit(const TaborKitDef *def) {
  TaborModel *models[TABOR_KIT_DRUMS];
  models_of(def, models);
  TaborKit *const kit = kit_with(def, models);
  release_models(def, models);
  return kit;
}

static inline TaborKitEvent stroke(const TaborKitDef *def, uint32_t drum, uint32_t frame,
                                   double velocity) {
  TaborKitEvent event = {.drum = drum, .event = physics_strike(&def->drum[drum].def)};
  event.event.frame = frame;
  event.event.velocity = velocity;
  return event;
}

static inline TaborKitEvent value_at(uint32_t frame, uint32_t parameter, double value) {
  return (TaborKitEvent){
    .drum = TABOR_KIT_MIX,
    .event = {
      .frame = frame, .type = TABOR_EVENT_PARAMETER, .parameter = parameter, .value = value}};
}

#endif
