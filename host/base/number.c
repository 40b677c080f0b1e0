/* SPDX-License-Identifier: MIT */
#include "base/number.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Passes digits; returns how many there were. */
static size_t skip_digits(const char **text) {
  const size_t count = strspn(*text, "0123456789");
  *text += count;
  return count;
}

static void skip_sign(const char **text) {
  if (**text == '+' || **text == '-') (*text)++;
}

/* strtod() alone would also take blanks, hexadecimal digits, inf and nan. */
static bool is_decimal(const char *text) {
  skip_sign(&text);
  size_t digits = skip_digits(&text);
  if (*text == '.') {
    text++;
    digits += skip_digits(&text);
  }
  if (digits == 0) return false;
  if (*text == 'e' || *text == 'E') {
    text++;
    skip_sign(&text);
    if (skip_digits(&text) == 0) return false;
  }
  return *text == '\0';
}

/* The program never leaves the "C" locale, so the decimal separator is a point. */
Outcome number_read(const NumberField *field, const char *text, double *value) {
  const double number = is_decimal(text) ? strtod(text, NULL) : NAN;
  const char *trouble = NULL;
  if (isnan(number)) {
    trouble = "not a number";
  } else if (!(number >= field->minimum && number <= field->maximum)) {
    trouble = "out of range";
  } else if (field->whole && number != floor(number)) {
    trouble = "not a whole number";
  }
  if (trouble) {
    return refuse("%s '%.80s': %s; allowed: %.10g to %.10g", field->name, text, trouble,
                  field->minimum, field->maximum);
  }
  *value = number;
  return OUTCOME_OK;
}
