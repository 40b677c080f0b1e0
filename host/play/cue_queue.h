/* SPDX-License-Identifier: MIT */
/**
 * @file cue_queue.h
 * Scheduled messages and preset changes, fed to a player in time.
 */
#ifndef TABOR_HOST_CUE_QUEUE_H
#define TABOR_HOST_CUE_QUEUE_H

#include "play/model_builder.h"
#include "strokes/strokes.h"

/** A scheduled message or preset change; its frame is message.frame. */
typedef struct Cue {
  PlayerMessage message;
  const char *preset; /**< if not NULL, change to this preset and ignore the message; not copied */
} Cue;

/** Initialise with {0}. */
typedef struct CueQueue {
  Cue *cues;
  size_t count, capacity;
  size_t next; /**< index of the next cue to feed */
} CueQueue;

/** Appends a cue. */
Outcome cue_queue_add(CueQueue *queue, const Cue *cue);
/** Appends strokes. */
Outcome cue_queue_add_strokes(CueQueue *queue, const Strokes *strokes);
/** Sorts the cues by frame; cues of one frame keep their order. */
void cue_queue_sort(CueQueue *queue);
/** Frame of the last cue; 0 without any. */
uint64_t cue_queue_last_frame(const CueQueue *queue);
/** Frame of the last cue that is not a release. */
uint64_t cue_queue_last_stroke(const CueQueue *queue);
void cue_queue_free(CueQueue *queue);

/** Sends the cues before frame @p until, as long as the player has room. */
void cue_queue_feed(CueQueue *queue, Player *player, ModelBuilder *builder, uint64_t until);

#endif
