/* SPDX-License-Identifier: MIT */
/**
 * @file host_synthesise.c
 * Writes sounds with known partials as float WAV, for tests of the analysis:
 *
 *     host_synthesise FILE RATE CHANNELS SECONDS ONSET NOISE [HZ,DBFS,DECAY]...
 *
 * The last channel holds white noise of NOISE dBFS (root mean square; below -200: none) and, from
 * ONSET seconds on, sines of these frequencies and initial amplitudes that decay as exp(-DECAY t);
 * the others are silent.
 */
#include <math.h>
#include <sndfile.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#define MOST_PARTIALS 64

typedef struct Partial {
  double frequency, amplitude, decay;
} Partial;

typedef struct Sound {
  double rate, onset, noise;
  Partial partials[MOST_PARTIALS];
  int count;
  uint32_t random;
} Sound;

static double amplitude(double level) { return level < -200 ? 0 : pow(10, level / 20); }

static bool read_partial(const char *text, Partial *partial) {
  double level = 0;
  if (sscanf(text, "%lf,%lf,%lf", &partial->frequency, &level, &partial->decay) != 3) return false;
  partial->amplitude = amplitude(level);
  return true;
}

/* Uniform, of variance 1. */
static double noise(Sound *sound) {
  sound->random = sound->random * 1664525u + 1013904223u;
  return sqrt(12.0) * ((double)(sound->random >> 8) / 16777216.0 - 0.5);
}

static double sample(Sound *sound, double frame) {
  const double time = frame / sound->rate - sound->onset;
  double sum = sound->noise * noise(sound);
  for (int i = 0; i < sound->count && time >= 0; i++) {
    const Partial *const partial = &sound->partials[i];
    sum += partial->amplitude * exp(-partial->decay * time) *
           cos(6.283185307179586 * partial->frequency * time - 1.5707963267948966 + i);
  }
  return sum;
}

int main(int argc, char **argv) {
  if (argc < 7 || argc > 7 + MOST_PARTIALS) return 2;
  const int channels = atoi(argv[3]);
  const double seconds = atof(argv[4]);
  Sound sound = {.rate = atof(argv[2]),
                 .onset = atof(argv[5]),
                 .noise = amplitude(atof(argv[6])),
                 .count = argc - 7,
                 .random = 1};
  for (int i = 7; i < argc; i++) {
    if (!read_partial(argv[i], &sound.partials[i - 7])) return 2;
  }
  SF_INFO info = {
    .samplerate = (int)sound.rate, .channels = channels, .format = SF_FORMAT_WAV | SF_FORMAT_FLOAT};
  SNDFILE *const stream = sf_open(argv[1], SFM_WRITE, &info);
  double frame[64] = {0};
  if (!stream || channels < 1 || channels > 64) return 1;
  bool complete = true;
  for (int i = 0; i < (int)lround(seconds * sound.rate); i++) {
    frame[channels - 1] = sample(&sound, i);
    complete = sf_writef_double(stream, frame, 1) == 1 && complete;
  }
  return sf_close(stream) == 0 && complete ? 0 : 1;
}
