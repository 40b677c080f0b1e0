/* SPDX-License-Identifier: MIT */
#include "play/cue_queue.h"

#include <stdlib.h>

#define ROOM 2048 /* messages that wait at most; a player has more */

Outcome score_add(Score *score, const Cue *cue) {
  if (score->count == score->capacity) {
    const size_t capacity = score->capacity ? 2 * score->capacity : 256;
    Cue *const cues = realloc(score->cues, capacity * sizeof *cues);
    if (!cues) return fail_memory();
    score->cues = cues;
    score->capacity = capacity;
  }
  score->cues[score->count++] = *cue;
  return OUTCOME_OK;
}

Outcome score_add_strokes(Score *score, const Strokes *strokes) {
  Outcome outcome = OUTCOME_OK;
  for (size_t i = 0; i < strokes->count && outcome == OUTCOME_OK; i++) {
    const TaborEvent *const event = &strokes->events[i];
    const Cue cue = {.message = {.frame = event->frame, .type = PLAYER_EVENT, .event = *event}};
    outcome = score_add(score, &cue);
  }
  return outcome;
}

/* While they are sorted, the cues' places stand in the events' frames, which have no meaning there. */
static int compare_cues(const void *left, const void *right) {
  const Cue *const a = left, *const b = right;
  if (a->message.frame != b->message.frame) return a->message.frame < b->message.frame ? -1 : 1;
  return a->message.event.frame < b->message.event.frame ? -1 : 1;
}

void score_sort(Score *score) {
  if (score->count == 0) return;
  for (size_t i = 0; i < score->count; i++) score->cues[i].message.event.frame = (uint32_t)i;
  qsort(score->cues, score->count, sizeof *score->cues, compare_cues);
}

uint64_t score_last_frame(const Score *score) {
  return score->count > 0 ? score->cues[score->count - 1].message.frame : 0;
}

static bool is_release(const Cue *cue) {
  return !cue->preset && cue->message.type == PLAYER_EVENT &&
         cue->message.event.type == TABOR_EVENT_RELEASE;
}

uint64_t score_last_stroke(const Score *score) {
  size_t last = score->count;
  while (last > 0 && is_release(&score->cues[last - 1])) last--;
  return last > 0 ? score->cues[last - 1].message.frame : 0;
}

void score_free(Score *score) {
  free(score->cues);
  *score = (Score){0};
}

void score_feed(Score *score, Player *player, DrumChanges *changes, uint64_t until) {
  for (; score->next < score->count; score->next++) {
    const Cue *const cue = &score->cues[score->next];
    if (cue->message.frame >= until || player_waiting(player, SOURCE_SCORE) >= ROOM) return;
    if (cue->preset) {
      (void)drum_changes_preset(changes, cue->message.frame, cue->preset); /* it has said so */
    } else {
      (void)player_send(player, SOURCE_SCORE, &cue->message);
    }
  }
}
