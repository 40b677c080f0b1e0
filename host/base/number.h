/* SPDX-License-Identifier: MIT */
/**
 * @file number.h
 * Numbers from the command line: decimal, finite, whole text, within a range.
 */
#ifndef TABOR_HOST_NUMBER_H
#define TABOR_HOST_NUMBER_H

#include "base/message.h"

/** Name and allowed range of a number. */
typedef struct NumberField {
  const char *name; /**< "--rate", "--strike time", for messages */
  double minimum, maximum;
  bool whole; /**< allow only whole numbers */
} NumberField;

/**
 * Reads a number such as "-1.5e3". Refuses anything else, naming field, text and range: blanks,
 * hexadecimal digits, inf, nan, numbers too large for a double or outside the range.
 */
Outcome number_read(const NumberField *field, const char *text, double *value);

#endif
