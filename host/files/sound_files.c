/* SPDX-License-Identifier: MIT */
#include "files/sound_files.h"

Outcome sound_files_open(SoundFiles *sounds, const AudioFormat *format, OutputFile *outputs,
                         uint32_t count) {
  sounds->count = count;
  Outcome outcome = OUTCOME_OK;
  for (uint32_t i = 0; i < count && outcome == OUTCOME_OK; i++) {
    outcome = audio_file_open(&sounds->files[i], format, &outputs[i]);
  }
  return outcome;
}

static Outcome write_channel(SoundFiles *sounds, uint32_t channel, const double *samples,
                             uint32_t frames) {
  double single[AUDIO_BLOCK];
  for (uint32_t i = 0; i < frames; i++) single[i] = samples[i * sounds->count + channel];
  return audio_file_write(&sounds->files[channel], single, frames);
}

Outcome sound_files_write(SoundFiles *sounds, const double *samples, uint32_t frames) {
  if (sounds->count == 1) return audio_file_write(&sounds->files[0], samples, frames);
  Outcome outcome = OUTCOME_OK;
  for (uint32_t i = 0; i < sounds->count && outcome == OUTCOME_OK; i++) {
    outcome = write_channel(sounds, i, samples, frames);
  }
  return outcome;
}

Outcome sound_files_finish(SoundFiles *sounds) {
  Outcome outcome = OUTCOME_OK;
  for (uint32_t i = 0; i < sounds->count && outcome == OUTCOME_OK; i++) {
    outcome = audio_file_finish(&sounds->files[i]);
  }
  return outcome;
}

void sound_files_free(SoundFiles *sounds) {
  for (uint32_t i = 0; i < sounds->count; i++) audio_file_free(&sounds->files[i]);
}
