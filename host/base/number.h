/* SPDX-License-Identifier: MIT */
/**
 * @file number.h
 * Numbers from the command line: decimal, finite, whole text, within a range.
 */
#ifndef TABOR_HOST_NUMBER_H
#define TABOR_HOST_NUMBER_H

#include "base/message.h"

/** A number as the user wrote it and what is allowed for it. */
typedef struct NumberField {
  const char *name; /**< "--rate", "--strike time", for messages */
  double minimum, maximum;
  bool whole; /**< only whole numbers */
} NumberField;

/**
 * Reads "-1.5e3" and the like. Refuses, naming field, text and range, anything else: blanks,
 * hexadecimal digits, inf, nan, numbers too large for a double or outside the range.
 */
Outcome number_read(const NumberField *field, const char *text, double *value);

#endif
