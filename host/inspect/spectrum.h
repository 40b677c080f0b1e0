/* SPDX-License-Identifier: MIT */
/**
 * @file spectrum.h
 * The spectrum of a windowed piece of sound, and its peaks.
 *
 * The window is Blackman and Harris's with four terms: a line is 8 bins wide at its foot, and leaks
 * less than -92 dB elsewhere (Harris 1978), so that a weak partial shows beside a strong one. A bin
 * is 1 / length. Frequencies are in cycles per sample.
 */
#ifndef TABOR_HOST_SPECTRUM_H
#define TABOR_HOST_SPECTRUM_H

#include <fftw3.h>

#include "base/message.h"

typedef struct Spectrum {
  size_t length;  /**< samples of the window */
  double *window; /**< its values, of sum 1 */
  double *input;  /**< the windowed samples and as many zeros */
  fftw_complex *output;
  double *power; /**< of output, length + 1 values: half a bin apart */
  fftw_plan plan;
} Spectrum;

typedef struct Peak {
  double frequency, power;
} Peak;

/** Prepares for pieces of @p length samples, an even number. Free with spectrum_free(). */
Outcome spectrum_open(Spectrum *spectrum, size_t length);
void spectrum_compute(Spectrum *spectrum, const double *samples);
/**
 * Finds at most @p most peaks that stand out from what surrounds them, strongest first; returns their
 * number.
 */
size_t spectrum_peaks(const Spectrum *spectrum, Peak *peaks, size_t most);
void spectrum_free(Spectrum *spectrum);

#endif
