/* SPDX-License-Identifier: MIT */
/**
 * @file midi_clock.h
 * When a MIDI message was played, as well as can be known from when it was handed over.
 *
 * A port tells how much later each message came than the one before, by a clock of its own; the thread
 * that hands messages over is late by more or less. So the time of a message is the port's, shifted by the
 * least lateness that was seen; this shift may grow by one part in a thousand, as clocks differ.
 */
#ifndef TABOR_HOST_MIDI_CLOCK_H
#define TABOR_HOST_MIDI_CLOCK_H

#include <stdbool.h>

/** A port's. All zero is its beginning. */
typedef struct MidiClock {
  double port;  /**< its time: the sum of what it told [s] */
  double shift; /**< from that to the time of ours [s] */
  bool is_running;
} MidiClock;

/** The time of a message that came @p later [s] after the one before and is handed over at @p now [s]. */
double midi_clock_take(MidiClock *clock, double later, double now);

#endif
