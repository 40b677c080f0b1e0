/* SPDX-License-Identifier: MIT */
#include "ui/meter.h"

#include <math.h>

Meter meter_begin(void) { return (Meter){.level = METER_FLOOR, .peak = METER_FLOOR}; }

static double decibels(double peak) {
  return peak > 0 ? fmax(20 * log10(peak), METER_FLOOR) : METER_FLOOR;
}

static void take_peak(Meter *meter, double seconds) {
  if (meter->level >= meter->peak) {
    meter->peak = meter->level;
    meter->hold_left = METER_HOLD;
    return;
  }
  const double falling = fmax(seconds - meter->hold_left, 0);
  meter->hold_left = fmax(meter->hold_left - seconds, 0);
  meter->peak = fmax(meter->peak - METER_PEAK_FALL * falling, meter->level);
}

void meter_take(Meter *meter, double peak, double seconds) {
  const double fallen = fmax(meter->level - METER_FALL * seconds, METER_FLOOR);
  meter->level = fmax(decibels(peak), fallen);
  take_peak(meter, seconds);
  meter->clip_left = peak > 1 ? METER_CLIP : fmax(meter->clip_left - seconds, 0);
}

void load_meter_take(LoadMeter *meter, double median, double worst, double seconds) {
  meter->median += (median - meter->median) * (1 - exp(-seconds / METER_LOAD_SETTLE));
  meter->hold_left -= seconds;
  if (worst < meter->worst && meter->hold_left > 0) return;
  meter->worst = worst;
  meter->hold_left = METER_LOAD_HOLD;
}
