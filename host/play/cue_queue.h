/* SPDX-License-Identifier: MIT */
/**
 * @file cue_queue.h
 * What is known before it happens: messages and changes of the preset, fed to a player in time.
 */
#ifndef TABOR_HOST_SCORE_H
#define TABOR_HOST_SCORE_H

#include "play/model_builder.h"
#include "strokes/strokes.h"

/** Something that happens at message.frame. */
typedef struct Cue {
  PlayerMessage message;
  const char *preset; /**< not NULL: a change to it, instead of the message; not copied */
} Cue;

/** Begins as {0}. */
typedef struct Score {
  Cue *cues;
  size_t count, capacity;
  size_t next; /**< to feed */
} Score;

/** Appends a cue. */
Outcome score_add(Score *score, const Cue *cue);
/** Appends strokes. */
Outcome score_add_strokes(Score *score, const Strokes *strokes);
/** Brings the cues into the order of their frames; those of one frame stay as they are. */
void score_sort(Score *score);
/** Frame of the last cue; 0 without any. */
uint64_t score_last_frame(const Score *score);
/** The same, but for releases. */
uint64_t score_last_stroke(const Score *score);
void score_free(Score *score);

/** Passes on what comes before frame @p until, as far as the player has room. */
void score_feed(Score *score, Player *player, DrumChanges *changes, uint64_t until);

#endif
