/* SPDX-License-Identifier: MIT */
/**
 * @file spectrum.h
 * Computes the spectrum of a windowed piece of sound and finds its peaks.
 *
 * The window is the four-term Blackman-Harris window. Its main lobe is 8 bins wide and its side
 * lobes are below -92 dB (Harris 1978), so a weak partial is visible beside a strong one. A bin is
 * 1 / length. Frequencies are in cycles per sample.
 */
#ifndef TABOR_HOST_SPECTRUM_H
#define TABOR_HOST_SPECTRUM_H

#include <fftw3.h>

#include "base/message.h"

typedef struct Spectrum {
  size_t length;  /**< length of the window [samples] */
  double *window; /**< values of the window, with sum 1 */
  double *input;  /**< the windowed samples and as many zeros */
  fftw_complex *output;
  double *power; /**< power of output: length + 1 values, half a bin apart */
  fftw_plan plan;
} Spectrum;

typedef struct Peak {
  double frequency, power;
} Peak;

/** Prepares for pieces of @p length samples, which is even. Free with spectrum_free(). */
Outcome spectrum_open(Spectrum *spectrum, size_t length);
void spectrum_compute(Spectrum *spectrum, const double *samples);
/**
 * Finds at most @p most peaks that stand out from their surroundings, strongest first; returns
 * their number.
 */
size_t spectrum_peaks(const Spectrum *spectrum, Peak *peaks, size_t most);
void spectrum_free(Spectrum *spectrum);

#endif
