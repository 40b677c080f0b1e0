/* SPDX-License-Identifier: MIT */
#include "inspect/spectrum.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PADDING 2       /* the transform is that much longer than the window */
#define HALF_LINE 4     /* bins from a line's middle to its foot */
#define SURROUNDINGS 64 /* values on either side that a peak is compared with */
#define PROMINENCE 30.0 /* least power over their median; noise reaches 18 at its 100,000 best */
#define LEAKAGE 3e-9    /* least power over the strongest peak's: what leaks is below -92 dB */
#define LINE_VALUES (HALF_LINE * PADDING)

static const double pi = 3.14159265358979323846;

static void fill_window(double *window, size_t length) {
  static const double terms[] = {0.35875, -0.48829, 0.14128, -0.01168};
  double sum = 0;
  for (size_t i = 0; i < length; i++) {
    const double angle = 2 * pi * ((double)i + 0.5) / (double)length;
    window[i] = 0;
    for (size_t j = 0; j < 4; j++) window[i] += terms[j] * cos((double)j * angle);
    sum += window[i];
  }
  for (size_t i = 0; i < length; i++) window[i] /= sum;
}

Outcome spectrum_open(Spectrum *spectrum, size_t length) {
  const size_t size = PADDING * length;
  *spectrum = (Spectrum){.length = length,
                         .window = fftw_alloc_real(length),
                         .input = fftw_alloc_real(size),
                         .output = fftw_alloc_complex(size / 2 + 1),
                         .power = fftw_alloc_real(size / 2 + 1)};
  if (!spectrum->window || !spectrum->input || !spectrum->output || !spectrum->power) {
    return fail_memory();
  }
  /* estimated, not measured: the same plan, and so the same figures, every time */
  spectrum->plan =
    fftw_plan_dft_r2c_1d((int)size, spectrum->input, spectrum->output, FFTW_ESTIMATE);
  if (!spectrum->plan) return fail_memory();
  fill_window(spectrum->window, length);
  return OUTCOME_OK;
}

void spectrum_compute(Spectrum *spectrum, const double *samples) {
  const size_t length = spectrum->length;
  for (size_t i = 0; i < length; i++) spectrum->input[i] = spectrum->window[i] * samples[i];
  memset(spectrum->input + length, 0, (PADDING - 1) * length * sizeof *spectrum->input);
  fftw_execute(spectrum->plan);
  for (size_t i = 0; i <= PADDING * length / 2; i++) {
    const double real = spectrum->output[i][0], imaginary = spectrum->output[i][1];
    spectrum->power[i] = real * real + imaginary * imaginary;
  }
}

static int compare_numbers(const void *left, const void *right) {
  const double a = *(const double *)left, b = *(const double *)right;
  return a < b ? -1 : a > b;
}

/* Median power around a peak, without its own line. */
static double surroundings(const Spectrum *spectrum, size_t peak) {
  double around[2 * SURROUNDINGS];
  const size_t last = PADDING * spectrum->length / 2;
  size_t count = 0;
  for (size_t distance = LINE_VALUES; distance < SURROUNDINGS; distance++) {
    if (peak >= distance) around[count++] = spectrum->power[peak - distance];
    if (peak + distance <= last) around[count++] = spectrum->power[peak + distance];
  }
  qsort(around, count, sizeof around[0], compare_numbers);
  return count > 0 ? around[count / 2] : INFINITY;
}

static bool is_peak(const Spectrum *spectrum, size_t i, double least) {
  const double *const power = spectrum->power;
  return power[i] > least && power[i] >= power[i - 1] && power[i] > power[i + 1] &&
         power[i] > PROMINENCE * surroundings(spectrum, i);
}

/* The top of the parabola through three levels in decibels: the window's line is nearly one. */
static Peak interpolate(const Spectrum *spectrum, size_t i) {
  const double before = log(spectrum->power[i - 1] + 1e-300), top = log(spectrum->power[i]),
               after = log(spectrum->power[i + 1] + 1e-300);
  const double curvature = before - 2 * top + after;
  const double offset = curvature < 0 ? 0.5 * (before - after) / curvature : 0;
  return (Peak){((double)i + offset) / (double)(PADDING * spectrum->length),
                exp(top - 0.25 * (before - after) * offset)};
}

/* Adds to a list of at most @p most that is sorted by falling power; returns the new length. */
static size_t insert(Peak *peaks, size_t count, size_t most, Peak peak) {
  size_t at = count;
  while (at > 0 && peaks[at - 1].power < peak.power) at--;
  if (at == most) return count;
  const size_t kept = count < most ? count : most - 1;
  memmove(peaks + at + 1, peaks + at, (kept - at) * sizeof *peaks);
  peaks[at] = peak;
  return kept + 1;
}

/* Closer to 0 or to the upper end a line would mix with its own mirror image. */
size_t spectrum_peaks(const Spectrum *spectrum, Peak *peaks, size_t most) {
  const size_t last = PADDING * spectrum->length / 2 - LINE_VALUES;
  double strongest = 0;
  for (size_t i = LINE_VALUES; i < last; i++) strongest = fmax(strongest, spectrum->power[i]);
  size_t count = 0;
  for (size_t i = LINE_VALUES; i < last; i++) {
    if (is_peak(spectrum, i, LEAKAGE * strongest)) {
      count = insert(peaks, count, most, interpolate(spectrum, i));
    }
  }
  return count;
}

void spectrum_free(Spectrum *spectrum) {
  if (spectrum->plan) fftw_destroy_plan(spectrum->plan);
  fftw_free(spectrum->window);
  fftw_free(spectrum->input);
  fftw_free(spectrum->output);
  fftw_free(spectrum->power);
  *spectrum = (Spectrum){0};
}
