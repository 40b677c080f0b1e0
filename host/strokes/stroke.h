/* SPDX-License-Identifier: MIT */
/**
 * @file stroke.h
 * One stroke, built from fields such as "velocity" and "2.5", from a --strike option or a line of
 * an events file. With the field "event" it presses, lifts or moves a stroke in play instead.
 */
#ifndef TABOR_HOST_STROKE_H
#define TABOR_HOST_STROKE_H

#include <stddef.h>

#include "base/message.h"
#include "midi/midi_speed.h"

#include <tabor/kit.h>

/** Number of fields: drum, time, velocity, midi, radius, angle, striker, technique, pressure, hold,
   id, event; and of a pluck wire, place, displacement, pull */
#define STROKE_FIELDS 16
#define TECHNIQUE_NAMES (TABOR_TECHNIQUE_PLUCK + 1)

#define STROKE_HOLD 0.5        /**< default duration of a buzz or a sweep [s] */
#define STROKE_MOST_ID 1000000 /**< the program itself uses larger ids */

/** A TaborTechnique is the index of its name. */
extern const char *const technique_names[TECHNIQUE_NAMES];

typedef struct StrokeField StrokeField;

/** What a pluck has in place of a stroke's velocity, radius, angle and striker. */
typedef struct Pluck {
  double wire;         /**< from 1 */
  double place;        /**< part of its length, 0 to 1 */
  double displacement; /**< [m] */
  double pull;         /**< time until the finger lets go [s] */
} Pluck;

/** What is struck: a drum, or one of a kit, which the field "drum" names. */
typedef struct StrokeTarget {
  const TaborDrumDef *def; /**< the drum, of a kit unused */
  const TaborKitDef *kit;  /**< or NULL */
} StrokeTarget;

/** A stroke whose fields are being read. */
typedef struct Stroke {
  const TaborDrumDef *def;
  const TaborKitDef *kit; /**< of which it is drum number `drum`; or NULL */
  uint32_t drum;
  const char *where;     /**< "--strike" or "drums.csv:3:", for messages; not copied */
  unsigned set;          /**< set of the fields read so far */
  double time;           /**< [s] */
  double hold;           /**< duration until a buzz or a sweep is lifted [s] */
  MidiResponse response; /**< for the field midi */
  Pluck pluck;
  TaborEvent event;
} Stroke;

/** Whether a striker can play a technique: a brush has no shaft that could meet the hoop, and
 * nothing else sweeps. */
bool striker_can(const TaborStrikerDef *striker, TaborTechnique technique);
/** True if a field has set the hold. */
bool stroke_says_hold(const Stroke *stroke);
/** True of a buzz or a sweep, which a hand presses until it lifts the stick. */
bool stroke_is_held(const TaborEvent *event);
/** Call after all fields were read: fills in the values that depend on several fields. Refused are
   a pluck on a drum without that wire, fields of a pluck for others and the reverse, a sweep
   without a brush or with a speed out of the range of sweep_speed, a rimshot or a cross-stick with
   a brush, and pressure or hold of a stroke that is not held. */
Outcome stroke_complete(const Stroke *stroke, TaborEvent *event);
/** Returns the preset's own stroke, at time 0. */
Stroke stroke_default(const TaborDrumDef *def, const char *where);
/**
 * The same of the drum that @p name of @p length bytes, the value of the field "drum", says. NULL:
 * there is no such field. Refused are a kit's stroke without it, an unknown name, and a name where
 * there is one drum.
 */
Outcome stroke_begin(const StrokeTarget *target, const char *where, const char *name, size_t length,
                     Stroke *stroke);
/** True of the field "drum", which stroke_begin() has taken. */
bool stroke_field_is_drum(const StrokeField *field);
/** Finds the field whose name is these @p length bytes; NULL if there is none. */
const StrokeField *stroke_field(const char *name, size_t length);
const char *stroke_field_name(const StrokeField *field);
/** Refuses an unknown name of a @p kind ("field", "column"), with the nearest name. */
Outcome stroke_unknown_field(const char *where, const char *kind, const char *name, size_t length);
/** Sets a field from the text @p value of @p length bytes; refuses to set it twice. */
Outcome stroke_set(Stroke *stroke, const StrokeField *field, const char *value, size_t length);

#endif
