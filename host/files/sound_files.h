/* SPDX-License-Identifier: MIT */
/**
 * @file sound_files.h
 * The sound files of a rendering: one with all channels, or with --split one per channel.
 */
#ifndef TABOR_HOST_SOUND_FILES_H
#define TABOR_HOST_SOUND_FILES_H

#include "files/audio_file.h"

/** Files being written to open OutputFiles, which it does not own. Must not be moved or copied. */
typedef struct SoundFiles {
  AudioFile files[TABOR_MAX_MICS];
  uint32_t count;
} SoundFiles;

/** Starts @p count files of one format. Free with sound_files_free(), whatever the outcome. */
Outcome sound_files_open(SoundFiles *sounds, const AudioFormat *format, OutputFile *outputs,
                         uint32_t count);
/** Appends at most AUDIO_BLOCK frames, interleaved: all channels of one file, or one channel per file. */
Outcome sound_files_write(SoundFiles *sounds, const double *samples, uint32_t frames);
/** Completes and checks all files. */
Outcome sound_files_finish(SoundFiles *sounds);
void sound_files_free(SoundFiles *sounds);

#endif
