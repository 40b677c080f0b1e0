/* SPDX-License-Identifier: MIT */
#include "midi/midi_speed.h"

#include <math.h>
#include <stddef.h>

/* Velocities and their speeds [m/s]; between them equal steps are equal ratios. */
typedef struct Span {
  double from, to;
  double slowest, fastest;
} Span;

static const Span ghost_notes = {1, 20, 0.3, 1};
static const Span normal = {20, 127, 1, 10};
static const Span full = {1, 127, 0.3, 12};

const MidiResponse midi_response_default = {MIDI_CURVE_LINEAR, MIDI_RANGE_NORMAL};
const char *const midi_curve_names[] = {"soft", "linear", "hard", NULL};
const char *const midi_range_names[] = {"normal", "full", NULL};

static const Span *span_of(MidiRange range, double velocity) {
  if (range == MIDI_RANGE_FULL) return &full;
  return velocity < normal.from ? &ghost_notes : &normal;
}

double midi_speed(MidiResponse response, double velocity) {
  const Span *const span = span_of(response.range, velocity);
  const double inside = fmin(fmax(velocity, span->from), span->to);
  double x = (inside - span->from) / (span->to - span->from);
  if (response.curve == MIDI_CURVE_SOFT) x = pow(x, 2.0 / 3);
  if (response.curve == MIDI_CURVE_HARD) x = pow(x, 3.0 / 2);
  return span->slowest * pow(span->fastest / span->slowest, x);
}
