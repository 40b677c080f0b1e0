/* SPDX-License-Identifier: MIT */
/**
 * @file humanize.h
 * Random scatter of the position and speed of strokes, like the strokes of a hand.
 *
 * With amount h, 0 to 1, the position of a stroke moves by up to 15 mm h in any direction,
 * uniformly over that disc, so radius and angle both change; a position beyond the rim is mirrored
 * back in. The speed changes by a factor of 1 - 0.06 h to 1 + 0.06 h with a triangular
 * distribution. With h = 0 no bit of a stroke changes. The same seed gives the same changes, stroke
 * by stroke.
 */
#ifndef TABOR_HOST_HUMANIZE_H
#define TABOR_HOST_HUMANIZE_H

#include <stdint.h>
#include <tabor/tabor.h>

#include "base/realtime.h"

#define HUMANIZE_PLACE 0.015 /**< largest move of the position with amount 1 [m] */
#define HUMANIZE_SPEED 0.06  /**< largest relative change of the speed with amount 1 */
/** The amount where nothing else is asked for, in live play, plugins and takes: strokes then differ
 * as recorded ones do (tools/compare-takes). */
#define HUMANIZE_LIVE 0.5
#define HUMANIZE_LIVE_TEXT "0.5"
#define HUMANIZE_SEED 1 /**< where nothing else is asked for */

/** The scatter of one player. Plain data, for one thread at a time. */
typedef struct Humanizer {
  double amount;  /**< 0 to 1 */
  uint64_t state; /**< state of the random generator */
} Humanizer;

/** Makes a scatter of @p amount, 0 to 1, with its own @p seed. */
Humanizer humanizer(double amount, uint32_t seed);
/**
 * Scatters @p event if it is a stroke, on a head of @p head_radius [m]; does not change other
 * events. Real-time safe.
 */
void humanize(Humanizer *humanizer, double head_radius, TaborEvent *event) REALTIME;

#endif
