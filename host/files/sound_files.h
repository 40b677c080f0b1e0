/* SPDX-License-Identifier: MIT */
/**
 * @file sound_files.h
 * The sound files of a rendering: one with all channels, or with --split one for each microphone or
 * each drum of a kit.
 */
#ifndef TABOR_HOST_SOUND_FILES_H
#define TABOR_HOST_SOUND_FILES_H

#include "files/audio_file.h"

#define SOUND_FILES_MOST 16 /**< as many as microphones of a drum, or drums of a kit, at most */

/** Files being written to open OutputFiles, which it does not own. Must not be moved or copied. */
typedef struct SoundFiles {
  AudioFile files[SOUND_FILES_MOST];
  uint32_t count, channels; /**< of each file */
} SoundFiles;

/** Starts @p count files of one format. Free with sound_files_free(), whatever the outcome. */
Outcome sound_files_open(SoundFiles *sounds, const AudioFormat *format, OutputFile *outputs,
                         uint32_t count);
/** Appends at most AUDIO_BLOCK frames, interleaved: all channels of the first file, then those of
 * the next. */
Outcome sound_files_write(SoundFiles *sounds, const double *samples, uint32_t frames);
/** Completes and checks all files. */
Outcome sound_files_finish(SoundFiles *sounds);
void sound_files_free(SoundFiles *sounds);

#endif
