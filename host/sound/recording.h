/* SPDX-License-Identifier: MIT */
/**
 * @file recording.h
 * What is played, on its way from the audio thread to the thread that writes it (take_writer.h):
 * blocks in a queue. What the disk is too slow for is left out and counted. A recording of zeros
 * records nothing.
 */
#ifndef TABOR_HOST_RECORDING_H
#define TABOR_HOST_RECORDING_H

#include <stdint.h>

#include "base/spsc_queue.h"

#define RECORDING_BLOCK 256 /**< frames of a block */

/** RECORDING_BLOCK frames, fewer only at the end. */
typedef struct RecordingBlock {
  uint64_t frame; /**< of the first */
  uint32_t frames;
  double samples[]; /**< interleaved channels */
} RecordingBlock;

typedef struct Recording {
  uint32_t channels; /**< 0: nothing is recorded */
  SpscQueue queue;
  RecordingBlock *filled; /**< the block being filled */
  atomic_ullong lost;     /**< frames */
} Recording;

/* SET-UP */

/** @p rate: sample rate [Hz]. False if memory is short; recording_end() is due all the same. */
bool recording_begin(Recording *recording, uint32_t channels, double rate);
void recording_end(Recording *recording);

/* AUDIO */

/** Adds frame number @p position, a sample for each channel. */
void recording_add(Recording *recording, uint64_t position, const double *samples) REALTIME;
/** Hands over what is left, at the end. */
void recording_hand_over(Recording *recording) REALTIME;

/* THE WRITING THREAD */

/** Returns the next block, valid until recording_pop(); NULL if there is none yet. */
const RecordingBlock *recording_peek(const Recording *recording);
void recording_pop(Recording *recording);

/* ANY */

/** True if there is room for @p frames more frames. */
bool recording_has_room(const Recording *recording, uint32_t frames);

#endif
