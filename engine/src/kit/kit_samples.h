/* SPDX-License-Identifier: MIT */
/* One shots: the sound files that notes of a kit play. They are added to the mix; no drum hears
 * them, and the room does not. A stroke of strength s is s^2 as loud as the file. Audio-safe but
 * for tb_kit_sample_set() and tb_kit_samples_free(). */
#ifndef TB_KIT_SAMPLES_H
#define TB_KIT_SAMPLES_H

#include "math/arena.h"
#include "state/live_values.h"
#include "tabor/kit.h"

#define TB_KIT_SAMPLE_FADE 0.015 /* [s], as of a drum's silence */
#define TB_KIT_SHOTS 32u /* sounding at once; a further stroke takes the place of the oldest */

typedef struct TbKitSample {
  float *sound[2]; /* [frames]: NULL: the note has none; the second one if it is mono */
  uint32_t frames;
  uint32_t choke; /* group, or 0 */
} TbKitSample;

/* A stroke that sounds. Plain, as it stands in saved states. */
typedef struct TbKitShot {
  uint32_t note; /* TABOR_KIT_NOTES: free */
  uint32_t position;
  uint32_t wait; /* frames until it begins */
  uint32_t fades;
  uint32_t hold; /* frames until its fade begins */
  uint32_t left; /* frames that are left of its fade */
  float gain;
} TbKitShot;

typedef struct TbKitShots {
  TbKitShot list[TB_KIT_SHOTS];
  uint32_t oldest;
  TbLiveParam gain; /* of all: advanced by who plays them */
} TbKitShots;

typedef struct TbKitSamples {
  TbKitSample notes[TABOR_KIT_NOTES];
  uint32_t fade; /* frames of a fade */
  TbKitShots shots;
} TbKitSamples;

/* Gives a note its sound, converted from `from` to `to` [Hz]; `right` may be NULL. False if memory
 * is short. */
bool tb_kit_sample_set(TbKitSample *sample, const TaborKitNoteDef *def, const float *left,
                       const float *right, uint32_t frames, double from, double to,
                       const TaborAllocator *allocator);
void tb_kit_samples_free(TbKitSamples *samples, const TaborAllocator *allocator);

/* Ends all strokes, and sets the gain to 1. */
void tb_kit_samples_reset(TbKitSamples *samples);
/* Does an event of `note`, `offset` frames into the next frames: a stroke of strength `velocity`,
 * or a silence, which fades the note and others of its group. False: it is for no sound. */
bool tb_kit_samples_act(TbKitSamples *samples, uint32_t note, const TaborEvent *event,
                        uint32_t offset);
/* Fades all. */
void tb_kit_samples_silence(TbKitSamples *samples, uint32_t offset);
/* Adds the next `frames` frames to both sides, times `gains` of each. */
void tb_kit_samples_add(TbKitSamples *samples, const float *gains, float *left, float *right,
                        uint32_t frames);
/* Number of those that sound. */
uint32_t tb_kit_shots_count(const TbKitShots *shots);
/* True if a saved state's strokes fit to these sounds. */
bool tb_kit_shots_fit(const TbKitShots *shots, const TbKitSamples *samples);

#endif
