/* SPDX-License-Identifier: MIT */
/**
 * @file kit_samples.h
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
#ifndef TABOR_HOST_KIT_SAMPLES_H
#define TABOR_HOST_KIT_SAMPLES_H

#include <tabor/tabor.h>

#include "base/message.h"
#include "base/realtime.h"
#include "midi/midi_stream.h"

#define KIT_SAMPLE_VOICES                                                                          \
  32 /**< sounding at once; a further stroke takes the place of the oldest */

typedef struct KitSample {
  char *path; /**< NULL: the note has none */
  double gain_db;
  uint32_t choke;
  float *sound[2]; /**< the same for both sides if mono */
  uint32_t frames;
} KitSample;

typedef struct KitSampleVoice {
  const KitSample *sample; /**< NULL: free */
  uint32_t position;
  uint32_t wait; /**< frames until it begins */
  float gain;
  bool fades;
  uint32_t hold; /**< frames until its fade begins */
  uint32_t left; /**< frames that are left of its fade */
} KitSampleVoice;

typedef struct KitSamples {
  KitSample notes[MIDI_VALUES];
  uint32_t fade; /**< frames of a fade */
  KitSampleVoice voices[KIT_SAMPLE_VOICES];
  uint32_t oldest;
} KitSamples;

/** Initialises without samples. */
void kit_samples_begin(KitSamples *samples);
/**
 * Takes a line of section "note.N" of the kit file @p file; @p key is NULL for the section itself. False, with one line in
 * @p message, if it is not understood.
 */
bool kit_samples_set(KitSamples *samples, const char *file, const char *section, const char *key,
                     const char *value, char *message, size_t size);
/** Reads the files, for @p rate [Hz]. */
Outcome kit_samples_load(KitSamples *samples, double rate);
void kit_samples_free(KitSamples *samples);

/** AUDIO: a stroke on @p note, which has a sample, @p offset frames into the next block; @p strength 0 to 1. */
void kit_samples_strike(KitSamples *samples, uint32_t note, double strength,
                        uint32_t offset) REALTIME;
/** AUDIO: fades @p note, and others of its group, from then on. */
void kit_samples_choke(KitSamples *samples, uint32_t note, uint32_t offset) REALTIME;
/** AUDIO: does what an event of kit_midi.h on @p note asks for: a stroke, or a choke. */
void kit_samples_take(KitSamples *samples, uint32_t note, const TaborEvent *event,
                      uint32_t offset) REALTIME;
/** AUDIO: adds the next @p frames frames to both sides. */
void kit_samples_add(KitSamples *samples, float *left, float *right, uint32_t frames) REALTIME;
/** True if nothing sounds. */
bool kit_samples_are_silent(const KitSamples *samples) REALTIME;

#endif
