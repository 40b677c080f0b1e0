/* SPDX-License-Identifier: MIT */
/**
 * @file score.h
 * What is known before it happens: messages in order of time, fed to a player as it comes to them.
 */
#ifndef TABOR_HOST_SCORE_H
#define TABOR_HOST_SCORE_H

#include "player.h"
#include "strokes.h"

typedef struct Score {
  const Strokes *strokes;
  size_t next; /**< of these */
} Score;

/** Sends what comes before frame @p until, as far as the player has room. */
void score_feed(Score *score, Player *player, uint64_t until);

#endif
