/* SPDX-License-Identifier: MIT */
/**
 * @file fader.h
 * A factor that glides to its target over 5 ms, sample by sample: no click, and the same for every
 * size of block.
 */
#ifndef TABOR_HOST_FADER_H
#define TABOR_HOST_FADER_H

#include <stdint.h>

#include "base/realtime.h"

#define FADER_TIME 0.005 /**< [s] */

typedef struct Fader {
  double now, target, step;
  uint32_t left;   /**< frames until the target */
  uint32_t length; /**< of a glide [frames] */
} Fader;

static inline Fader fader_at(double value, double rate) {
  return (Fader){.now = value, .target = value, .length = (uint32_t)(FADER_TIME * rate)};
}

static inline void fader_set(Fader *fader, double target) {
  fader->target = target;
  fader->left = fader->length;
  fader->step = (target - fader->now) / fader->length;
}

/** The factor of the next frame. */
static inline double fader_next(Fader *fader) {
  if (fader->left == 0) return fader->now;
  fader->left--;
  fader->now = fader->left == 0 ? fader->target : fader->now + fader->step;
  return fader->now;
}

#endif
