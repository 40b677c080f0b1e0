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
 * Events in order of time; event.frame counts from the beginning of the sound. A buzz or a sweep is
 * followed by the release that lifts it; a move stands where it begins.
 */
typedef struct Strokes {
  TaborEvent *events;
  size_t count, capacity;
  double rate;           /**< [Hz] */
  MidiResponse response; /**< of velocities given as midi */
} Strokes;

/** Adds one behind the others, whatever its time. Who has added the last calls strokes_sort(). */
Outcome strokes_add(Strokes *strokes, const Stroke *stroke);
/** Puts all into order of time, and ends buzzes and sweeps where they end. Once, after the last strokes_add(). */
void strokes_sort(Strokes *strokes);
/** Makes @p stroke the only one. */
Outcome strokes_replace(Strokes *strokes, const Stroke *stroke);
/** Adds @p count events that are in order of time; of one frame they come behind those that are there. */
Outcome strokes_merge(Strokes *strokes, const TaborEvent *events, size_t count);
void strokes_free(Strokes *strokes);
/** Frame of the last event; 0 if there is none. */
uint32_t strokes_last_frame(const Strokes *strokes);
/** The same, but for releases. */
uint32_t strokes_last_stroke(const Strokes *strokes);

#endif
