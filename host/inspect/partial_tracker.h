/* SPDX-License-Identifier: MIT */
/**
 * @file partial_tracker.h
 * One partial followed through time, and the exponentially decaying sinusoid that fits it.
 *
 * The sound is seen through a window w of length L at successive times kH. For a partial
 * a exp(-s n) cos(u n + p) and a guess v of its frequency u, the sum over n of
 * w[n] x[kH + n] exp(-iv(kH + n)) is (a/2) exp(ip) W exp((-s + i(u - v)) kH) with a constant W, the
 * window's transform: its level falls in a line whose slope gives s, its phase turns in a line whose
 * slope gives u - v, and what both lines are at k = 0, divided by W, gives a. Nothing here is
 * approximate but what other partials and noise add. In cycles and per sample; the limiting case of
 * a steady tone is s = 0.
 */
#ifndef TABOR_HOST_PARTIAL_TRACKER_H
#define TABOR_HOST_PARTIAL_TRACKER_H

#include <stddef.h>

#include "inspect/spectrum.h"

#define TRACKER_MOST 64   /**< windows */
#define TRACKER_LEAST 8   /**< windows that a fit needs */
#define TRACKER_OVERLAP 8 /**< windows begin the length divided by this apart */

/** Samples that a fit needs with a window of @p length. */
#define TRACKER_SAMPLES(length) ((length) + (TRACKER_LEAST - 1) * ((length) / TRACKER_OVERLAP))

typedef struct PartialFit {
  double frequency;  /**< [cycles per sample] */
  double decay_rate; /**< of the amplitude [1/sample]; 0 if there is no change to speak of */
  double amplitude;  /**< at the first sample */
  double deviation;  /**< of the levels from a line, root mean square [dB] */
  double lag;        /**< how far the partial has fallen when the first window sees it [dB] */
} PartialFit;

/** Memory for following partials through a window. */
typedef struct PartialTracker {
  const Spectrum *spectrum;                        /**< its window is used */
  double *real, *imaginary;                        /**< window times oscillator */
  double level[TRACKER_MOST], phase[TRACKER_MOST]; /**< [dB], [rad] */
  double weight[TRACKER_MOST];                     /**< in the fits */
  size_t count;
} PartialTracker;

/** Free with partial_tracker_free(), whatever the outcome. */
Outcome partial_tracker_open(PartialTracker *tracker, const Spectrum *spectrum);
/**
 * Follows what is near @p frequency from the first of @p count samples on. False if it is lost in the
 * floor too soon.
 */
bool partial_tracker_fit(PartialTracker *tracker, const double *samples, size_t count,
                         double frequency, PartialFit *fit);
void partial_tracker_free(PartialTracker *tracker);

#endif
