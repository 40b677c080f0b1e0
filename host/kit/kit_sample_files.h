/* SPDX-License-Identifier: MIT */
/**
 * @file kit_sample_files.h
 * Sound files that stand for what a kit does not model: hi-hat, cymbals, hand percussion. A section of a kit file,
 *
 *     [note.42]
 *     sample = hat.wav    ; beside the kit file; mono or stereo, at the rate at which the kit is played
 *     gain = -6           ; dB, -120 to 24
 *     choke = 1           ; 0 (none) to 15: a stroke fades others of the same group within 15 ms
 *
 * plays the file at each stroke on the note, (velocity/127)^2 as loud, and fades it when its key is pressed. Samples are added to the mix; no drum hears them, and
 * the room does not.
 */
#ifndef TABOR_HOST_KIT_SAMPLE_FILES_H
#define TABOR_HOST_KIT_SAMPLE_FILES_H

#include <tabor/kit.h>

#include "base/message.h"
#include "sound/kit_samples.h"

/** Initialises without samples. */
void kit_samples_begin(KitSamples *samples);
/** Says for each note whether it has a sample. */
void kit_samples_map(const TaborKitDef *def, bool has_sample[MIDI_VALUES]);
/** Reads the files of a kit into *samples, which has none, for @p rate [Hz]. */
Outcome kit_samples_load(KitSamples *samples, const TaborKitDef *def, double rate);
void kit_samples_free(KitSamples *samples);

#endif
