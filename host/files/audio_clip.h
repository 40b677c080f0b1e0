/* SPDX-License-Identifier: MIT */
/**
 * @file audio_clip.h
 * A part of one channel of a sound file, in memory.
 */
#ifndef TABOR_HOST_AUDIO_CLIP_H
#define TABOR_HOST_AUDIO_CLIP_H

#include <stddef.h>

#include "base/message.h"

#define AUDIO_CLIP_LONGEST 120.0 /**< longest part that is read [s] */

/** The part of a sound file to read. */
typedef struct AudioClipPart {
  uint32_t channel; /**< from 1 */
  double from, to;  /**< [s]; infinite: the file's end */
} AudioClipPart;

typedef struct AudioClip {
  uint32_t rate, channels; /**< of the file */
  uint64_t frames;         /**< of the file */
  double *samples;         /**< of the part, 1.0 = full scale */
  size_t count, capacity;
} AudioClip;

/** Reads any file that libsndfile supports; "-" is standard input. Free with audio_clip_free(). */
Outcome audio_clip_read(const char *name, const AudioClipPart *part, AudioClip *clip);
void audio_clip_free(AudioClip *clip);

#endif
