/* SPDX-License-Identifier: MIT */
/**
 * @file workload.h
 * The workload for measurements of speed: strokes so dense that the drum never sleeps.
 */
#ifndef TABOR_HOST_WORKLOAD_H
#define TABOR_HOST_WORKLOAD_H

#include <math.h>

#include "tabor/tabor.h"

#define WORKLOAD_INTERVAL 0.125 /* time between strokes [s] */

/** Stroke @p index on a drum of @p def at @p rate [Hz]; its frame counts from the start. */
static inline TaborEvent workload_stroke(const TaborDrumDef *def, double rate, uint32_t index) {
  static const double velocities[] = {1, 4};             /* [m/s], used in turn */
  static const double radii[] = {0, 0.2, 0.4, 0.6, 0.8}; /* fractions of the head's, used in turn */
  const int striker = tabor_drum_def_find_striker(def, def->strike.striker);
  return (TaborEvent){
    .frame = (uint32_t)lround(index * WORKLOAD_INTERVAL * rate),
    .type = TABOR_EVENT_STRIKE,
    .id = index + 1,
    .striker = striker > 0 ? (uint32_t)striker : 0,
    .velocity = velocities[index % (sizeof velocities / sizeof velocities[0])],
    .radius = radii[index % (sizeof radii / sizeof radii[0])] * def->shell.radius,
    .angle = def->strike.angle,
  };
}

#endif
