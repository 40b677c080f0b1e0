/* SPDX-License-Identifier: MIT */
/**
 * @file strokes.h
 * The strokes of a rendering, from --strike options and events files.
 */
#ifndef TABOR_HOST_STROKES_H
#define TABOR_HOST_STROKES_H

#include "base/options.h"
#include "strokes/stroke.h"

#define MOST_STROKES 100000

#define OPTION_STRIKE                                                                              \
  { "strike", 0, "FIELDS", "a stroke (repeatable); see below (default: the preset's)" }
#define OPTION_EVENTS                                                                              \
  { "events", 0, "FILE", "strokes from a CSV file (repeatable), '-' for standard input; see below" }

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

/**
 * Reads every --strike and the files of every --events for a drum at @p rate [Hz]; without any, and
 * without --midi-file, the preset's own stroke at time 0. Velocities that are given as MIDI's become speeds
 * as --velocity-curve and --velocity-range say. Free with strokes_free(), whatever the outcome.
 */
Outcome strokes_read(const Arguments *arguments, const TaborDrumDef *def, double rate,
                     Strokes *strokes);
/** Adds one behind the others, whatever its time. */
Outcome strokes_add(Strokes *strokes, const Stroke *stroke);
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
