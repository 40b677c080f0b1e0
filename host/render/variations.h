/* SPDX-License-Identifier: MIT */
/**
 * @file variations.h
 * Many drums from one: `--vary KEY=RANGE --count N`.
 *
 * Each key has N values, one from each Nth part of its range, in an order of its own (a Latin
 * hypercube; McKay, Beckman, Conover, Technometrics 21, 1979), so that few sounds already cover all
 * ranges evenly. A key that a control would move in equal ratios is drawn so, too. The same --seed
 * draws the same values.
 */
#ifndef TABOR_HOST_VARIATIONS_H
#define TABOR_HOST_VARIATIONS_H

#include "base/options.h"

#define OPTION_VARY                                                                                \
  { "vary", 0, "KEY=RANGE", "draw a parameter for each of --count sounds (repeatable); see below" }
#define OPTION_COUNT                                                                               \
  { "count", 0, "N", "sounds of each PRESET, 1 to 1000; needs --vary" }

#define VARIATIONS_MOST 1000 /**< sounds of a preset */
#define VARIED_MOST 64       /**< keys */

/** A key that varies. */
typedef struct Varied {
  const char *text; /**< of the command line, "batter.tension=2000..4000" */
  size_t key;       /**< length of its key */
  double low, high;
  bool is_bent;      /**< drawn in equal ratios */
  const char *words; /**< of a list, "stick,mallet"; NULL: it is a range */
  double *shares;    /**< of each sound, 0 to 1 */
} Varied;

/** Begins with zeros. */
typedef struct Variations {
  size_t count; /**< of sounds; 0: nothing varies */
  Varied varied[VARIED_MOST];
  size_t key_count;
} Variations;

/** Reads --vary, --count and --seed. Free with variations_free(), whatever the outcome. */
Outcome variations_read(const Arguments *arguments, Variations *variations);
void variations_free(Variations *variations);
/** Turns each --vary of @p arguments into the --set of sound @p number, whose values are in @p
 * texts, to be freed by the caller. @p options has the row of --set. */
Outcome variations_apply(const Variations *variations, size_t number, const Option *options,
                         Arguments *arguments, char **texts);
/** Writes the value of key @p key of sound @p number. */
void variations_value(const Variations *variations, size_t key, size_t number, char *text,
                      size_t size);

#endif
