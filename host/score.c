/* SPDX-License-Identifier: MIT */
#include "score.h"

#define ROOM 1024 /* messages that wait at most; a player has more */

void score_feed(Score *score, Player *player, uint64_t until) {
  const Strokes *const strokes = score->strokes;
  for (; score->next < strokes->count; score->next++) {
    const TaborEvent *const event = &strokes->events[score->next];
    if (event->frame >= until || player_waiting(player, SOURCE_SCORE) >= ROOM) return;
    const PlayerMessage message = {.frame = event->frame, .type = PLAYER_EVENT, .event = *event};
    (void)player_send(player, SOURCE_SCORE, &message);
  }
}
