/* SPDX-License-Identifier: MIT */
#include "kit/kit_sample_files.h"

#include <math.h>
#include <stdlib.h>

#include "files/audio_clip.h"

static Outcome read_side(const char *name, uint32_t channel, KitSound *sound, uint32_t *channels) {
  const AudioClipPart whole = {channel, 0, INFINITY};
  AudioClip clip = {0};
  const Outcome outcome = audio_clip_read(name, &whole, &clip);
  float *const side = outcome == OUTCOME_OK ? calloc(clip.count + 1, sizeof *side) : NULL;
  for (size_t i = 0; side && i < clip.count; i++) side[i] = (float)clip.samples[i];
  sound->side[channel - 1] = side;
  sound->frames = (uint32_t)clip.count;
  sound->rate = clip.rate;
  *channels = clip.channels;
  audio_clip_free(&clip);
  return outcome != OUTCOME_OK || side ? outcome : fail_memory();
}

/* A KitSoundFn, whose context is what became of it. */
static bool read_sound(void *context, const char *name, KitSound *sound) {
  Outcome *const outcome = context;
  uint32_t channels = 0;
  *outcome = read_side(name, 1, sound, &channels);
  if (*outcome == OUTCOME_OK && channels > 1) *outcome = read_side(name, 2, sound, &channels);
  return *outcome == OUTCOME_OK;
}

Outcome kit_sample_files_read(TaborKit *kit) {
  Outcome outcome = OUTCOME_OK;
  TaborError error;
  const TaborStatus status = kit_samples_load(kit, read_sound, &outcome, &error);
  return status == TABOR_OK || outcome != OUTCOME_OK ? outcome : report_engine_error(&error);
}
