/* SPDX-License-Identifier: MIT */
#include "sound/recording.h"

#include <stdlib.h>
#include <string.h>

#define SECONDS 10.0 /* that the disk may keep a recording waiting */

static size_t block_size(const Recording *recording) {
  return sizeof(RecordingBlock) + (size_t)RECORDING_BLOCK * recording->channels * sizeof(double);
}

bool recording_begin(Recording *recording, uint32_t channels, double rate) {
  recording->channels = channels;
  recording->filled = calloc(1, block_size(recording));
  return recording->filled && spsc_queue_create(&recording->queue, block_size(recording),
                                                (size_t)(SECONDS * rate / RECORDING_BLOCK));
}

void recording_end(Recording *recording) {
  spsc_queue_destroy(&recording->queue);
  free(recording->filled);
}

void recording_hand_over(Recording *recording) {
  RecordingBlock *const block = recording->filled;
  if (recording->channels == 0 || block->frames == 0) return;
  if (!spsc_queue_push(&recording->queue, block)) {
    atomic_fetch_add_explicit(&recording->lost, block->frames, memory_order_relaxed);
  }
  block->frames = 0;
}

void recording_add(Recording *recording, uint64_t position, const double *samples) {
  RecordingBlock *const block = recording->filled;
  const uint32_t channels = recording->channels;
  if (channels == 0) return;
  if (block->frames == 0) block->frame = position;
  memcpy(block->samples + (size_t)block->frames * channels, samples, channels * sizeof *samples);
  if (++block->frames == RECORDING_BLOCK) recording_hand_over(recording);
}

const RecordingBlock *recording_peek(const Recording *recording) {
  return spsc_queue_peek(&recording->queue);
}

void recording_pop(Recording *recording) { spsc_queue_pop(&recording->queue); }

bool recording_has_room(const Recording *recording, uint32_t frames) {
  const size_t blocks = frames / RECORDING_BLOCK + 2;
  return recording->channels == 0 ||
         recording->queue.capacity - spsc_queue_count(&recording->queue) >= blocks;
}
