/* SPDX-License-Identifier: MIT */
/**
 * @file audio_clip.h
 * A part of one channel of a sound file, in memory.
 */
#ifndef TABOR_HOST_RECORDING_H
#define TABOR_HOST_RECORDING_H

#include <stddef.h>

#include "base/message.h"

#define RECORDING_LONGEST 120.0 /**< seconds that are taken at most */

/** What to take of a sound file. */
typedef struct RecordingPart {
  uint32_t channel; /**< from 1 */
  double from, to;  /**< [s]; infinite: the file's end */
} RecordingPart;

typedef struct Recording {
  uint32_t rate, channels; /**< of the file */
  uint64_t frames;         /**< of the file */
  double *samples;         /**< of the part, 1.0 = full scale */
  size_t count, capacity;
} Recording;

/** Reads any file that libsndfile knows; "-" is the standard input. Free with recording_free(). */
Outcome recording_read(const char *name, const RecordingPart *part, Recording *recording);
void recording_free(Recording *recording);

#endif
