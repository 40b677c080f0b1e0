/* SPDX-License-Identifier: MIT */
/**
 * @file play_midi.h
 * Live MIDI for a drum or a kit that is played: sends each received message to the player at its
 * frame.
 */
#ifndef TABOR_HOST_PLAY_MIDI_H
#define TABOR_HOST_PLAY_MIDI_H

#include "midi/midi_input.h"
#include "play/cue_queue.h"
#include "play/model_builder.h"
#include "play/play_request.h"

typedef struct PlayMidi PlayMidi;

/** Opens the inputs that @p request asks for. @p builders are those of the kit's drums, or of the
 * drum. *midi is valid or NULL, whatever the outcome. */
Outcome play_midi_open(const PlayRequest *request, Player *player, ModelBuilder *const *builders,
                       PlayMidi **midi);
void play_midi_status(const PlayMidi *midi, MidiInputStatus *status);
/** Number of received notes that are not in the map. @p midi may be NULL. */
uint64_t play_midi_ignored(const PlayMidi *midi);
/** Lets the next controller that moves be that of @p target, which midi_control_read() has read, on
 * drum @p drum of a kit; NULL: none is learned. User's thread. */
void play_midi_learn(PlayMidi *midi, uint32_t drum, const MidiControl *target);
/** The controller that has been learned since the last call, or -1. User's thread. @p midi may be
 * NULL. */
int play_midi_learned(PlayMidi *midi);
/** Closes the inputs. Call before the builder and the player are destroyed. NULL is allowed. */
void play_midi_close(PlayMidi *midi);

/** Converts a MIDI action to a cue at @p frame. */
Cue play_midi_cue(const MidiAction *action, uint64_t frame);

#endif
