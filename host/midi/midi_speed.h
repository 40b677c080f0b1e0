/* SPDX-License-Identifier: MIT */
/**
 * @file midi_speed.h
 * Converts the velocity of a MIDI note, 1 to 127, to the speed of the stick. Between two velocities
 * a and b, with the speeds v_a and v_b, the linear curve (p = 1) gives equal ratios of speed for
 * equal steps:
 *
 *     v = v_a (v_b/v_a)^x,   x = ((velocity - a)/(b - a))^p.
 *
 * | range  | a to b    | v_a to v_b      |                                                    |
 * |--------|-----------|-----------------|----------------------------------------------------|
 * | normal | 20 to 127 | 1 to 10 m/s     |                                                    |
 * |        | 1 to 20   | 0.3 to 1 m/s    | ghost notes                                        |
 * | full   | 1 to 127  | 0.3 to 12 m/s   | the only range of version 0.1                      |
 *
 * The soft curve has p = 2/3: a light touch is already loud. The hard curve has p = 3/2. All curves
 * have the speeds of the table at 1, 127 and, in the normal range, 20.
 *
 * Reason for the normal range: recorded drums span 14 to 28 dB, typically 17, from their softest to
 * their loudest layer. The engine is nearly linear, so 1 to 10 m/s is about 20 dB.
 */
#ifndef TABOR_HOST_MIDI_SPEED_H
#define TABOR_HOST_MIDI_SPEED_H

#include "base/realtime.h"

typedef enum MidiCurve { MIDI_CURVE_SOFT, MIDI_CURVE_LINEAR, MIDI_CURVE_HARD } MidiCurve;
typedef enum MidiRange { MIDI_RANGE_NORMAL, MIDI_RANGE_FULL } MidiRange;

/** Curve and range for the conversion of velocities to speeds. */
typedef struct MidiResponse {
  MidiCurve curve;
  MidiRange range;
} MidiResponse;

/** The linear curve over the normal range. */
extern const MidiResponse midi_response_default;
/** Names in options and files, in the order of the enumerations; NULL comes last. */
extern const char *const midi_curve_names[], *const midi_range_names[];

/** Speed [m/s] for @p velocity, which is clamped to 1 to 127; fractions are allowed. AUDIO. */
double midi_speed(MidiResponse response, double velocity) REALTIME;

#endif
