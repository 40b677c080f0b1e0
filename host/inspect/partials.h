/* SPDX-License-Identifier: MIT */
/**
 * @file partials.h
 * Finds the ringing partials of a struck sound, with their frequencies, levels and decays.
 *
 * Spectra of the sound from its onset are computed with windows from long to short, each half as
 * long as the previous one. A long window separates close partials; a short window finds partials
 * that decay fast. Every peak is tracked through time (partial_tracker.h). The result is from the
 * longest window through which the level decays in a straight line. The peak then hides others that
 * this window cannot separate from it.
 */
#ifndef TABOR_HOST_PARTIALS_H
#define TABOR_HOST_PARTIALS_H

#include <stddef.h>

#include "base/message.h"

#define MOST_PARTIALS 1000

typedef struct Partial {
  double frequency;  /**< [Hz] */
  double level;      /**< of the amplitude at the onset, relative to a full-scale sine [dB] */
  double decay_rate; /**< of the amplitude [1/s]; 0 = steady, below 0 = growing */
} Partial;

typedef struct Partials {
  Partial list[MOST_PARTIALS]; /**< strongest first */
  size_t count;
} Partials;

/** Search criteria. */
typedef struct PartialSearch {
  double rate;        /**< [Hz] */
  size_t most;        /**< largest number of partials */
  double least_level; /**< [dB] */
} PartialSearch;

/** Index of the first sample of the sound's onset; @p count if all samples are zero. */
size_t find_onset(const double *samples, size_t count);
/** Number of samples from the onset on that partials_find() needs. */
size_t partials_least_samples(double rate);
/** Finds the partials of a sound whose first sample is its onset. */
Outcome partials_find(const PartialSearch *wanted, const double *samples, size_t count,
                      Partials *partials);

#endif
