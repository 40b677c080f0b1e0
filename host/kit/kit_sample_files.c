/* SPDX-License-Identifier: MIT */
#include "kit/kit_sample_files.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "files/audio_clip.h"

#define FADE_TIME 0.015 /* [s], as of a drum's silence */

void kit_samples_begin(KitSamples *samples) { memset(samples, 0, sizeof *samples); }

void kit_samples_map(const TaborKitDef *def, bool has_sample[MIDI_VALUES]) {
  for (int note = 0; note < MIDI_VALUES; note++) has_sample[note] = def->note[note].sample[0] != 0;
}

static Outcome read_side(const TaborKitNoteDef *note, uint32_t channel, double rate,
                         KitSample *sample, AudioClip *clip) {
  const AudioClipPart whole = {channel, 0, INFINITY};
  const Outcome outcome = audio_clip_read(note->sample, &whole, clip);
  if (outcome != OUTCOME_OK) return outcome;
  if (clip->rate != rate) {
    return refuse("'%s': its rate is %u Hz, that of the kit %.10g Hz; --rate %u fits", note->sample,
                  (unsigned)clip->rate, rate, (unsigned)clip->rate);
  }
  float *const sound = calloc(clip->count + 1, sizeof *sound);
  if (!sound) return fail_memory();
  const double gain = pow(10, note->gain / 20);
  for (size_t i = 0; i < clip->count; i++) sound[i] = (float)(gain * clip->samples[i]);
  sample->sound[channel - 1] = sound;
  sample->frames = (uint32_t)clip->count;
  return OUTCOME_OK;
}

static Outcome read_sample(const TaborKitNoteDef *note, double rate, KitSample *sample) {
  AudioClip clip = {0};
  Outcome outcome = read_side(note, 1, rate, sample, &clip);
  const uint32_t channels = clip.channels;
  audio_clip_free(&clip);
  if (outcome != OUTCOME_OK || channels < 2) return outcome;
  outcome = read_side(note, 2, rate, sample, &clip);
  audio_clip_free(&clip);
  return outcome;
}

Outcome kit_samples_load(KitSamples *samples, const TaborKitDef *def, double rate) {
  Outcome outcome = OUTCOME_OK;
  samples->fade = (uint32_t)(FADE_TIME * rate);
  for (int note = 0; note < MIDI_VALUES && outcome == OUTCOME_OK; note++) {
    KitSample *const sample = &samples->notes[note];
    sample->choke = def->note[note].choke;
    if (def->note[note].sample[0]) outcome = read_sample(&def->note[note], rate, sample);
  }
  return outcome;
}

void kit_samples_free(KitSamples *samples) {
  for (int note = 0; note < MIDI_VALUES; note++) {
    free(samples->notes[note].sound[0]);
    free(samples->notes[note].sound[1]);
  }
  kit_samples_begin(samples);
}
