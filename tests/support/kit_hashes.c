/* SPDX-License-Identifier: MIT */
/* Uses only what the first public interface of kits had, so that it can be linked to the library of
 * another commit. */
#include "kit_hashes.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "hashes.h"
#include "tabor/kit.h"

static const double SAMPLE_RATE = 48000.0, SECONDS = 0.05;
enum {
  MOST_STROKES = 2 * TABOR_KIT_DRUMS,
  MOST_CHANNELS = 2 + TABOR_KIT_DRUMS * (2 + TABOR_MAX_MICS)
};

typedef struct Kit {
  TaborKitDef def;
  TaborKit *kit;
  uint32_t frames;
  float *sound; /* [MOST_CHANNELS][frames] */
  TaborKitEvent events[MOST_STROKES];
  uint32_t count;
} Kit;

static _Noreturn void fail(const char *what, const char *why) {
  (void)fprintf(stderr, "sound_hashes: %s: %s\n", what, why);
  exit(2);
}

void kit_hashes_list(void) {
  for (uint32_t i = 0; i < tabor_kit_count(); i++) printf("%s\n", tabor_kit(i)->name);
}

bool kit_hashes_is_kit(const char *name) {
  uint32_t i = 0;
  while (i < tabor_kit_count() && strcmp(tabor_kit(i)->name, name) != 0) i++;
  return i < tabor_kit_count();
}

/* Each drum is struck twice, all within the first half, at odd frames and speeds. */
static void write_events(Kit *kit) {
  kit->count = 2 * kit->def.drum_count;
  for (uint32_t i = 0; i < kit->count; i++) {
    const uint32_t drum = i % kit->def.drum_count;
    const TaborDrumDef *const def = &kit->def.drum[drum].def;
    kit->events[i] =
      (TaborKitEvent){.drum = drum,
                      .event = {.frame = i * kit->frames / (2 * kit->count) + i % 3,
                                .type = TABOR_EVENT_STRIKE,
                                .velocity = 0.7 * def->strike.velocity + 0.3 * (double)i,
                                .radius = def->strike.radius,
                                .angle = def->strike.angle}};
  }
}

static void create(Kit *kit, TaborModel **models, TaborQuality quality) {
  TaborModelOptions options;
  TaborError error;
  tabor_model_options_default(&options);
  options.sample_rate = SAMPLE_RATE;
  options.quality = quality;
  for (uint32_t i = 0; i < kit->def.drum_count; i++) {
    TaborDrumDef placed;
    if (tabor_kit_def_place(&kit->def, i, &placed, &error) != TABOR_OK ||
        tabor_model_create(&placed, &options, &models[i], &error) != TABOR_OK) {
      fail(kit->def.drum[i].name, error.message);
    }
  }
}

static float *channel(const Kit *kit, uint32_t number, uint32_t at) {
  return kit->sound + (size_t)number * kit->frames + at;
}

static TaborKitOutputs outputs_at(const Kit *kit, uint32_t at) {
  TaborKitOutputs outputs = {.stereo = {channel(kit, 0, at), channel(kit, 1, at)}};
  uint32_t next = 2;
  for (uint32_t i = 0; i < kit->def.drum_count; i++) {
    for (int side = 0; side < 2; side++) outputs.drum[i][side] = channel(kit, next++, at);
    for (uint32_t mic = 0; mic < TABOR_MAX_MICS; mic++) {
      outputs.mic[i][mic] = channel(kit, next++, at);
    }
  }
  return outputs;
}

static void play(Kit *kit, uint32_t block) {
  uint32_t next = 0;
  for (uint32_t at = 0; at < kit->frames; at += block) {
    const uint32_t left = kit->frames - at, frames = block < left ? block : left;
    const TaborKitOutputs outputs = outputs_at(kit, at);
    TaborKitEvent due[MOST_STROKES];
    uint32_t count = 0;
    for (; next < kit->count && kit->events[next].event.frame < at + frames; next++) {
      due[count] = kit->events[next];
      due[count++].event.frame -= at;
    }
    tabor_kit_process(kit->kit, due, count, &outputs, frames);
  }
}

static Hash hash_state(const TaborKit *kit) {
  const size_t size = tabor_kit_state_size(kit);
  void *const bytes = malloc(size);
  if (!bytes) fail("a state", "not enough memory");
  tabor_kit_state_save(kit, bytes);
  const Hash hash = hash_bytes(HASH_START, bytes, size);
  free(bytes);
  return hash;
}

static Hash hash_drums(const TaborKit *kit) {
  Hash hash = HASH_START;
  const TaborDrum *drum;
  for (uint32_t i = 0; (drum = tabor_kit_drum(kit, i)) != NULL; i++) {
    hash = hash_statistics(hash_ledger(hash, drum), drum);
  }
  return hash;
}

static void print_line(const Kit *kit, const char *quality, uint32_t block) {
  const size_t bytes = sizeof(float) * MOST_CHANNELS * kit->frames;
  printf("%s %s kit %u %016" PRIx64 " %016" PRIx64 " %016" PRIx64 "\n", kit->def.name, quality,
         (unsigned)block, hash_bytes(HASH_START, kit->sound, bytes), hash_drums(kit->kit),
         hash_state(kit->kit));
}

static void write_mix(const Kit *kit, const char *quality, const char *folder) {
  char path[4096];
  (void)snprintf(path, sizeof path, "%s/%s-%s-kit", folder, kit->def.name, quality);
  FILE *const file = fopen(path, "wb");
  const size_t count = 2 * (size_t)kit->frames;
  if (!file || fwrite(kit->sound, sizeof(float), count, file) != count || fclose(file) != 0) {
    fail(path, "cannot be written");
  }
}

/* Studio plays a quarter, and reference, whose snare drums take hundreds of times real time, a
 * twentieth. */
static uint32_t frames_of(TaborQuality quality, double seconds) {
  const uint32_t frames = (uint32_t)((seconds > 0 ? seconds : SECONDS) * SAMPLE_RATE);
  if (seconds > 0 || quality < TABOR_QUALITY_STUDIO) return frames;
  return quality == TABOR_QUALITY_STUDIO ? frames / 4 : frames / 20;
}

void kit_hashes_print(const char *name, const char *quality_name, TaborQuality quality,
                      double seconds, const char *folder) {
  static const uint32_t blocks[] = {64, 1, 1000};
  TaborModel *models[TABOR_KIT_DRUMS] = {NULL};
  TaborError error;
  Kit *const kit = calloc(1, sizeof *kit);
  if (!kit) fail(name, "not enough memory");
  if (tabor_kit_def_preset(&kit->def, name, &error) != TABOR_OK) fail(name, error.message);
  kit->frames = frames_of(quality, seconds);
  kit->sound = calloc((size_t)MOST_CHANNELS * kit->frames, sizeof *kit->sound);
  if (!kit->sound) fail(name, "not enough memory");
  write_events(kit);
  create(kit, models, quality);
  if (tabor_kit_create(&kit->def, models, &kit->kit, &error) != TABOR_OK) {
    fail(name, error.message);
  }
  for (uint32_t i = 0; i < 3; i++) {
    tabor_kit_reset(kit->kit);
    play(kit, blocks[i]);
    print_line(kit, quality_name, blocks[i]);
    if (folder && i == 0) write_mix(kit, quality_name, folder);
  }
  tabor_kit_destroy(kit->kit);
  for (uint32_t i = 0; i < kit->def.drum_count; i++) tabor_model_release(models[i]);
  free(kit->sound);
  free(kit);
}
