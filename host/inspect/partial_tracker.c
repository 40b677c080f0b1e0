/* SPDX-License-Identifier: MIT */
#include "inspect/partial_tracker.h"

#include <math.h>
#include <stdlib.h>

#define RANGE 40.0          /* the fit uses what is less far below the loudest [dB] */
#define ABOVE_FLOOR 10.0    /* and at least so far above the floor [dB] */
#define SILENT (-400.0)     /* level of nothing at all [dB] */
#define LEAST_VARIANCE 1e-4 /* of a level without noise: other partials leak [dB^2] */
#define VARIANCE 37.7       /* of a level whose noise is as strong: (10 / ln 10)^2 * 2 [dB^2] */
#define NO_CHANGE 1e-3      /* over the whole fit [dB]: a steady tone */

static const double pi = 3.14159265358979323846;
static const double decibels_per_neper = 8.685889638065036553;

Outcome partial_tracker_open(PartialTracker *tracker, const Spectrum *spectrum) {
  *tracker = (PartialTracker){.spectrum = spectrum,
                              .real = malloc(spectrum->length * sizeof *tracker->real),
                              .imaginary = malloc(spectrum->length * sizeof *tracker->imaginary)};
  return tracker->real && tracker->imaginary ? OUTCOME_OK : fail_memory();
}

void partial_tracker_free(PartialTracker *tracker) {
  free(tracker->real);
  free(tracker->imaginary);
  tracker->real = tracker->imaginary = NULL;
}

/* ---- following ---- */

static void prepare_oscillator(PartialTracker *tracker, double frequency) {
  for (size_t i = 0; i < tracker->spectrum->length; i++) {
    const double angle = 2 * pi * fmod(frequency * (double)i, 1);
    tracker->real[i] = tracker->spectrum->window[i] * cos(angle);
    tracker->imaginary[i] = -tracker->spectrum->window[i] * sin(angle);
  }
}

/* Level and phase against the oscillator in window @p k, which begins at samples. */
static void look(PartialTracker *tracker, size_t k, const double *samples, double turns) {
  double real = 0, imaginary = 0;
  for (size_t i = 0; i < tracker->spectrum->length; i++) {
    real += samples[i] * tracker->real[i];
    imaginary += samples[i] * tracker->imaginary[i];
  }
  const double size = hypot(real, imaginary);
  const double phase = atan2(imaginary, real) - 2 * pi * fmod(turns, 1);
  const double before = k > 0 ? tracker->phase[k - 1] : phase;
  tracker->level[k] = size > 0 ? 20 * log10(size) : SILENT;
  tracker->phase[k] = before + remainder(phase - before, 2 * pi); /* turns less than half a time */
}

static void follow(PartialTracker *tracker, const double *samples, size_t count, double frequency) {
  const size_t length = tracker->spectrum->length, hop = length / TRACKER_OVERLAP;
  double loudest = SILENT;
  prepare_oscillator(tracker, frequency);
  for (tracker->count = 0; tracker->count < TRACKER_MOST; tracker->count++) {
    const size_t start = tracker->count * hop;
    if (start + length > count) return;
    look(tracker, tracker->count, samples + start, frequency * (double)start);
    loudest = fmax(loudest, tracker->level[tracker->count]);
    if (tracker->count >= TRACKER_LEAST && tracker->level[tracker->count] < loudest - RANGE) return;
  }
}

/* ---- fitting ---- */

/* Weighted least squares: values[i] is nearly start + slope i. */
typedef struct Line {
  double start, slope;
} Line;

static Line fit_line(const double *values, const double *weights, size_t count) {
  double sum = 0, x_mean = 0, mean = 0, product = 0, square = 0;
  for (size_t i = 0; i < count; i++) {
    sum += weights[i];
    x_mean += weights[i] * (double)i;
    mean += weights[i] * values[i];
  }
  x_mean /= sum;
  mean /= sum;
  for (size_t i = 0; i < count; i++) {
    const double x = (double)i - x_mean;
    product += weights[i] * x * values[i];
    square += weights[i] * x * x;
  }
  const double slope = product / square;
  return (Line){mean - slope * x_mean, slope};
}

/* Root mean square, weighted. */
static double deviation(const double *values, const double *weights, size_t count, Line line) {
  double sum = 0, square = 0;
  for (size_t i = 0; i < count; i++) {
    const double difference = values[i] - line.start - line.slope * (double)i;
    sum += weights[i];
    square += weights[i] * difference * difference;
  }
  return sqrt(square / sum);
}

/* Level of the floor that the track ends in, if it falls at the end less than half as fast as at
   the beginning; SILENT if it does not. */
static double find_floor(PartialTracker *tracker) {
  const size_t third = tracker->count / 3, rest = tracker->count - third;
  if (third < 2) return SILENT;
  for (size_t i = 0; i < third; i++) tracker->weight[i] = 1;
  const Line early = fit_line(tracker->level, tracker->weight, third),
             late = fit_line(tracker->level + rest, tracker->weight, third);
  if (early.slope >= 0 || late.slope < 0.5 * early.slope) return SILENT;
  return late.start + 0.5 * late.slope * (double)(third - 1);
}

/* Weighs each window by how well noise of the floor's level lets its level be known. Returns the
   number of windows before the partial comes near the floor. */
static size_t weigh(PartialTracker *tracker) {
  const double floor_level = find_floor(tracker);
  size_t count = 0;
  for (; count < tracker->count && tracker->level[count] > floor_level + ABOVE_FLOOR; count++) {
    const double noise = pow(10, (floor_level - tracker->level[count]) / 10); /* over the partial */
    tracker->weight[count] = 1 / (LEAST_VARIANCE + VARIANCE * noise);
  }
  return count;
}

/* The window's answer to a partial that decays and is off the oscillator's frequency, both per
   sample, against that to a steady one: the size of W. */
static double window_answer(const Spectrum *spectrum, double decay_rate, double offset) {
  double real = 0, imaginary = 0;
  for (size_t i = 0; i < spectrum->length; i++) {
    const double size = spectrum->window[i] * exp(-decay_rate * (double)i);
    real += size * cos(offset * (double)i);
    imaginary += size * sin(offset * (double)i);
  }
  return hypot(real, imaginary);
}

bool partial_tracker_fit(PartialTracker *tracker, const double *samples, size_t count,
                         double frequency, PartialFit *fit) {
  follow(tracker, samples, count, frequency);
  const size_t used = weigh(tracker);
  if (used < TRACKER_LEAST) return false;
  const Line level = fit_line(tracker->level, tracker->weight, used),
             phase = fit_line(tracker->phase, tracker->weight, used);
  const size_t hop_length = tracker->spectrum->length / TRACKER_OVERLAP;
  const double hop = (double)hop_length;
  const bool steady = fabs(level.slope) * (double)used < NO_CHANGE;
  const double offset = phase.slope / hop;
  fit->decay_rate = steady ? 0 : -level.slope / decibels_per_neper / hop;
  fit->frequency = frequency + offset / (2 * pi);
  fit->deviation = deviation(tracker->level, tracker->weight, used, level);
  const double answer = window_answer(tracker->spectrum, fit->decay_rate, offset);
  fit->lag = -20 * log10(answer);
  fit->amplitude = 2 * pow(10, level.start / 20) / answer;
  return true;
}
