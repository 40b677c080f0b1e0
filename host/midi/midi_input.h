/* SPDX-License-Identifier: MIT */
/**
 * @file midi_input.h
 * Live MIDI: every input that is wanted, those too that are plugged in later, and one of our own in
 * every interface, to which other programs may connect.
 *
 * Each input hands its messages over on a thread of RtMidi's, which puts them into a queue; one thread of
 * ours passes them on in turn. Another looks every second for what came and went. More than a person can
 * play, 1000 messages a second after the first 64, is dropped and counted: it would cost the sound.
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

/** Takes a message that was played at @p time [s of CLOCK_MONOTONIC]. Called on one thread. */
typedef void MidiInputFn(void *context, double time, const MidiMessage *message);

/** What came in. */
typedef struct MidiInputStatus {
  unsigned inputs;            /**< open, without our own */
  unsigned own;               /**< of our own */
  unsigned long long taken;   /**< messages passed on */
  unsigned long long dropped; /**< messages that were too many */
} MidiInputStatus;

/**
 * Opens the inputs that have @p wanted in their names, or if that is NULL those of hardware. None is no
 * failure: one may come. Says what it opens and what goes unless @p quiet. *input is NULL on a failure.
 */
Outcome midi_input_open(const char *wanted, bool quiet, MidiInputFn *receive, void *context,
                        MidiInput **input);
void midi_input_status(const MidiInput *input, MidiInputStatus *status);
/** No message comes any more. An interface that does not let go within a second is left as it is. NULL
 * is allowed. */
void midi_input_close(MidiInput *input);

#endif
