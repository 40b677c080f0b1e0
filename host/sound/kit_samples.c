/* SPDX-License-Identifier: MIT */
#include "sound/kit_samples.h"

static void fade(KitSamples *samples, KitSampleVoice *voice, uint32_t offset) {
  if (!voice->sample || voice->fades) return;
  voice->fades = true;
  voice->hold = offset;
  voice->left = samples->fade;
}

static void choke(KitSamples *samples, uint32_t group, uint32_t offset) {
  for (uint32_t i = 0; group != 0 && i < KIT_SAMPLE_VOICES; i++) {
    KitSampleVoice *const voice = &samples->voices[i];
    if (voice->sample && voice->sample->choke == group) fade(samples, voice, offset);
  }
}

void kit_samples_choke(KitSamples *samples, uint32_t note, uint32_t offset) {
  const KitSample *const sample = &samples->notes[note];
  choke(samples, sample->choke, offset);
  for (uint32_t i = 0; i < KIT_SAMPLE_VOICES; i++) {
    if (samples->voices[i].sample == sample) fade(samples, &samples->voices[i], offset);
  }
}

static KitSampleVoice *free_voice(KitSamples *samples) {
  for (uint32_t i = 0; i < KIT_SAMPLE_VOICES; i++) {
    if (!samples->voices[i].sample) return &samples->voices[i];
  }
  samples->oldest = (samples->oldest + 1) % KIT_SAMPLE_VOICES;
  return &samples->voices[samples->oldest];
}

void kit_samples_strike(KitSamples *samples, uint32_t note, double strength, uint32_t offset) {
  const KitSample *const sample = &samples->notes[note];
  choke(samples, sample->choke, offset);
  if (!sample->sound[0]) return;
  *free_voice(samples) =
    (KitSampleVoice){.sample = sample, .wait = offset, .gain = (float)(strength * strength)};
}

void kit_samples_take(KitSamples *samples, uint32_t note, const TaborEvent *event,
                      uint32_t offset) {
  if (event->type == TABOR_EVENT_SILENCE) {
    kit_samples_choke(samples, note, offset);
  } else {
    kit_samples_strike(samples, note, event->velocity, offset);
  }
}

static float next_gain(KitSampleVoice *voice, uint32_t whole) {
  if (!voice->fades) return voice->gain;
  if (voice->hold > 0) {
    voice->hold--;
    return voice->gain;
  }
  voice->left--;
  return voice->gain * (float)voice->left / (float)whole;
}

static void add_voice(KitSamples *samples, KitSampleVoice *voice, float *left, float *right,
                      uint32_t frames) {
  const KitSample *const sample = voice->sample;
  const float *const other = sample->sound[1] ? sample->sound[1] : sample->sound[0];
  const uint32_t from = voice->wait < frames ? voice->wait : frames;
  voice->wait -= from;
  voice->hold -= from < voice->hold ? from : voice->hold;
  for (uint32_t i = from; i < frames; i++) {
    const bool ends = voice->position == sample->frames || (voice->fades && voice->left == 0);
    if (ends) {
      voice->sample = NULL;
      return;
    }
    const float gain = next_gain(voice, samples->fade);
    left[i] += gain * sample->sound[0][voice->position];
    right[i] += gain * other[voice->position++];
  }
}

void kit_samples_add(KitSamples *samples, float *left, float *right, uint32_t frames) {
  for (uint32_t i = 0; i < KIT_SAMPLE_VOICES; i++) {
    if (samples->voices[i].sample) add_voice(samples, &samples->voices[i], left, right, frames);
  }
}

bool kit_samples_are_silent(const KitSamples *samples) {
  for (uint32_t i = 0; i < KIT_SAMPLE_VOICES; i++) {
    if (samples->voices[i].sample) return false;
  }
  return true;
}
