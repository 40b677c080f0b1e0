/* SPDX-License-Identifier: MIT */
/**
 * @file kit_samples.h
 * Plays the sound files that stand for what a kit does not model (kit/kit_sample_files.h). Samples are added to the mix; no
 * drum hears them, and the room does not. All functions are real-time safe.
 */
#ifndef TABOR_HOST_KIT_SAMPLES_H
#define TABOR_HOST_KIT_SAMPLES_H

#include <tabor/tabor.h>

#include "base/realtime.h"
#include "midi/midi_stream.h"

/**
 * Address of a note with a sample among the drums of a kit: this and the General MIDI note. The velocity of a stroke is its
 * strength, 0 to 1; TABOR_EVENT_SILENCE chokes the sample.
 */
#define KIT_SAMPLE 0x1000u
#define KIT_SAMPLE_VOICES                                                                          \
  32 /**< sounding at once; a further stroke takes the place of the oldest */

typedef struct KitSample {
  uint32_t choke;
  float *sound[2]; /**< NULL: the note has none; the second one if it is mono */
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

/** A stroke on @p note, which has a sample, @p offset frames into the next block; @p strength 0 to 1. */
void kit_samples_strike(KitSamples *samples, uint32_t note, double strength,
                        uint32_t offset) REALTIME;
/** Fades @p note, and others of its group, from then on. */
void kit_samples_choke(KitSamples *samples, uint32_t note, uint32_t offset) REALTIME;
/** Does what an event of kit_midi.h on @p note asks for: a stroke, or a choke. */
void kit_samples_take(KitSamples *samples, uint32_t note, const TaborEvent *event,
                      uint32_t offset) REALTIME;
/** Adds the next @p frames frames to both sides. */
void kit_samples_add(KitSamples *samples, float *left, float *right, uint32_t frames) REALTIME;
/** True if nothing sounds. */
bool kit_samples_are_silent(const KitSamples *samples) REALTIME;

#endif
