/* SPDX-License-Identifier: MIT */
/**
 * @file sequencer.c
 * A rhythm into a WAV file: sequencer FILE.wav [PRESET]
 *
 * Plays two bars in blocks, as an audio program does, each stroke at its own frame of its block. It
 * prints the strokes as the lines that `tabor render --events` reads, which gives the same samples.
 */
#include <stdio.h>
#include <stdlib.h>
#include <tabor/tabor.h>

#include "wav.h"

enum {
  RATE = 48000,
  STEP = 6000, /* frames between sixteenths, at 120 beats a minute */
  STEPS = 32,
  FRAMES = RATE / 2 + STEP * STEPS, /* and half a second to ring out */
  BLOCK = 64
};

/* A stroke for each sixteenth: loud, soft, or none. */
static const char rhythm[STEPS + 1] = "X..xx.x.X.x.xxxxX..xx.x.X.xxxxX.";
static const double loud = 4, soft = 1.25; /* m/s */

/* The strokes in order, counted from the start. */
static uint32_t strokes_of_rhythm(const TaborDrumDef *def, TaborEvent *strokes) {
  uint32_t count = 0;
  for (uint32_t step = 0; step < STEPS; step++) {
    if (rhythm[step] == '.') continue;
    strokes[count++] = (TaborEvent){
      .frame = step * STEP,
      .type = TABOR_EVENT_STRIKE,
      .striker = (uint32_t)tabor_drum_def_find_striker(def, def->strike.striker),
      .velocity = rhythm[step] == 'X' ? loud : soft,
      .radius = 0.25 * def->shell.radius,
      .angle = def->strike.angle,
    };
  }
  return count;
}

static void print_strokes(const TaborEvent *strokes, uint32_t count) {
  printf("time,velocity,radius\n");
  for (uint32_t i = 0; i < count; i++) {
    printf("%.17g,%.17g,%.17g\n", (double)strokes[i].frame / RATE, strokes[i].velocity,
           strokes[i].radius);
  }
}

/* Plays the strokes to the first microphone. The events of a block count their frames from its
 * start. */
static void play(TaborDrum *drum, TaborEvent *strokes, uint32_t count, float *sound) {
  uint32_t next = 0;
  for (uint32_t start = 0; start < FRAMES; start += BLOCK) {
    const uint32_t frames = FRAMES - start < BLOCK ? FRAMES - start : BLOCK;
    const uint32_t first = next;
    while (next < count && strokes[next].frame < start + frames) strokes[next++].frame -= start;
    float *outputs[TABOR_MAX_MICS] = {sound + start};
    tabor_drum_process(drum, strokes + first, next - first, outputs, frames);
  }
}

static TaborStatus build(const char *preset, TaborDrumDef *def, TaborModel **model,
                         TaborDrum **drum, TaborError *error) {
  TaborModelOptions options;
  tabor_model_options_default(&options);
  options.sample_rate = RATE;
  options.quality = TABOR_QUALITY_LIVE;
  TaborStatus status = tabor_drum_def_preset(def, preset, error);
  if (status == TABOR_OK) status = tabor_model_create(def, &options, model, error);
  if (status == TABOR_OK) status = tabor_drum_create(*model, drum, error);
  return status;
}

int main(int argc, char **argv) {
  static float sound[FRAMES];
  TaborEvent strokes[STEPS];
  TaborDrumDef def;
  TaborModel *model = NULL;
  TaborDrum *drum = NULL;
  TaborError error;
  if (argc < 2 || argc > 3) {
    (void)fprintf(stderr, "usage: sequencer FILE.wav [PRESET]\n");
    return 2;
  }
  int status = EXIT_SUCCESS;
  if (build(argc > 2 ? argv[2] : "snare-14x5.5", &def, &model, &drum, &error) != TABOR_OK) {
    (void)fprintf(stderr, "sequencer: %s\n", error.message);
    status = EXIT_FAILURE;
  } else {
    const uint32_t count = strokes_of_rhythm(&def, strokes);
    print_strokes(strokes, count);
    play(drum, strokes, count, sound);
    if (!wav_write(argv[1], RATE, sound, FRAMES)) {
      perror(argv[1]);
      status = EXIT_FAILURE;
    }
  }
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  return status;
}
