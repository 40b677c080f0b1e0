/* SPDX-License-Identifier: MIT */
#include "plugin/knob.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#define DIGITS 6 /* that a float keeps whatever they are */

/* ---- the way -------------------------------------------------------------------------------- */

/* The part of the way of a bent knob at whose beginning it is off. */
#define OFF_WAY 0.01

static double ratio(double from, double to, double value) REALTIME;
static double ratio(double from, double to, double value) {
  return fmin(fmax(log(value / from) / log(to / from), 0), 1);
}

double knob_position(const KnobRange *range, double value) {
  const double least = knob_decimal(range->minimum), most = knob_decimal(range->maximum);
  if (range->least > 0) {
    const double way = ratio((double)range->least, most, value);
    return value <= least ? 0 : OFF_WAY + (1 - OFF_WAY) * way;
  }
  return range->logarithmic ? ratio(least, most, value) : (value - least) / (most - least);
}

double knob_at_position(const KnobRange *range, double position) {
  const double least = knob_decimal(range->minimum), most = knob_decimal(range->maximum);
  const double way = fmin(fmax(position, 0), 1);
  if (range->least > 0) {
    if (way < OFF_WAY / 2) return least;
    const double on = fmax((way - OFF_WAY) / (1 - OFF_WAY), 0);
    return (double)range->least * pow(most / (double)range->least, on);
  }
  return range->logarithmic ? least * pow(most / least, way) : least + way * (most - least);
}

double knob_stepped(double position, double way, uint32_t choices) {
  const double least = choices > 1 ? 1.0 / (choices - 1u) : 0;
  const double step = fabs(way) < least ? copysign(least, way) : way;
  return fmin(fmax(position + step, 0), 1);
}

/* ---- values --------------------------------------------------------------------------------- */

float knob_single(double value) {
  return (float)fmin(fmax(value, -(double)FLT_MAX), (double)FLT_MAX);
}

float knob_limited(const Knob *knob, const KnobRange *range, double value) {
  const double whole = knob->choices ? trunc(value) : value;
  const float kept = knob_single(knob_decimal(knob_single(whole)));
  return fminf(fmaxf(kept, range->minimum), range->maximum);
}

double knob_factor(const Knob *knob, float value) {
  return (double)value <= knob->off ? 0 : pow(10, knob_decimal(value) / 20);
}

double knob_decimal(float value) {
  if (value == 0 || !isfinite(value)) return (double)value;
  const int exponent = DIGITS - 1 - (int)floor(log10(fabs((double)value)));
  const double scale = pow(10, abs(exponent)); /* exact up to 10^22 */
  return exponent >= 0 ? round((double)value * scale) / scale
                       : round((double)value / scale) * scale;
}
