/* SPDX-License-Identifier: MIT */
/**
 * @file knob.h
 * A control of a plugin: a row of its instrument's table (knobs.h, kit_knobs.h), its range, and
 * where a value stands on its way. Symbols never change, since sessions and hosts know controls by
 * them.
 */
#ifndef TABOR_PLUGIN_KNOB_H
#define TABOR_PLUGIN_KNOB_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/realtime.h"
#include "strokes/humanize.h"

/** How a knob takes effect. */
typedef enum KnobKind {
  KNOB_LIVE,    /**< by a parameter event */
  KNOB_REBUILD, /**< by building another model, on which the sound goes on */
  KNOB_REPLACE, /**< by building another instrument, which plays anew */
  KNOB_STROKE,  /**< on later strokes */
  KNOB_SETTING  /**< at once, outside the model */
} KnobKind;

/** How a knob's value is shown, see knob_text.h. */
typedef enum KnobScale {
  KNOB_IN_UNITS,    /**< the number and its unit */
  KNOB_IN_NOTES,    /**< a frequency as a note and cents */
  KNOB_IN_PER_CENT, /**< of the value 1 or, on a logarithmic scale, of the way */
  KNOB_IN_ROOTS     /**< per cent of the way, with a quarter of the range in the lower half */
} KnobScale;

typedef struct Knob {
  const char *symbol; /**< symbol of the port */
  const char *name;   /**< displayed name */
  const char *key;    /**< key of the definition, "batter.tension"; or NULL */
  const char *group;  /**< symbol of its group */
  KnobKind kind;
  double minimum, maximum; /**< range; NaN: the engine's */
  double fallback;         /**< default; NaN: the preset's */
  const char *unit;        /**< "dB", "" for a pure number; NULL: the engine's */
  const char *mic;         /**< the microphone whose level it is, or NULL */
  const char *choices;     /**< words separated by '|', for 0, 1, ...; or NULL */
  double least;            /**< KnobRange.least, or 0 */
  double off;              /**< value that switches the knob off, or NaN */
  const char *off_word;    /**< its name; NULL: "Off" */
  const char *top_word;    /**< name of the maximum, or NULL */
  double step;             /**< of a hand that turns it in a window; 0: none */
  bool is_costly;          /**< though it is a setting, it has something built */
  bool is_bypass;          /**< its 0 lets the sound in pass through */
  bool is_level;           /**< of a part of the mix, which can be mute or solo */
  bool is_gain;            /**< of all outputs */
  bool is_of_player;       /**< about who plays and on which machine: no preset moves it */
  KnobScale scale;
  const char *comment;
} Knob;

/** The row of the scatter of strokes, in a group. */
#define KNOB_OF_HUMANIZE(its_group)                                                                \
  {                                                                                                \
    .symbol = "humanize", .name = "Humanize", .group = (its_group), .kind = KNOB_SETTING,          \
    .minimum = 0, .maximum = 1, .fallback = HUMANIZE_LIVE, .unit = "", .scale = KNOB_IN_PER_CENT,  \
    .off = NAN,                                                                                    \
    .comment = "Scatters the place of strokes by up to 15 mm and their speed by up to 6 %, times " \
               "this. The same notes are scattered alike each time."                               \
  }

/** Range, default and unit of a knob's port. */
typedef struct KnobRange {
  float minimum, maximum, fallback;
  bool logarithmic;
  /** Not 0: below it there is only the minimum, which is off. From it on the way is in equal
   * ratios, though the port's range is not logarithmic, since that begins at 0. */
  float least;
  const char *unit; /**< "" for a pure number */
} KnobRange;

/** A group of knobs, in the order in which hosts show them. */
typedef struct KnobGroup {
  const char *symbol, *name; /**< displayed name */
} KnobGroup;

enum { KNOB_PAGE = 8 };
#define KNOB_STEP 0.02 /**< of a control's way, a step by a key or a wheel */

/** A page of controls, in the window and of a host's remote control. Its id never changes. */
typedef struct KnobPage {
  uint32_t id;
  const char *section, *name;
  uint32_t count;
  uint32_t knobs[KNOB_PAGE];
} KnobPage;

/** Name of the value that switches a knob off. */
static inline const char *knob_off_word(const Knob *knob) {
  return knob->off_word ? knob->off_word : "Off";
}

/** True if the knob's way is not in proportion to its value. */
static inline bool knob_is_bent(const KnobRange *range) REALTIME {
  return range->logarithmic || range->least > 0;
}

/** Where @p value stands on the knob's way, 0 to 1 within its range; and the value there. */
double knob_position(const KnobRange *range, double value) REALTIME;
double knob_at_position(const KnobRange *range, double position) REALTIME;
/** @p position moved by @p way, within 0 to 1; of that many choices by one of them at least. 0
 * choices: any number. */
double knob_stepped(double position, double way, uint32_t choices) REALTIME;
/** @p value, which is finite, as a port has it: of a choice a whole number, of six decimal digits,
 * within the range. */
float knob_limited(const Knob *knob, const KnobRange *range, double value) REALTIME;
/** Converts a value of a level or a gain [dB] to a factor; the lowest gives 0. */
double knob_factor(const Knob *knob, float value) REALTIME;
/**
 * Rounds a port's value to six decimal digits: 0.05f becomes 0.05. So a definition gets exactly the
 * number that a preset has. What is not finite stays so.
 */
double knob_decimal(float value) REALTIME;
/** @p value as a single-precision number. A host may send any, and what no float can hold must not
 * be converted. */
float knob_single(double value) REALTIME;

#endif
