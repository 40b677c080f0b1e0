/* SPDX-License-Identifier: MIT */
/**
 * @file stroke_options.h
 * The strokes on the command line: --strike options and events files.
 */
#ifndef TABOR_HOST_STROKE_OPTIONS_H
#define TABOR_HOST_STROKE_OPTIONS_H

#include "base/options.h"
#include "strokes/strokes.h"

#define OPTION_STRIKE                                                                              \
  { "strike", 0, "FIELDS", "a stroke (repeatable); see below (default: the preset's)" }
#define OPTION_EVENTS                                                                              \
  { "events", 0, "FILE", "strokes from a CSV file (repeatable), '-' for standard input; see below" }

/**
 * Reads every --strike and the files of every --events for a drum at @p rate [Hz]. Without these
 * and without
 * --midi-file, the result is the preset's own stroke at time 0. --velocity-curve and
 * --velocity-range convert MIDI velocities to speeds. Free with strokes_free(), whatever the
 * outcome.
 */
Outcome strokes_read(const Arguments *arguments, const TaborDrumDef *def, double rate,
                     Strokes *strokes);
/** The same for a kit: @p strokes of each of its drums, none unless they are asked for. Free each,
 * whatever the outcome. */
Outcome strokes_read_for_kit(const Arguments *arguments, const TaborKitDef *kit, double rate,
                             Strokes strokes[TABOR_KIT_DRUMS]);

#endif
