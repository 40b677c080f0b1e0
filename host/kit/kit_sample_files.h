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

#include "base/message.h"
#include "sound/kit_samples.h"

/** Who reads the samples of a kit file. */
typedef struct KitSampleReader {
  const char *file; /**< beside which they lie */
  KitSamples *samples;
} KitSampleReader;

/** Initialises without samples. */
void kit_samples_begin(KitSamples *samples);
/**
 * Takes a line of section "note.N" of the kit file @p file; @p key is NULL for the section itself. False, with one line in
 * @p message, if it is not understood.
 */
bool kit_samples_set(KitSamples *samples, const char *file, const char *section, const char *key,
                     const char *value, char *message, size_t size);
/** kit_samples_set() as a PresetPairFn, whose context is a KitSampleReader. */
bool kit_samples_take_pair(void *reader, const char *section, const char *key, const char *value,
                           unsigned line, char *message, size_t size);
/** What a kit file says of @p samples, wherever that file will be: paths from the root. Free with kit_samples_free(). */
KitSamples kit_samples_from_root(const KitSamples *samples);
/** Says for each note whether it has a sample. */
void kit_samples_map(const KitSamples *samples, bool has_sample[MIDI_VALUES]);
/** Reads the files, for @p rate [Hz]. */
Outcome kit_samples_load(KitSamples *samples, double rate);
void kit_samples_free(KitSamples *samples);

#endif
