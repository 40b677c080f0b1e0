/* SPDX-License-Identifier: MIT */
/**
 * @file stroke.h
 * One stroke, put together from fields such as "velocity" and "2.5", which come from a --strike
 * option or from a line of an events file. With the field "event" it presses, lifts or moves what is in play instead.
 */
#ifndef TABOR_HOST_STROKE_H
#define TABOR_HOST_STROKE_H

#include <stddef.h>

#include "base/message.h"
#include "midi/midi_speed.h"

/** time, velocity, midi, radius, angle, striker, technique, pressure, hold, id, event */
#define STROKE_FIELDS 11

#define STROKE_HOLD 0.5        /**< of a buzz or a sweep that does not say how long [s] */
#define STROKE_MOST_ID 1000000 /**< larger ids are the program's own */

typedef struct StrokeField StrokeField;

/** A stroke while its fields are being read. */
typedef struct Stroke {
  const TaborDrumDef *def;
  const char *where;     /**< "--strike" or "drums.csv:3:", for messages; not copied */
  unsigned set;          /**< what its fields have set so far */
  double time;           /**< [s] */
  double hold;           /**< after which a buzz or a sweep is lifted [s] */
  MidiResponse response; /**< of the field midi */
  TaborEvent event;
} Stroke;

/** Whether a field says after which time it is lifted. */
bool stroke_says_hold(const Stroke *stroke);
/** Fields that all have been read: fills in what depends on others; a sweep needs a brush,
    and is no faster than one can be drawn. */
Outcome stroke_complete(const Stroke *stroke, TaborEvent *event);
/** The preset's own stroke, at time 0. */
Stroke stroke_default(const TaborDrumDef *def, const char *where);
/** Field whose name these @p length bytes are, or NULL. */
const StrokeField *stroke_field(const char *name, size_t length);
const char *stroke_field_name(const StrokeField *field);
/** Refuses a @p kind ("field", "column") that is none, with the nearest name. */
Outcome stroke_unknown_field(const char *where, const char *kind, const char *name, size_t length);
/** Sets a field to what the text @p value of @p length bytes says; refuses to set it twice. */
Outcome stroke_set(Stroke *stroke, const StrokeField *field, const char *value, size_t length);

#endif
