/* SPDX-License-Identifier: MIT */
/**
 * @file fader.h
 * A gain factor that ramps linearly to its target over 5 ms. It moves every sample, so it does not
 * click and does not depend on the block size.
 */
#ifndef TABOR_HOST_FADER_H
#define TABOR_HOST_FADER_H

#include <stdint.h>

#include "base/realtime.h"

#define FADER_TIME 0.005 /**< [s] */

typedef struct Fader {
  double now, target, step;
  uint32_t left;   /**< frames until the target */
  uint32_t length; /**< of a ramp [frames] */
} Fader;

static inline Fader fader_at(double value, double rate) {
  return (Fader){.now = value, .target = value, .length = (uint32_t)(FADER_TIME * rate)};
}

static inline void fader_set(Fader *fader, double target) {
  fader->target = target;
  fader->left = fader->length;
  fader->step = (target - fader->now) / fader->length;
}

/** Returns the factor of the next frame. */
static inline double fader_next(Fader *fader) {
  if (fader->left == 0) return fader->now;
  fader->left--;
  fader->now = fader->left == 0 ? fader->target : fader->now + fader->step;
  return fader->now;
}

#endif
