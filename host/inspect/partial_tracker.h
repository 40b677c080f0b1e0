/* SPDX-License-Identifier: MIT */
/**
 * @file partial_tracker.h
 * Tracks one partial through time and fits an exponentially decaying sinusoid to it.
 *
 * The sound is multiplied with a window w of length L at successive times kH. For a partial
 * a exp(-s n) cos(u n + p) and a guess v of its frequency u, the sum over n of
 * w[n] x[kH + n] exp(-iv(kH + n)) is (a/2) exp(ip) W exp((-s + i(u - v)) kH) with a constant W, the
 * window's transform. Its level is a straight line with a slope that gives s; its phase is a
 * straight line with a slope that gives u - v. The values of both lines at k = 0, divided by W,
 * give a. Only other partials and noise make this inexact. Units are cycles and samples. A steady
 * tone is the limiting case s = 0.
 */
#ifndef TABOR_HOST_PARTIAL_TRACKER_H
#define TABOR_HOST_PARTIAL_TRACKER_H

#include <stddef.h>

#include "inspect/spectrum.h"

#define TRACKER_MOST 64   /**< most windows */
#define TRACKER_LEAST 8   /**< fewest windows for a fit */
#define TRACKER_OVERLAP 8 /**< window length divided by the distance of windows */

/** Fewest samples for a fit with a window of @p length. */
#define TRACKER_SAMPLES(length) ((length) + (TRACKER_LEAST - 1) * ((length) / TRACKER_OVERLAP))

typedef struct PartialFit {
  double frequency;  /**< [cycles per sample] */
  double decay_rate; /**< of the amplitude [1/sample]; 0 if the change is negligible */
  double amplitude;  /**< at the first sample */
  double deviation;  /**< root mean square of the levels' deviation from a line [dB] */
  double lag;        /**< decay of the partial before the first window [dB] */
} PartialFit;

/** Work memory for tracking partials. */
typedef struct PartialTracker {
  const Spectrum *spectrum;                        /**< its window is used */
  double *real, *imaginary;                        /**< window times oscillator */
  double level[TRACKER_MOST], phase[TRACKER_MOST]; /**< [dB], [rad] */
  double weight[TRACKER_MOST];                     /**< of each window in the fits */
  size_t count;
} PartialTracker;

/** Allocates the memory. Free with partial_tracker_free(), whatever the outcome. */
Outcome partial_tracker_open(PartialTracker *tracker, const Spectrum *spectrum);
/**
 * Tracks the partial near @p frequency from the first of @p count samples on. False if it falls
 * below the noise floor too soon.
 */
bool partial_tracker_fit(PartialTracker *tracker, const double *samples, size_t count,
                         double frequency, PartialFit *fit);
void partial_tracker_free(PartialTracker *tracker);

#endif
