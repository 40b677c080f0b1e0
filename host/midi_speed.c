/* SPDX-License-Identifier: MIT */
#include "midi_speed.h"

#include <math.h>

static const double SLOWEST = 0.3; /* [m/s] */
static const double FASTEST = 12;  /* [m/s] */

double midi_speed(MidiCurve curve, double velocity) {
  double x = (fmin(fmax(velocity, 1), 127) - 1) / 126;
  if (curve == MIDI_CURVE_SOFT) x = pow(x, 2.0 / 3);
  if (curve == MIDI_CURVE_HARD) x = pow(x, 3.0 / 2);
  return SLOWEST * pow(FASTEST / SLOWEST, x);
}
