/* SPDX-License-Identifier: MIT */
/**
 * @file worst_blocks.c
 * Benchmark of the dearest block, on which live play depends: the kit `standard` plays a MIDI file,
 * and `snare-14x5.5` a loud roll of 20 strokes a second, both at `live` and on one thread, in
 * blocks of 64 frames. Each block counts with the least processor time of nine equal runs. Prints
 * the median block and the worst.
 *
 *     worst_blocks SONG.MID
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "kit/kit_midi.h"
#include "live_kit.h"
#include "midi/midi_file_input.h"
#include "platform/clock.h"

enum { RUNS = 9, BLOCK = 64, RATE = 48000, MOST_EVENTS = 256 };

static double *least; /* [blocks] s */
static uint32_t blocks;

static _Noreturn void quit(const char *why) {
  (void)fprintf(stderr, "worst_blocks: %s\n", why);
  exit(1);
}

static void require(TaborStatus status, const TaborError *error) {
  if (status != TABOR_OK) quit(error->message);
}

static void begin(double seconds) {
  blocks = (uint32_t)(seconds * RATE / BLOCK);
  least = realloc(least, blocks * sizeof *least);
  if (!least) quit("no memory");
  for (uint32_t i = 0; i < blocks; i++) least[i] = INFINITY;
}

static void count(uint32_t block, double seconds) { least[block] = fmin(least[block], seconds); }

static int order(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return x < y ? -1 : x > y;
}

static void print(const char *name) {
  uint32_t at = 0;
  for (uint32_t i = 0; i < blocks; i++) at = least[i] > least[at] ? i : at;
  const double when = (double)at * BLOCK / RATE;
  qsort(least, blocks, sizeof *least, order);
  const double median = least[blocks / 2], worst = least[blocks - 1];
  (void)printf(
    "%s: median %.3f ms, worst %.3f ms at %.3f s, %.2f of the median; a block lasts %.3f ms\n",
    name, 1e3 * median, 1e3 * worst, when, worst / median, 1e3 * BLOCK / RATE);
}

/* ---- the kit -------------------------------------------------------------------------------- */

static void play_kit(TaborKit *kit, const TaborKitDef *def, const MidiFile *file) {
  static KitMidi midi;
  float sound[2][BLOCK];
  size_t next = 0;
  tabor_kit_reset(kit);
  kit_midi_begin(&midi, def, &kit_midi_setup_default);
  for (uint32_t block = 0; block < blocks; block++) {
    static TaborKitEvent events[MOST_EVENTS + KIT_MIDI_MOST_EVENTS];
    uint32_t number = 0;
    const double end = (double)(block + 1) * BLOCK / RATE;
    for (; next < file->count && file->events[next].time < end && number < MOST_EVENTS; next++)
      number += kit_midi_take(&midi, &file->events[next].message, events + number);
    const TaborKitOutputs outputs = {.stereo = {sound[0], sound[1]}};
    const double begun = processor_seconds();
    tabor_kit_process(kit, events, number, &outputs, BLOCK);
    count(block, processor_seconds() - begun);
  }
}

static void measure_kit(const char *path) {
  static TaborKitDef def;
  MidiFile file;
  if (midi_file_read(path, false, &file) != OUTCOME_OK) exit(1);
  TaborKit *const kit = live_kit_create(&def);
  begin(file.length);
  for (int run = 0; run < RUNS; run++) play_kit(kit, &def, &file);
  print("kit");
  tabor_kit_destroy(kit);
  midi_file_free(&file);
}

/* ---- the roll ------------------------------------------------------------------------------- */

static void play_roll(TaborDrum *drum, const TaborDrumDef *def) {
  const uint32_t each = RATE / BLOCK / 20;
  TaborEvent stroke = {.type = TABOR_EVENT_STRIKE,
                       .velocity = 8,
                       .radius = def->strike.radius,
                       .angle = def->strike.angle};
  float sound[BLOCK], *outputs[TABOR_MAX_MICS] = {sound};
  tabor_drum_reset(drum);
  for (uint32_t block = 0; block < blocks; block++) {
    const double begun = processor_seconds();
    tabor_drum_process(drum, &stroke, block % each == 0, outputs, BLOCK);
    count(block, processor_seconds() - begun);
  }
}

static void measure_roll(void) {
  TaborDrumDef def;
  TaborModelOptions options;
  TaborModel *model;
  TaborDrum *drum;
  TaborError error;
  require(tabor_drum_def_preset(&def, "snare-14x5.5", &error), &error);
  tabor_model_options_default(&options);
  options.quality = TABOR_QUALITY_LIVE;
  require(tabor_model_create(&def, &options, &model, &error), &error);
  require(tabor_drum_create(model, &drum, &error), &error);
  begin(2);
  for (int run = 0; run < RUNS; run++) play_roll(drum, &def);
  print("roll");
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

int main(int argc, char **argv) {
  if (argc != 2) quit("usage: worst_blocks SONG.MID");
  measure_kit(argv[1]);
  measure_roll();
  free(least);
  return 0;
}
