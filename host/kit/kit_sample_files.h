/* SPDX-License-Identifier: MIT */
/**
 * @file kit_sample_files.h
 * Sound files that stand for what a kit does not model: hi-hat, cymbals, hand percussion. A section of a kit file,
 *
 *     [note.42]
 *     sample = hat.wav    ; beside the kit file; mono or stereo
 *     gain = -6           ; dB, -120 to 24
 *     choke = 1           ; 0 (none) to 15: a stroke fades others of the same group within 15 ms
 *
 * plays the file at each stroke on the note, (velocity/127)^2 as loud, and fades it when its key is pressed.
 */
#ifndef TABOR_HOST_KIT_SAMPLE_FILES_H
#define TABOR_HOST_KIT_SAMPLE_FILES_H

#include <tabor/kit.h>

#include "base/message.h"
#include "midi/midi_stream.h"

/** Says for each note whether it has a sample. */
void kit_samples_map(const TaborKitDef *def, bool has_sample[MIDI_VALUES]);
/** Reads the sound files of a kit's definition into the kit, which does not play yet. */
Outcome kit_samples_load(TaborKit *kit);

#endif
