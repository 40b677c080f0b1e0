/* SPDX-License-Identifier: MIT */
/**
 * @file kit_automation.c
 * Benchmark of kits that take over from each other: all five drums of the kit `standard` are tuned
 * up and down by a semitone, and the room changes, every 10 ms, while all drums ring at `live`.
 * Prints the processor time of the median block of 10 ms and of the worst one, each the least of
 * nine equal runs, beside a kit that stays. The kits are built before.
 *
 *     kit_automation
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "processor_time.h"
#include "tabor/kit.h"

enum { RUNS = 9, BLOCKS = 100, FRAMES = 480 };

static _Noreturn void fail(const char *why) {
  (void)fprintf(stderr, "kit_automation: %s\n", why);
  exit(1);
}

static void require(TaborStatus status, const TaborError *error) {
  if (status != TABOR_OK) fail(error->message);
}

/* A kit and its models. */
typedef struct Tuning {
  TaborKitDef def;
  TaborModel *models[TABOR_KIT_DRUMS];
} Tuning;

static void tune(Tuning *tuning, double semitones, const char *room) {
  const double ratio = exp2(semitones / 12);
  TaborModelOptions options;
  TaborError error;
  require(tabor_kit_def_preset(&tuning->def, "standard", &error), &error);
  require(tabor_kit_def_set(&tuning->def, "room.kind", room, &error), &error);
  tabor_model_options_default(&options);
  options.quality = TABOR_QUALITY_LIVE;
  for (uint32_t i = 0; i < tuning->def.drum_count; i++) {
    TaborDrumDef *const drum = &tuning->def.drum[i].def, placed;
    drum->batter.tension *= ratio * ratio;
    drum->resonant.tension *= ratio * ratio;
    require(tabor_kit_def_place(&tuning->def, i, &placed, &error), &error);
    require(tabor_model_create(&placed, &options, &tuning->models[i], &error), &error);
  }
}

static TaborKit *create(const Tuning *tuning) {
  TaborKit *kit;
  TaborError error;
  require(tabor_kit_create(&tuning->def, tuning->models, &kit, &error), &error);
  return kit;
}

static void strike_all(TaborKit *kit, const TaborKitOutputs *outputs) {
  const TaborKitDef *const def = tabor_kit_definition(kit);
  TaborKitEvent events[TABOR_KIT_DRUMS];
  for (uint32_t i = 0; i < def->drum_count; i++) {
    const TaborStrikeDef *const usual = &def->drum[i].def.strike;
    events[i] = (TaborKitEvent){.drum = i,
                                .event = {.type = TABOR_EVENT_STRIKE,
                                          .velocity = usual->velocity,
                                          .radius = usual->radius,
                                          .angle = usual->angle}};
  }
  tabor_kit_process(kit, events, def->drum_count, outputs, FRAMES);
}

/* One block; returns the kit that has played it. */
static TaborKit *play_block(TaborKit *kit, TaborKit *next, const TaborKitOutputs *outputs) {
  if (next) tabor_kit_take_over(next, kit);
  if (next) kit = next;
  tabor_kit_process(kit, NULL, 0, outputs, FRAMES);
  return kit;
}

static void run(const Tuning tunings[2], bool changes, double least[BLOCKS]) {
  static float sides[2][FRAMES];
  const TaborKitOutputs outputs = {.stereo = {sides[0], sides[1]}};
  uint8_t drums[TABOR_KIT_DRUMS];
  TaborKit *kits[BLOCKS + 1] = {create(&tunings[0])}, *kit = kits[0];
  for (uint8_t i = 0; i < TABOR_KIT_DRUMS; i++) drums[i] = i;
  strike_all(kit, &outputs);
  for (int i = 0; i < BLOCKS; i++) {
    TaborKit *const next = changes ? create(&tunings[(i + 1) % 2]) : NULL;
    TaborError error;
    if (next) require(tabor_kit_follow(next, kit, drums, &error), &error);
    const double start = processor_time();
    kit = play_block(kit, next, &outputs);
    least[i] = fmin(least[i], processor_time() - start);
    kits[i + 1] = next;
  }
  for (int i = 0; i <= BLOCKS; i++) tabor_kit_destroy(kits[i]);
}

static int compare(const void *a, const void *b) {
  const double first = *(const double *)a, second = *(const double *)b;
  return (first > second) - (first < second);
}

static void report(const char *what, const Tuning tunings[2], bool changes) {
  double least[BLOCKS];
  for (int i = 0; i < BLOCKS; i++) least[i] = INFINITY;
  for (int i = 0; i < RUNS; i++) run(tunings, changes, least);
  qsort(least, BLOCKS, sizeof *least, compare);
  const double median = least[BLOCKS / 2], worst = least[BLOCKS - 1];
  printf("%s: median %.2f ms, worst %.2f ms, %.2f times the median\n", what, 1e3 * median,
         1e3 * worst, worst / median);
}

int main(void) {
  static Tuning tunings[2];
  tune(&tunings[0], 0, "studio");
  tune(&tunings[1], 1, "hall");
  report("the kit stays", tunings, false);
  report("another tuning and room each block", tunings, true);
  for (int k = 0; k < 2; k++) {
    for (uint32_t i = 0; i < tunings[k].def.drum_count; i++) {
      tabor_model_release(tunings[k].models[i]);
    }
  }
  return 0;
}
