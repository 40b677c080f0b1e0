/* SPDX-License-Identifier: MIT */
/**
 * @file strokes.h
 * Strokes, and other events of a drum, in order of time.
 */
#ifndef TABOR_HOST_STROKES_H
#define TABOR_HOST_STROKES_H

#include "strokes/stroke.h"

#define MOST_STROKES 100000

/**
 * Events in order of time; event.frame counts from the start of the sound. The release of a buzz or
 * a sweep is a later event. A move is at the frame where it starts.
 */
typedef struct Strokes {
  TaborEvent *events;
  size_t count, capacity;
  double rate;           /**< [Hz] */
  MidiResponse response; /**< for velocities given as midi */
} Strokes;

/** Appends a stroke of any time, and the release of a buzz or a sweep. Call strokes_sort() after
 * the last. */
Outcome strokes_add(Strokes *strokes, const Stroke *stroke);
/** Sorts by time, converts moves, and drops outdated releases. Call once, after the last
 * strokes_add(). */
void strokes_sort(Strokes *strokes);
/** Makes @p stroke the only one. */
Outcome strokes_replace(Strokes *strokes, const Stroke *stroke);
/** Merges @p count events in order of time; at one frame they follow the existing events. */
Outcome strokes_merge(Strokes *strokes, const TaborEvent *events, size_t count);
void strokes_free(Strokes *strokes);
/** Frame of the last event; 0 if there is none. */
uint32_t strokes_last_frame(const Strokes *strokes);
/** Frame of the last event that is not a release. */
uint32_t strokes_last_stroke(const Strokes *strokes);

#endif
