/* SPDX-License-Identifier: MIT */
#include "sound/leaving.h"

#include <string.h>

void leaving_begin(Leaving *leaving, double rate) {
  leaving->count = 0;
  leaving->length = (uint32_t)(LEAVING_TIME * rate);
}

static TaborDrum *take_oldest(Leaving *leaving) {
  TaborDrum *const drum = leaving->drums[0].drum;
  leaving->count--;
  memmove(leaving->drums, leaving->drums + 1, leaving->count * sizeof *leaving->drums);
  return drum;
}

TaborDrum *leaving_add(Leaving *leaving, TaborDrum *drum, const uint32_t *mics, uint32_t channels) {
  if (tabor_drum_is_silent(drum)) return drum;
  TaborDrum *const cut = leaving->count == LEAVING_MOST ? take_oldest(leaving) : NULL;
  LeavingDrum *const added = &leaving->drums[leaving->count++];
  added->drum = drum;
  added->left = leaving->length;
  memcpy(added->mics, mics, channels * sizeof *mics);
  return cut;
}

/* ---- sound ---------------------------------------------------------------------------------- */

static void add_channel(const Leaving *leaving, const LeavingDrum *drum, uint32_t mic,
                        double *sound, uint32_t frames) {
  const float *const samples = leaving->planar[mic];
  for (uint32_t i = 0; i < frames; i++) {
    sound[i] += (drum->left - i) / (leaving->length + 1.0) * (double)samples[i];
  }
}

static void play_one(Leaving *leaving, LeavingDrum *drum, double *const *sound, uint32_t channels,
                     uint32_t most) {
  float *planar[TABOR_MAX_MICS] = {NULL}; /* for microphones that nobody hears */
  const uint32_t frames = drum->left < most ? drum->left : most;
  for (uint32_t i = 0; i < channels; i++) {
    const uint32_t mic = drum->mics[i];
    if (sound[i] && mic != LEAVING_NO_MIC) planar[mic] = leaving->planar[mic];
  }
  tabor_drum_process(drum->drum, NULL, 0, planar, frames);
  for (uint32_t i = 0; i < channels; i++) {
    const uint32_t mic = drum->mics[i];
    if (sound[i] && mic != LEAVING_NO_MIC) add_channel(leaving, drum, mic, sound[i], frames);
  }
  drum->left -= frames;
}

void leaving_play(Leaving *leaving, double *const *sound, uint32_t channels, uint32_t frames) {
  for (uint32_t i = 0; i < leaving->count; i++) {
    play_one(leaving, &leaving->drums[i], sound, channels, frames);
  }
}

void leaving_join(Leaving *leaving, const float *const *samples, double *const *sound,
                  uint32_t channels, uint32_t frames) {
  for (uint32_t channel = 0; channel < channels; channel++) {
    for (uint32_t i = 0; i < frames; i++) sound[channel][i] = (double)samples[channel][i];
  }
  leaving_play(leaving, sound, channels, frames);
}

void leaving_cut(Leaving *leaving) {
  for (uint32_t i = 0; i < leaving->count; i++) leaving->drums[i].left = 0;
}

TaborDrum *leaving_take(Leaving *leaving) {
  return leaving->count > 0 && leaving->drums[0].left == 0 ? take_oldest(leaving) : NULL;
}
