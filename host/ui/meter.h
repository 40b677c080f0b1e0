/* SPDX-License-Identifier: MIT */
/**
 * @file meter.h
 * Level meters: fast attack, slow release, peak hold and a clip light.
 */
#ifndef TABOR_HOST_METER_H
#define TABOR_HOST_METER_H

#include <stdbool.h>

#define METER_FLOOR (-60.0)   /**< lowest level shown [dBFS] */
#define METER_FALL 24.0       /**< release of the level [dB/s] */
#define METER_HOLD 1.5        /**< hold time of a peak [s] */
#define METER_PEAK_FALL 12.0  /**< release of the peak after its hold [dB/s] */
#define METER_CLIP 2.0        /**< time that the clip light stays on [s] */
#define METER_LOAD_SETTLE 0.5 /**< time constant of a load's median [s] */
#define METER_LOAD_HOLD 3.0   /**< hold time of the worst load [s] */

/** Meter of one channel. Initialise with meter_begin(). */
typedef struct Meter {
  double level, peak; /**< [dBFS], METER_FLOOR at least */
  double hold_left;   /**< remaining hold of the peak [s] */
  double clip_left;   /**< remaining time of the clip light [s]; on while above 0 */
} Meter;

/** Meter of the load, computing time of blocks divided by their duration. Initialise with {0}. */
typedef struct LoadMeter {
  double median, worst;
  double hold_left; /**< remaining hold of the worst [s] */
} LoadMeter;

Meter meter_begin(void);
/** Takes @p peak, the largest sample of the last @p seconds, 1.0 = full scale. */
void meter_take(Meter *meter, double peak, double seconds);
/** Takes the median and worst load of the last @p seconds. */
void load_meter_take(LoadMeter *meter, double median, double worst, double seconds);

#endif
