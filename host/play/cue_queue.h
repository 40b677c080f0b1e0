/* SPDX-License-Identifier: MIT */
/**
 * @file cue_queue.h
 * What is known before it happens: messages and changes of the preset, fed to a player in time.
 */
#ifndef TABOR_HOST_CUE_QUEUE_H
#define TABOR_HOST_CUE_QUEUE_H

#include "play/model_builder.h"
#include "strokes/strokes.h"

/** Something that happens at message.frame. */
typedef struct Cue {
  PlayerMessage message;
  const char *preset; /**< not NULL: a change to it, instead of the message; not copied */
} Cue;

/** Begins as {0}. */
typedef struct CueQueue {
  Cue *cues;
  size_t count, capacity;
  size_t next; /**< to feed */
} CueQueue;

/** Appends a cue. */
Outcome cue_queue_add(CueQueue *queue, const Cue *cue);
/** Appends strokes. */
Outcome cue_queue_add_strokes(CueQueue *queue, const Strokes *strokes);
/** Brings the cues into the order of their frames; those of one frame stay as they are. */
void cue_queue_sort(CueQueue *queue);
/** Frame of the last cue; 0 without any. */
uint64_t cue_queue_last_frame(const CueQueue *queue);
/** The same, but for releases. */
uint64_t cue_queue_last_stroke(const CueQueue *queue);
void cue_queue_free(CueQueue *queue);

/** Passes on what comes before frame @p until, as far as the player has room. */
void cue_queue_feed(CueQueue *queue, Player *player, ModelBuilder *builder, uint64_t until);

#endif
