/* SPDX-License-Identifier: MIT */
#include "kit/kit_sample_files.h"

#include <math.h>
#include <stdlib.h>

#include "files/audio_clip.h"

void kit_samples_map(const TaborKitDef *def, bool has_sample[MIDI_VALUES]) {
  for (int note = 0; note < MIDI_VALUES; note++) has_sample[note] = def->note[note].sample[0] != 0;
}

/* A stereo sound. */
typedef struct Sound {
  float *side[2]; /* the second one NULL if it is mono */
  uint32_t frames;
  double rate;
} Sound;

static Outcome read_side(const char *name, uint32_t channel, Sound *sound, uint32_t *channels) {
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

static Outcome read_sound(const char *name, Sound *sound) {
  uint32_t channels = 0;
  const Outcome outcome = read_side(name, 1, sound, &channels);
  return outcome == OUTCOME_OK && channels > 1 ? read_side(name, 2, sound, &channels) : outcome;
}

static Outcome load(TaborKit *kit, uint32_t note, const char *name) {
  Sound sound = {{NULL, NULL}, 0, 0};
  TaborError error;
  Outcome outcome = read_sound(name, &sound);
  if (outcome == OUTCOME_OK && tabor_kit_set_sample(kit, note, sound.side[0], sound.side[1],
                                                    sound.frames, sound.rate, &error) != TABOR_OK) {
    outcome = refuse("'%s': %s", name, error.message);
  }
  free(sound.side[0]);
  free(sound.side[1]);
  return outcome;
}

Outcome kit_samples_load(TaborKit *kit) {
  const TaborKitDef *const def = tabor_kit_definition(kit);
  Outcome outcome = OUTCOME_OK;
  for (uint32_t note = 0; note < TABOR_KIT_NOTES && outcome == OUTCOME_OK; note++) {
    const char *const name = def->note[note].sample;
    if (*name) outcome = load(kit, note, name);
  }
  return outcome;
}
