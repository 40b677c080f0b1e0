/* SPDX-License-Identifier: MIT */
/**
 * @file midi_clock.h
 * Estimates when a MIDI message was played from the time of its delivery.
 *
 * A port reports the time between consecutive messages, by its own clock. The thread that delivers
 * the messages is late by a varying amount. So the time of a message is the port's time plus a
 * shift, the smallest difference between time of delivery and port time seen so far. The shift may
 * grow by one part in a thousand, because the clocks differ.
 */
#ifndef TABOR_HOST_MIDI_CLOCK_H
#define TABOR_HOST_MIDI_CLOCK_H

#include <stdbool.h>

/** The clock of one port. All members zero is the initial state. */
typedef struct MidiClock {
  double port;  /**< port time: the sum of the reported differences [s] */
  double shift; /**< from port time to the time of delivery [s] */
  bool is_running;
} MidiClock;

/** Time of a message that came @p later [s] after the previous one and is delivered at @p now [s].
 */
double midi_clock_take(MidiClock *clock, double later, double now);

#endif
