/* SPDX-License-Identifier: MIT */
/**
 * @file stroke_times.c
 * Plays strokes on a preset with the baseline instructions, and prints a hash of the sound and what
 * it cost (tools/check-web). It uses only the public interface and the C library.
 *
 *     stroke_times PRESET QUALITY SECONDS [ROUNDS]
 *
 * The drum plays its default stroke twice a second. A line is "HASH RATIO": FNV-1a of the samples
 * of all microphones, and processor time over the time that the sound lasts, the least of ROUNDS (5
 * by default). The first round is often the dearest: a machine of WebAssembly is still compiling.
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "tabor/tabor.h"

enum { SAMPLE_RATE = 48000, BLOCK = 128, STROKE_EVERY = 24000, MOST_SECONDS = 60, ROUNDS = 5 };

static _Noreturn void fail(const char *message) {
  (void)fprintf(stderr, "stroke_times: %s\n", message);
  exit(1);
}

static uint32_t quality_named(const char *name) {
  static const char *const names[] = {"", "draft", "live", "studio", "reference"};
  for (uint32_t i = TABOR_QUALITY_DRAFT; i < sizeof names / sizeof *names; i++) {
    if (strcmp(name, names[i]) == 0) return i;
  }
  fail("unknown quality");
}

static TaborModel *build(const char *preset, const char *quality) {
  TaborDrumDef def;
  TaborModelOptions options;
  TaborModel *model = NULL;
  TaborError error;
  tabor_model_options_default(&options);
  options.sample_rate = SAMPLE_RATE;
  options.quality = quality_named(quality);
  options.instructions = TABOR_INSTRUCTIONS_BASELINE;
  if (tabor_drum_def_preset(&def, preset, &error) != TABOR_OK ||
      tabor_model_create(&def, &options, &model, &error) != TABOR_OK) {
    fail(error.message);
  }
  return model;
}

static uint64_t hash_of(uint64_t hash, const float *samples, uint32_t count) {
  const unsigned char *bytes = (const unsigned char *)samples;
  for (size_t i = 0; i < count * sizeof *samples; i++) {
    hash = (hash ^ bytes[i]) * UINT64_C(1099511628211);
  }
  return hash;
}

static TaborEvent stroke_of(const TaborDrumDef *def, uint32_t frame) {
  const int striker = tabor_drum_def_find_striker(def, def->strike.striker);
  return (TaborEvent){.frame = frame,
                      .type = TABOR_EVENT_STRIKE,
                      .striker = striker < 0 ? 0 : (uint32_t)striker,
                      .velocity = def->strike.velocity,
                      .radius = def->strike.radius,
                      .angle = def->strike.angle};
}

/* Plays `frames` frames, a whole number of blocks. */
static uint64_t play(TaborDrum *drum, const TaborDrumDef *def, uint32_t frames) {
  static float sound[TABOR_MAX_MICS][BLOCK];
  float *outputs[TABOR_MAX_MICS];
  uint64_t hash = UINT64_C(14695981039346656037);
  for (uint32_t mic = 0; mic < TABOR_MAX_MICS; mic++) outputs[mic] = sound[mic];
  for (uint32_t start = 0, next = 0; start < frames; start += BLOCK) {
    const bool strikes = next < start + BLOCK;
    const TaborEvent event = stroke_of(def, strikes ? next - start : 0);
    if (strikes) next += STROKE_EVERY;
    tabor_drum_process(drum, &event, strikes, outputs, BLOCK);
    for (uint32_t mic = 0; mic < def->mic_count; mic++) hash = hash_of(hash, sound[mic], BLOCK);
  }
  return hash;
}

static uint64_t round_of(TaborModel *model, uint32_t frames, double *seconds) {
  TaborDrum *drum = NULL;
  TaborError error;
  if (tabor_drum_create(model, &drum, &error) != TABOR_OK) fail(error.message);
  const clock_t start = clock();
  const uint64_t hash = play(drum, tabor_model_definition(model), frames);
  *seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
  tabor_drum_destroy(drum);
  return hash;
}

int main(int count, char **words) {
  const int seconds = count > 3 ? atoi(words[3]) : 0, rounds = count > 4 ? atoi(words[4]) : ROUNDS;
  if (count < 4 || count > 5 || seconds < 1 || seconds > MOST_SECONDS || rounds < 1) {
    fail("usage: stroke_times PRESET QUALITY SECONDS [ROUNDS]");
  }
  TaborModel *const model = build(words[1], words[2]);
  const uint32_t frames = (uint32_t)seconds * SAMPLE_RATE;
  double least, cost;
  const uint64_t hash = round_of(model, frames, &least);
  for (int i = 1; i < rounds; i++) {
    if (round_of(model, frames, &cost) != hash) fail("a second drum sounds otherwise");
    if (cost < least) least = cost;
  }
  printf("%016" PRIx64 " %.4f\n", hash, least / seconds);
  tabor_model_release(model);
  return 0;
}
