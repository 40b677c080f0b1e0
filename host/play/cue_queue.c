/* SPDX-License-Identifier: MIT */
#include "play/cue_queue.h"

#include <stdlib.h>

#define ROOM 2048 /* messages that wait at most; a player has more */

Outcome cue_queue_add(CueQueue *queue, const Cue *cue) {
  if (queue->count == queue->capacity) {
    const size_t capacity = queue->capacity ? 2 * queue->capacity : 256;
    Cue *const cues = realloc(queue->cues, capacity * sizeof *cues);
    if (!cues) return fail_memory();
    queue->cues = cues;
    queue->capacity = capacity;
  }
  queue->cues[queue->count++] = *cue;
  return OUTCOME_OK;
}

Outcome cue_queue_add_strokes(CueQueue *queue, const Strokes *strokes) {
  Outcome outcome = OUTCOME_OK;
  for (size_t i = 0; i < strokes->count && outcome == OUTCOME_OK; i++) {
    const TaborEvent *const event = &strokes->events[i];
    const Cue cue = {.message = {.frame = event->frame, .type = PLAYER_EVENT, .event = *event}};
    outcome = cue_queue_add(queue, &cue);
  }
  return outcome;
}

/* While they are sorted, the cues' places stand in the events' frames, which have no meaning there.
 */
static int compare_cues(const void *left, const void *right) {
  const Cue *const a = left, *const b = right;
  if (a->message.frame != b->message.frame) return a->message.frame < b->message.frame ? -1 : 1;
  return a->message.event.frame < b->message.event.frame ? -1 : 1;
}

void cue_queue_sort(CueQueue *queue) {
  if (queue->count == 0) return;
  for (size_t i = 0; i < queue->count; i++) queue->cues[i].message.event.frame = (uint32_t)i;
  qsort(queue->cues, queue->count, sizeof *queue->cues, compare_cues);
}

uint64_t cue_queue_last_frame(const CueQueue *queue) {
  return queue->count > 0 ? queue->cues[queue->count - 1].message.frame : 0;
}

static bool is_release(const Cue *cue) {
  return !cue->preset && cue->message.type == PLAYER_EVENT &&
         cue->message.event.type == TABOR_EVENT_RELEASE;
}

uint64_t cue_queue_last_stroke(const CueQueue *queue) {
  size_t last = queue->count;
  while (last > 0 && is_release(&queue->cues[last - 1])) last--;
  return last > 0 ? queue->cues[last - 1].message.frame : 0;
}

void cue_queue_free(CueQueue *queue) {
  free(queue->cues);
  *queue = (CueQueue){0};
}

void cue_queue_feed(CueQueue *queue, Player *player, ModelBuilder *builder, uint64_t until) {
  for (; queue->next < queue->count; queue->next++) {
    const Cue *const cue = &queue->cues[queue->next];
    if (cue->message.frame >= until || player_waiting(player, SOURCE_SCORE) >= ROOM) return;
    if (cue->preset) {
      (void)model_builder_preset(builder, cue->message.frame, cue->preset); /* it has said so */
    } else {
      (void)player_send(player, SOURCE_SCORE, &cue->message);
    }
  }
}
