/* SPDX-License-Identifier: MIT */
/**
 * @file fit_striker.h
 * Strokes that were meant for another drum, which had more strikers. Real-time safe.
 */
#ifndef TABOR_HOST_FIT_STRIKER_H
#define TABOR_HOST_FIT_STRIKER_H

#include <tabor/tabor.h>

/** A stroke with a striker that a drum of @p strikers has not got takes its first. */
static inline void fit_striker(TaborEvent *event, uint32_t strikers) {
  if (event->type == TABOR_EVENT_STRIKE && event->striker >= strikers) event->striker = 0;
}

#endif
