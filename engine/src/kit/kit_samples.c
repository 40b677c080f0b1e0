/* SPDX-License-Identifier: MIT */
#include "kit/kit_samples.h"

#include <string.h>

#include "kit/kit.h"
#include "math/resample.h"

/* ---- set-up ---------------------------------------------------------------------------------- */

static float *convert(const float *sound, uint32_t frames, double ratio, double gain,
                      uint32_t length, const TaborAllocator *allocator) {
  float *const converted = allocator->allocate((length + 1u) * sizeof(float), allocator->context);
  if (!converted) return NULL;
  if (!tb_resample(sound, frames, ratio, converted, length)) {
    allocator->release(converted, allocator->context);
    return NULL;
  }
  for (uint32_t i = 0; i < length; i++) converted[i] = (float)(gain * (double)converted[i]);
  return converted;
}

static void free_sample(TbKitSample *sample, const TaborAllocator *allocator) {
  for (int side = 0; side < 2; side++) {
    if (sample->sound[side]) allocator->release(sample->sound[side], allocator->context);
  }
  *sample = (TbKitSample){.frames = 0};
}

bool tb_kit_sample_set(TbKitSample *sample, const TaborKitNoteDef *def, const float *left,
                       const float *right, uint32_t frames, double from, double to,
                       const TaborAllocator *allocator) {
  const double ratio = to / from, gain = tb_kit_factor(def->gain);
  const uint32_t length = tb_resampled_length(frames, ratio);
  TbKitSample made = {.frames = length, .choke = def->choke};
  made.sound[0] = convert(left, frames, ratio, gain, length, allocator);
  if (right) made.sound[1] = convert(right, frames, ratio, gain, length, allocator);
  if (!made.sound[0] || (right && !made.sound[1])) {
    free_sample(&made, allocator);
    return false;
  }
  free_sample(sample, allocator);
  *sample = made;
  return true;
}

void tb_kit_samples_free(TbKitSamples *samples, const TaborAllocator *allocator) {
  for (uint32_t note = 0; note < TABOR_KIT_NOTES; note++) {
    free_sample(&samples->notes[note], allocator);
  }
}

/* ---- strokes --------------------------------------------------------------------------------- */

void tb_kit_samples_reset(TbKitSamples *samples) {
  memset(&samples->shots, 0, sizeof samples->shots);
  for (uint32_t i = 0; i < TB_KIT_SHOTS; i++) samples->shots.list[i].note = TABOR_KIT_NOTES;
  tb_live_move(&samples->shots.gain, 1.0, 0);
}

static void fade(const TbKitSamples *samples, TbKitShot *shot, uint32_t offset) {
  if (shot->note == TABOR_KIT_NOTES || shot->fades) return;
  shot->fades = 1;
  shot->hold = offset;
  shot->left = samples->fade;
}

static void choke(TbKitSamples *samples, uint32_t note, bool itself, uint32_t offset) {
  const uint32_t group = samples->notes[note].choke;
  for (uint32_t i = 0; i < TB_KIT_SHOTS; i++) {
    TbKitShot *const shot = &samples->shots.list[i];
    if (shot->note == TABOR_KIT_NOTES) continue;
    const bool is_in_group = group != 0 && samples->notes[shot->note].choke == group;
    if (is_in_group || (itself && shot->note == note)) fade(samples, shot, offset);
  }
}

void tb_kit_samples_silence(TbKitSamples *samples, uint32_t offset) {
  for (uint32_t i = 0; i < TB_KIT_SHOTS; i++) fade(samples, &samples->shots.list[i], offset);
}

static TbKitShot *free_shot(TbKitShots *shots) {
  for (uint32_t i = 0; i < TB_KIT_SHOTS; i++) {
    if (shots->list[i].note == TABOR_KIT_NOTES) return &shots->list[i];
  }
  shots->oldest = (shots->oldest + 1) % TB_KIT_SHOTS;
  return &shots->list[shots->oldest];
}

static double within(double strength) {
  if (!(strength > 0.0)) return 0.0;
  return strength < 1.0 ? strength : 1.0;
}

bool tb_kit_samples_act(TbKitSamples *samples, uint32_t note, const TaborEvent *event,
                        uint32_t offset) {
  const bool strikes = event->type == TABOR_EVENT_STRIKE;
  if (!samples->notes[note].sound[0]) return false;
  if (!strikes && event->type != TABOR_EVENT_SILENCE) return false;
  choke(samples, note, !strikes, offset);
  if (!strikes) return true;
  const double strength = within(event->velocity);
  *free_shot(&samples->shots) =
    (TbKitShot){.note = note, .wait = offset, .gain = (float)(strength * strength)};
  return true;
}

/* ---- sound ----------------------------------------------------------------------------------- */

static float next_gain(TbKitShot *shot, uint32_t whole) {
  if (!shot->fades) return shot->gain;
  if (shot->hold > 0) {
    shot->hold--;
    return shot->gain;
  }
  shot->left--;
  return shot->gain * (float)shot->left / (float)whole;
}

static void add_shot(const TbKitSamples *samples, TbKitShot *shot, const float *gains, float *left,
                     float *right, uint32_t frames) {
  const TbKitSample *const sample = &samples->notes[shot->note];
  const float *const other = sample->sound[1] ? sample->sound[1] : sample->sound[0];
  const uint32_t from = shot->wait < frames ? shot->wait : frames;
  shot->wait -= from;
  shot->hold -= from < shot->hold ? from : shot->hold;
  for (uint32_t i = from; i < frames; i++) {
    const bool ends = shot->position == sample->frames || (shot->fades && shot->left == 0);
    if (ends) {
      shot->note = TABOR_KIT_NOTES;
      return;
    }
    const float gain = next_gain(shot, samples->fade) * gains[i];
    left[i] += gain * sample->sound[0][shot->position];
    right[i] += gain * other[shot->position++];
  }
}

void tb_kit_samples_add(TbKitSamples *samples, const float *gains, float *left, float *right,
                        uint32_t frames) {
  for (uint32_t i = 0; i < TB_KIT_SHOTS; i++) {
    TbKitShot *const shot = &samples->shots.list[i];
    if (shot->note != TABOR_KIT_NOTES) add_shot(samples, shot, gains, left, right, frames);
  }
}

uint32_t tb_kit_shots_count(const TbKitShots *shots) {
  uint32_t count = 0;
  for (uint32_t i = 0; i < TB_KIT_SHOTS; i++) count += shots->list[i].note != TABOR_KIT_NOTES;
  return count;
}

bool tb_kit_shots_fit(const TbKitShots *shots, const TbKitSamples *samples) {
  bool fits = shots->oldest < TB_KIT_SHOTS && tb_live_is_gain(&shots->gain);
  for (uint32_t i = 0; i < TB_KIT_SHOTS; i++) {
    const TbKitShot *const shot = &shots->list[i];
    if (shot->note == TABOR_KIT_NOTES) continue;
    fits &= shot->note < TABOR_KIT_NOTES && shot->gain >= 0.0f && shot->gain <= 1.0f;
    fits = fits && samples->notes[shot->note].sound[0] &&
           shot->position <= samples->notes[shot->note].frames && shot->left <= samples->fade &&
           shot->wait <= TB_KIT_PIECE && shot->hold <= TB_KIT_PIECE;
  }
  return fits;
}
