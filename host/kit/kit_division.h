/* SPDX-License-Identifier: MIT */
/**
 * @file kit_division.h
 * Divides the drums of a kit between threads by what they cost: the dearest drum first, each to the
 * part that costs least so far (Graham's rule, at most 4/3 of the best division: SIAM J. Appl.
 * Math. 17, 1969). Costs are measured, since they change with what is played. Drums change their
 * part only if the dearest part gains by it: a part's tables stay in its processor's cache.
 */
#ifndef TABOR_HOST_KIT_DIVISION_H
#define TABOR_HOST_KIT_DIVISION_H

#include <stdbool.h>
#include <stdint.h>

#include <tabor/kit.h>

#include "base/realtime.h"

typedef struct KitDivision {
  double seconds[TABOR_KIT_DRUMS]; /**< that each drum took since the last call of
                                      kit_division_renew() */
  double cost[TABOR_KIT_DRUMS];    /**< of each drum [s], over some such times */
  double begun;                    /**< of this time [s]; 0: it has not begun */
  uint32_t drums, most;            /**< of the kit; most parts */
  uint32_t parts;                  /**< in use; 1: one thread is enough */
  uint32_t part[TABOR_KIT_DRUMS];  /**< bits of each part's drums */
} KitDivision;

/** One part, which has all drums. */
void kit_division_begin(KitDivision *division, uint32_t drums, uint32_t most) REALTIME;
/** Divides anew by `seconds`, and begins another time; @p now is a clock [s]. While all drums
 * together take less than a quarter of the time that passes, there is one part. */
void kit_division_renew(KitDivision *division, double now) REALTIME;

#endif
