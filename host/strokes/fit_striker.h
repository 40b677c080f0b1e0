/* SPDX-License-Identifier: MIT */
/**
 * @file fit_striker.h
 * Adapts strokes for another drum, with more strikers, to a drum. Real-time safe.
 */
#ifndef TABOR_HOST_FIT_STRIKER_H
#define TABOR_HOST_FIT_STRIKER_H

#include <tabor/tabor.h>

/** Gives a stroke striker 0 if the drum, with @p strikers strikers, lacks its striker. */
static inline void fit_striker(TaborEvent *event, uint32_t strikers) {
  const bool plucks = event->technique == TABOR_TECHNIQUE_PLUCK; /* a wire, not a striker */
  if (event->type == TABOR_EVENT_STRIKE && !plucks && event->striker >= strikers) {
    event->striker = 0;
  }
}

#endif
