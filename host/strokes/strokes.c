/* SPDX-License-Identifier: MIT */
#include "strokes/strokes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static Outcome make_room(Strokes *strokes) {
  if (strokes->count < strokes->capacity) return OUTCOME_OK;
  const size_t capacity = strokes->capacity ? 2 * strokes->capacity : 64;
  TaborEvent *const events = realloc(strokes->events, capacity * sizeof *events);
  if (!events) return fail_memory();
  strokes->events = events;
  strokes->capacity = capacity;
  return OUTCOME_OK;
}

/* Adds an event whose number among all is event->index, until they are sorted. */
static Outcome add_event(Strokes *strokes, const TaborEvent *event, double time) {
  const Outcome outcome = make_room(strokes);
  if (outcome != OUTCOME_OK) return outcome;
  TaborEvent *const added = &strokes->events[strokes->count++];
  *added = *event;
  added->frame = (uint32_t)llround(time * strokes->rate); /* 7200 s at 192 kHz: < 2^31 */
  return OUTCOME_OK;
}

/* What `parameter` marks a release as until they are sorted: the end of a buzz or a sweep, at the
   time that the stroke says, or at the usual one. */
enum { LIFT = 1, USUAL_LIFT = 2 };

static Outcome add_lift(Strokes *strokes, const Stroke *stroke, const TaborEvent *held) {
  const TaborEvent lift = {.type = TABOR_EVENT_RELEASE,
                           .id = held->id,
                           .index = held->index,
                           .parameter = stroke_says_hold(stroke) ? LIFT : USUAL_LIFT};
  return add_event(strokes, &lift, stroke->time + stroke->hold);
}

Outcome strokes_add(Strokes *strokes, const Stroke *stroke) {
  if (strokes->count >= MOST_STROKES) {
    return refuse("%s too many strokes; allowed: up to %d", stroke->where, MOST_STROKES);
  }
  TaborEvent event = stroke->event;
  const Outcome sound = stroke_complete(stroke, &event);
  if (sound != OUTCOME_OK) return sound;
  event.index = (uint32_t)strokes->count;
  if (event.type == TABOR_EVENT_STRIKE && event.id == 0) {
    event.id = STROKE_MOST_ID + 1 + event.index;
  }
  const Outcome outcome = add_event(strokes, &event, stroke->time);
  const bool lifts = outcome == OUTCOME_OK && stroke_is_held(&event);
  return lifts ? add_lift(strokes, stroke, &event) : outcome;
}

/* By time; strokes of one frame stay in the order in which they were given, before moves. */
static int compare_events(const void *left, const void *right) {
  const TaborEvent *const a = left, *const b = right;
  if (a->frame != b->frame) return a->frame < b->frame ? -1 : 1;
  const bool a_moves = a->type == TABOR_EVENT_MOVE, b_moves = b->type == TABOR_EVENT_MOVE;
  if (a_moves != b_moves) return a_moves ? 1 : -1;
  return a->index < b->index ? -1 : a->index > b->index;
}

/* The hand has struck again since the stroke that this would lift: that stick is gone already. */
static bool is_outdated(const TaborEvent *events, size_t lift) {
  if (!events[lift].parameter) return false;
  for (size_t i = lift; i-- > 0;) {
    const bool same = events[i].type == TABOR_EVENT_STRIKE && events[i].id == events[lift].id;
    if (same) return events[i].index != events[lift].index;
  }
  return false;
}

static bool is_meant(const TaborEvent *event, uint32_t id) {
  return id == 0 || event->id == 0 || event->id == id;
}

static bool is_sweep(const TaborEvent *event) {
  return event->type == TABOR_EVENT_STRIKE && event->technique == TABOR_TECHNIQUE_SWEEP;
}

/* A sweep whose way goes on behind its usual end lasts as long as its way. */
static void prolong(TaborEvent *events, size_t count, size_t lift) {
  for (size_t i = lift + 1; i < count; i++) {
    const bool meant = is_meant(&events[i], events[lift].id);
    if (meant && events[i].type == TABOR_EVENT_STRIKE) break;
    if (meant && events[i].type == TABOR_EVENT_MOVE) events[lift].frame = events[i].frame;
  }
}

/* Where a move's brush sets out: at the frame of its last place before. */
static uint32_t set_out(const TaborEvent *events, size_t move) {
  for (size_t i = move; i-- > 0;) {
    const bool place = is_sweep(&events[i]) || events[i].type == TABOR_EVENT_MOVE;
    if (place && is_meant(&events[i], events[move].id)) return events[i].frame;
  }
  return events[move].frame;
}

/* A row says where a brush is; an event, where it goes from now on. From the last one back, so that
   all see where the rows before them are. */
static void draw_ways(Strokes *strokes) {
  TaborEvent *const events = strokes->events;
  for (size_t i = strokes->count; i-- > 0;) {
    if (events[i].parameter == USUAL_LIFT) prolong(events, strokes->count, i);
  }
  for (size_t i = strokes->count; i-- > 0;) {
    if (events[i].type != TABOR_EVENT_MOVE) continue;
    const uint32_t from = set_out(events, i);
    events[i].value = (events[i].frame - from) / strokes->rate;
    events[i].frame = from;
  }
}

void strokes_sort(Strokes *strokes) {
  TaborEvent *const events = strokes->events;
  qsort(events, strokes->count, sizeof *events, compare_events);
  draw_ways(strokes);
  qsort(events, strokes->count, sizeof *events, compare_events);
  for (size_t i = 0; i < strokes->count; i++) {
    if (is_outdated(events, i)) events[i].type = 0;
  }
  size_t kept = 0;
  for (size_t i = 0; i < strokes->count; i++) {
    if (events[i].type == 0) continue;
    events[kept] = events[i];
    events[kept].index = events[kept].parameter = 0;
    kept++;
  }
  strokes->count = kept;
}

Outcome strokes_replace(Strokes *strokes, const Stroke *stroke) {
  strokes->count = 0;
  const Outcome outcome = strokes_add(strokes, stroke);
  strokes_sort(strokes);
  return outcome;
}

Outcome strokes_merge(Strokes *strokes, const TaborEvent *events, size_t count) {
  const size_t capacity = strokes->count + count;
  TaborEvent *const merged = calloc(capacity + 1, sizeof *merged);
  if (!merged) return fail_memory();
  size_t own = 0, others = 0;
  for (size_t i = 0; i < capacity; i++) {
    const bool from_own = own < strokes->count &&
                          (others == count || strokes->events[own].frame <= events[others].frame);
    merged[i] = from_own ? strokes->events[own++] : events[others++];
  }
  free(strokes->events);
  strokes->events = merged;
  strokes->count = strokes->capacity = capacity;
  return OUTCOME_OK;
}

void strokes_free(Strokes *strokes) {
  free(strokes->events);
  *strokes = (Strokes){0};
}

uint32_t strokes_last_frame(const Strokes *strokes) {
  return strokes->count > 0 ? strokes->events[strokes->count - 1].frame : 0;
}

uint32_t strokes_last_stroke(const Strokes *strokes) {
  size_t last = strokes->count;
  while (last > 0 && strokes->events[last - 1].type == TABOR_EVENT_RELEASE) last--;
  return last > 0 ? strokes->events[last - 1].frame : 0;
}
