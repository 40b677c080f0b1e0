/* SPDX-License-Identifier: MIT */
/**
 * @file knobs.h
 * The controls of the plugins: one table for the plugin, its description in Turtle, and the documentation.
 *
 * A knob that stands for a key of a drum's definition takes unit, logarithm and, unless the table narrows
 * it, range from the engine's parameter, and its default from the preset DEFAULT_PRESET.
 * Symbols are such keys with '_' for '.', and never change. New knobs go to the end: their order is that of
 * the ports.
 */
#ifndef TABOR_LV2_KNOBS_H
#define TABOR_LV2_KNOBS_H

#include <tabor/tabor.h>

#include "base/realtime.h"
#include "drums/default_preset.h"

/** In the order of the ports. */
typedef enum KnobId {
  KNOB_BATTER_TENSION,
  KNOB_RESONANT_TENSION,
  KNOB_BATTER_MUFFLING,
  KNOB_RESONANT_MUFFLING,
  KNOB_STRAINER,
  KNOB_WIRE_TENSION,
  KNOB_STICK_HARDNESS,
  KNOB_STRIKE_RADIUS,
  KNOB_STRIKE_ANGLE,
  KNOB_VELOCITY_CURVE,
  KNOB_HUMANIZE,
  KNOB_QUALITY,
  KNOB_GAIN,
  KNOB_LEVEL_PAIR, /**< from here to KNOB_LEVEL_FAR of the stereo plugin alone */
  KNOB_LEVEL_TOP,
  KNOB_LEVEL_BOTTOM,
  KNOB_LEVEL_NEAR,
  KNOB_LEVEL_FAR, /**< the last of these */
  KNOB_VELOCITY_RANGE,
  KNOB_COUNT
} KnobId;

#define KNOB_KEYS (KNOB_STRIKE_ANGLE + 1) /**< the first so many stand for keys */

/** What turning a knob takes. */
typedef enum KnobKind {
  KNOB_LIVE,    /**< a parameter event */
  KNOB_REBUILD, /**< another model */
  KNOB_STROKE,  /**< later strokes differ */
  KNOB_SETTING  /**< the plugin does it by itself */
} KnobKind;

typedef struct Knob {
  const char *symbol; /**< of the port */
  const char *name;   /**< for a person */
  const char *key;    /**< of the definition, "batter.tension"; NULL if it stands for none */
  const char *group;  /**< symbol of its group */
  KnobKind kind;
  double minimum, maximum; /**< NaN: the engine's */
  double fallback;         /**< NaN: the preset's */
  const char *unit;        /**< NULL: the engine's */
  const char *choices;     /**< words separated by '|', for 0, 1, ...; or NULL */
  double off;              /**< the value that switches it off, or NaN */
  const char *comment;
} Knob;

/** What a port of a knob is. */
typedef struct KnobRange {
  float minimum, maximum, fallback;
  bool logarithmic;
  const char *unit; /**< "" for a pure number */
} KnobRange;

extern const Knob knobs[KNOB_COUNT];

/** Knob number @p place of the stereo plugin, or of the other one; KNOB_COUNT past the last. */
static inline KnobId knob_at(bool stereo, uint32_t place) REALTIME {
  const uint32_t levels = KNOB_LEVEL_FAR - KNOB_LEVEL_PAIR + 1;
  const uint32_t id = stereo || place < KNOB_LEVEL_PAIR ? place : place + levels;
  return id < KNOB_COUNT ? (KnobId)id : KNOB_COUNT;
}

/** SET-UP. @p usual is the definition of DEFAULT_PRESET. */
KnobRange knob_range(KnobId id, const TaborDrumDef *usual);
/** The field of @p def that a knob with a key stands for; NULL if the drum has no such part. */
double *knob_field(TaborDrumDef *def, KnobId id);
/** The level that a value of LEVEL or GAIN [dB] stands for: a factor, 0 at the lowest level. */
double knob_factor(KnobId id, float value) REALTIME;
/**
 * A port's value as a person would have written it, with six digits: 0.05f is 0.05, so that a definition
 * gets the very number that stands in a preset.
 */
double knob_decimal(float value) REALTIME;

#endif
