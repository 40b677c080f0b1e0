/* SPDX-License-Identifier: MIT */
/**
 * @file midi_input.h
 * Live MIDI: opens all wanted inputs, including those plugged in later, and one virtual input of
 * our own per interface, to which other programs may connect.
 *
 * RtMidi delivers each input's messages on a thread of its own, which puts them into a queue. One
 * thread of ours passes them on in order. Another checks every second for inputs that appeared or
 * disappeared. Messages above 1000 a second after the first 64, more than a person can play, are
 * dropped and counted, because they would disturb the sound.
 */
#ifndef TABOR_HOST_MIDI_INPUT_H
#define TABOR_HOST_MIDI_INPUT_H

#include "base/message.h"
#include "midi/midi_stream.h"

#define OPTION_MIDI_IN                                                                             \
  {                                                                                                \
    "midi-in", 0, "NAME",                                                                          \
      "MIDI inputs with this in their names (default: all hardware); see below"                    \
  }

typedef struct MidiInput MidiInput;

/** Receives a message that was played at @p time [s of CLOCK_MONOTONIC]. Called on one thread. */
typedef void MidiInputFn(void *context, double time, const MidiMessage *message);

/** Numbers of inputs and messages. */
typedef struct MidiInputStatus {
  unsigned inputs;            /**< open inputs without our own */
  unsigned own;               /**< open inputs of our own */
  unsigned long long taken;   /**< messages passed on */
  unsigned long long dropped; /**< messages dropped because of the rate limit */
} MidiInputStatus;

/**
 * Opens the inputs whose names contain @p wanted; NULL: all hardware inputs. Finding none is no
 * failure, because one may appear later. Prints which inputs open and disappear unless @p quiet.
 * *input is NULL on a failure.
 */
Outcome midi_input_open(const char *wanted, bool quiet, MidiInputFn *receive, void *context,
                        MidiInput **input);
void midi_input_status(const MidiInput *input, MidiInputStatus *status);
/** Closes the inputs; no message comes afterwards. An interface that does not close within a second
 * is left open. NULL is allowed. */
void midi_input_close(MidiInput *input);

#endif
