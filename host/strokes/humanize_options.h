/* SPDX-License-Identifier: MIT */
/**
 * @file humanize_options.h
 * The options of the command line for the scatter of strokes.
 */
#ifndef TABOR_HOST_HUMANIZE_OPTIONS_H
#define TABOR_HOST_HUMANIZE_OPTIONS_H

#include "base/options.h"
#include "strokes/humanize.h"

/** Rows of an option table for the options that humanize_read() reads; @p fallback is a string,
 * "0". */
#define OPTION_HUMANIZE(fallback)                                                                  \
  { "humanize", 0, "AMOUNT", "scatter of place and speed, 0 to 1 (default " fallback ")" }
#define OPTION_SEED                                                                                \
  { "seed", 0, "N", "of --humanize, 0 to 4294967295: the same gives the same strokes (default 1)" }

/** Reads --humanize and --seed; without --humanize the amount is @p fallback. */
Outcome humanize_read(const Arguments *arguments, double fallback, Humanizer *result);

#endif
