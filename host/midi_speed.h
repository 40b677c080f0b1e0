/* SPDX-License-Identifier: MIT */
/**
 * @file midi_speed.h
 * How fast the stick is for the velocity of a MIDI note: from 0.3 m/s for 1 to 12 m/s for 127,
 *
 *     v = 0.3 (12/0.3)^x,   x = ((velocity - 1)/126)^p,
 *
 * p = 1 for the linear curve: equal steps are equal ratios. With p = 2/3 the keys feel soft, a light touch
 * is already loud; with p = 3/2 they feel hard. All curves meet at both ends.
 */
#ifndef TABOR_HOST_MIDI_SPEED_H
#define TABOR_HOST_MIDI_SPEED_H

#include "realtime.h"

typedef enum MidiCurve { MIDI_CURVE_SOFT, MIDI_CURVE_LINEAR, MIDI_CURVE_HARD } MidiCurve;

/** [m/s]; @p velocity 1 to 127, fractions allowed, is clamped. AUDIO. */
double midi_speed(MidiCurve curve, double velocity) REALTIME;

#endif
