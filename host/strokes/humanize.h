/* SPDX-License-Identifier: MIT */
/**
 * @file humanize.h
 * No two strokes of a hand are the same: scatter of where and how fast strokes fall.
 *
 * With amount h, 0 to 1, the place of a stroke moves by up to 15 mm h in any direction, evenly over that
 * disc, so that its radius and its angle both change; beyond the rim it is mirrored back in. The
 * speed changes by a factor of 1 - 0.06 h to 1 + 0.06 h, smaller changes more often (triangular). With h = 0
 * not a bit of a stroke changes. The same seed gives the same changes, stroke by stroke.
 */
#ifndef TABOR_HOST_HUMANIZE_H
#define TABOR_HOST_HUMANIZE_H

#include <stdint.h>
#include <tabor/tabor.h>

#include "base/realtime.h"

#define HUMANIZE_PLACE 0.015 /**< farthest move of the place with amount 1 [m] */
#define HUMANIZE_SPEED 0.06  /**< largest relative change of the speed with amount 1 */

/** The scatter of one player. Plain data: belongs to one thread at a time. */
typedef struct Humanizer {
  double amount;  /**< 0 to 1 */
  uint64_t state; /**< of its generator */
} Humanizer;

Humanizer humanizer(double amount, uint32_t seed);
/**
 * Scatters @p event if it is a stroke, on a head of @p head_radius [m]; leaves other events alone.
 * Real-time safe.
 */
void humanize(Humanizer *humanizer, double head_radius, TaborEvent *event) REALTIME;

#endif
