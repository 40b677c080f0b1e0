/* SPDX-License-Identifier: MIT */
#include "files/sound_files.h"

#include <string.h>

Outcome sound_files_open(SoundFiles *sounds, const AudioFormat *format, OutputFile *outputs,
                         uint32_t count) {
  sounds->count = count;
  sounds->channels = format->channels;
  Outcome outcome = OUTCOME_OK;
  for (uint32_t i = 0; i < count && outcome == OUTCOME_OK; i++) {
    outcome = audio_file_open(&sounds->files[i], format, &outputs[i]);
  }
  return outcome;
}

static Outcome write_file(SoundFiles *sounds, uint32_t file, const double *samples,
                          uint32_t frames) {
  const uint32_t channels = sounds->channels, all = channels * sounds->count;
  double part[TABOR_MAX_MICS * AUDIO_BLOCK];
  for (uint32_t i = 0; i < frames; i++) {
    memcpy(part + (size_t)i * channels, samples + (size_t)i * all + (size_t)file * channels,
           channels * sizeof *part);
  }
  return audio_file_write(&sounds->files[file], part, frames);
}

Outcome sound_files_write(SoundFiles *sounds, const double *samples, uint32_t frames) {
  if (sounds->count == 1) return audio_file_write(&sounds->files[0], samples, frames);
  Outcome outcome = OUTCOME_OK;
  for (uint32_t i = 0; i < sounds->count && outcome == OUTCOME_OK; i++) {
    outcome = write_file(sounds, i, samples, frames);
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
