/* SPDX-License-Identifier: MIT */
#include "library/library_plan.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "drums/drum_args.h"
#include "strokes/stroke.h"

#define MIDDLE_VELOCITY 64  /* of a library with one */
#define OUTERMOST_SHARE 80u /* per cent of the head's radius */

/* Of a drum with one place, the note that means the head in every drum map. */
static const uint32_t single_key = 38;
static const uint32_t keys[LIBRARY_MOST_POSITIONS] = {36, 38, 41, 43, 45, 47, 48, 50};

/* As many keys from the head's that no two techniques share one. */
const LibraryTechnique library_techniques[LIBRARY_TECHNIQUES] = {
  {"normal", TABOR_TECHNIQUE_NORMAL, 0, true},
  {"rimshot", TABOR_TECHNIQUE_RIMSHOT, 48, true},
  {"cross-stick", TABOR_TECHNIQUE_CROSS_STICK, 72, true},
  {"rim", TABOR_TECHNIQUE_RIM, -24, false},
  {"buzz", TABOR_TECHNIQUE_BUZZ, 24, true},
};

/* ---- velocities ---- */

static uint32_t layer_velocity(uint32_t layer, uint32_t layers) {
  if (layers == 1) return MIDDLE_VELOCITY;
  return 1 + (uint32_t)lround(126.0 * layer / (layers - 1));
}

/* A velocity between two layers belongs to the nearer one. */
void library_set_layer(LibrarySound *sound, uint32_t layer, uint32_t layers) {
  sound->midi = layer_velocity(layer, layers);
  sound->low = layer == 0 ? 1 : (layer_velocity(layer - 1, layers) + sound->midi) / 2 + 1;
  sound->high = layer + 1 == layers ? 127 : (sound->midi + layer_velocity(layer + 1, layers)) / 2;
}

/* ---- places ---- */

static void set_place(LibrarySound *sound, const TaborDrumDef *def, int up, uint32_t place,
                      uint32_t places) {
  const double head = def->shell.radius;
  const uint32_t key = places == 1 ? single_key : keys[place];
  sound->keys[0] = (uint8_t)((int)key + up);
  sound->key_count = 1;
  if (places == 1) {
    sound->radius_share = (uint32_t)lround(100 * sound->event.radius / head);
    return;
  }
  sound->radius_share = (uint32_t)lround((double)(OUTERMOST_SHARE * place) / (places - 1));
  sound->event.radius = head * sound->radius_share / 100; /* as --strike radius=40% has it */
}

/* ---- names ---- */

/* Samplers take '$', '=', '<' and blanks in a name for something else. */
char *library_stem(const char *preset) {
  const PresetStem stem = preset_stem(preset);
  char *const text = calloc((size_t)stem.length + 1, 1);
  for (int i = 0; text && i < stem.length; i++) {
    const unsigned char c = (unsigned char)stem.text[i];
    text[i] = (char)(isalnum(c) || c >= 0x80 || strchr(".-_", c) ? c : '_');
  }
  return text;
}

static bool set_name(LibrarySound *sound, const char *stem, uint32_t takes) {
  const size_t size = strlen(stem) + 64;
  sound->file = malloc(size);
  if (!sound->file) return false;
  (void)snprintf(sound->file, size, "%s-%s-r%02u-v%03u-t%0*u.wav", stem, sound->technique,
                 (unsigned)sound->radius_share, (unsigned)sound->midi, takes > 9 ? 2 : 1,
                 (unsigned)sound->take);
  return true;
}

/* ---- all of them ---- */

static uint32_t places_of(const LibraryShape *shape, const LibraryTechnique *technique) {
  return technique->places ? shape->positions : 1;
}

/* Sound @p index of one technique. */
static LibrarySound make_sound(const TaborDrumDef *def, const LibraryShape *shape,
                               const LibraryTechnique *technique, uint32_t index) {
  const uint32_t layer = index / shape->takes;
  LibrarySound sound = {.take = index % shape->takes + 1,
                        .technique = technique->name,
                        .event = stroke_default(def, "[strike]").event};
  sound.event.technique = (uint32_t)technique->technique;
  set_place(&sound, def, technique->up, layer / shape->velocities, places_of(shape, technique));
  library_set_layer(&sound, layer % shape->velocities, shape->velocities);
  sound.event.velocity = midi_speed(shape->response, sound.midi);
  return sound;
}

static uint32_t count_of_technique(const LibraryShape *shape, const LibraryTechnique *technique) {
  return places_of(shape, technique) * shape->velocities * shape->takes;
}

uint32_t library_count(const LibraryShape *shape) {
  uint32_t count = 0;
  for (size_t i = 0; i < LIBRARY_TECHNIQUES; i++) {
    if (shape->techniques[i]) count += count_of_technique(shape, &library_techniques[i]);
  }
  return count;
}

/* False without memory. */
static bool add_technique(const TaborDrumDef *def, const char *stem,
                          const LibraryTechnique *technique, Humanizer *player, LibraryPlan *plan) {
  const LibraryShape *const shape = &plan->shape;
  for (uint32_t i = 0; i < count_of_technique(shape, technique); i++) {
    LibrarySound *const sound = &plan->sounds[plan->count++];
    *sound = make_sound(def, shape, technique, i);
    humanize(player, def->shell.radius, &sound->event);
    if (!set_name(sound, stem, shape->takes)) return false;
  }
  return true;
}

Outcome library_plan_make(const TaborDrumDef *def, const char *preset, const LibraryShape *shape,
                          LibraryPlan *plan) {
  Humanizer player = shape->humanizer;
  char *const stem = library_stem(preset);
  *plan =
    (LibraryPlan){.shape = *shape, .sounds = calloc(library_count(shape), sizeof *plan->sounds)};
  bool complete = stem && plan->sounds;
  for (size_t i = 0; i < LIBRARY_TECHNIQUES && complete; i++) {
    if (!shape->techniques[i]) continue;
    complete = add_technique(def, stem, &library_techniques[i], &player, plan);
  }
  free(stem);
  return complete ? OUTCOME_OK : fail_memory();
}

void library_plan_free(LibraryPlan *plan) {
  for (size_t i = 0; i < plan->count; i++) free(plan->sounds[i].file);
  free(plan->sounds);
  *plan = (LibraryPlan){0};
}
