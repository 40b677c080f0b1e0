/* SPDX-License-Identifier: MIT */
/**
 * @file meter.h
 * What a meter shows: rises at once, falls slowly, holds its peaks, lights up when the sound clips.
 */
#ifndef TABOR_HOST_METER_H
#define TABOR_HOST_METER_H

#include <stdbool.h>

#define METER_FLOOR (-60.0)   /**< what it shows at least [dBFS] */
#define METER_FALL 24.0       /**< of the level [dB/s] */
#define METER_HOLD 1.5        /**< how long a peak stands [s] */
#define METER_PEAK_FALL 12.0  /**< of the peak after that [dB/s] */
#define METER_CLIP 2.0        /**< how long the clip light is on [s] */
#define METER_LOAD_SETTLE 0.5 /**< time constant of a load's median [s] */
#define METER_LOAD_HOLD 3.0   /**< how long the worst load stands [s] */

/** Of one channel. Begins as meter_begin() says. */
typedef struct Meter {
  double level, peak; /**< [dBFS], METER_FLOOR at least */
  double hold_left;   /**< of the peak [s] */
  double clip_left;   /**< of the light [s]: it is on while this is above 0 */
} Meter;

/** Of the computing time of blocks, as a share of their length. Begins as {0}. */
typedef struct LoadMeter {
  double median, worst;
  double hold_left; /**< of the worst [s] */
} LoadMeter;

Meter meter_begin(void);
/** The largest sample of the last @p seconds was @p peak, 1.0 = full scale. */
void meter_take(Meter *meter, double peak, double seconds);
void load_meter_take(LoadMeter *meter, double median, double worst, double seconds);

#endif
