/* SPDX-License-Identifier: MIT */
/**
 * @file partials.h
 * The partials of a struck sound: those that ring, with their frequencies, levels and decays.
 *
 * Spectra of the sound from its onset on are taken with windows from long to short, each half as long
 * as the one before. Peaks of a long one tell close partials apart, those of a short one find
 * partials that do not ring for long. Every peak is followed through time (partial_tracker.h); it is taken
 * with the longest window through which it decays in a straight line, and hides others that this
 * window cannot tell from it.
 */
#ifndef TABOR_HOST_PARTIALS_H
#define TABOR_HOST_PARTIALS_H

#include <stddef.h>

#include "base/message.h"

#define MOST_PARTIALS 1000

typedef struct Partial {
  double frequency;  /**< [Hz] */
  double level;      /**< of its amplitude at the onset, 0 = that of a full-scale sine [dB] */
  double decay_rate; /**< of the amplitude [1/s]; 0 = steady, below 0 = growing */
} Partial;

typedef struct Partials {
  Partial list[MOST_PARTIALS]; /**< strongest first */
  size_t count;
} Partials;

/** What to look for. */
typedef struct PartialSearch {
  double rate;        /**< [Hz] */
  size_t most;        /**< partials wanted */
  double least_level; /**< [dB] */
} PartialSearch;

/** First sample of a sound that begins; @p count if all of them are zero. */
size_t find_onset(const double *samples, size_t count);
/** Samples from the onset on that partials_find() needs. */
size_t partials_least_samples(double rate);
/** Finds the partials of a sound that begins with its onset. */
Outcome partials_find(const PartialSearch *wanted, const double *samples, size_t count,
                      Partials *partials);

#endif
