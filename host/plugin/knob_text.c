/* SPDX-License-Identifier: MIT */
#include "plugin/knob_text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "drums/pitch_text.h"
#include "plugin/choice_text.h"

/* What four digits of per cent would round up to the whole. */
static const double NEARLY = 1 - 5e-5;

/* ---- per cent ------------------------------------------------------------------------------- */

static double least_of(const KnobRange *range) { return knob_decimal(range->minimum); }
static double most_of(const KnobRange *range) { return knob_decimal(range->maximum); }

static double limited(const KnobRange *range, double value) {
  return fmin(fmax(value, least_of(range)), most_of(range));
}

static bool is_part(const Knob *knob) {
  return knob->scale == KNOB_IN_PER_CENT || knob->scale == KNOB_IN_ROOTS;
}

/* A damper of the strength c brakes in proportion to c, and small changes of a small c are heard
 * most: the root. */
static double part_of(const Knob *knob, const KnobRange *range, double value) {
  const double least = least_of(range), most = most_of(range);
  if (knob->scale == KNOB_IN_ROOTS) return sqrt((value - least) / (most - least));
  return range->logarithmic ? log(value / least) / log(most / least) : value;
}

static double at_part(const Knob *knob, const KnobRange *range, double part) {
  const double least = least_of(range), most = most_of(range);
  if (knob->scale == KNOB_IN_ROOTS) return least + (most - least) * part * fabs(part);
  return range->logarithmic ? least * pow(most / least, part) : part;
}

/* ---- texts ---------------------------------------------------------------------------------- */

int knob_text(const Knob *knob, const KnobRange *range, double value, char *text, size_t size) {
  const double kept = limited(range, value);
  if (kept == knob->off) return snprintf(text, size, "%s", knob_off_word(knob));
  if (knob->top_word && kept > NEARLY * most_of(range))
    return snprintf(text, size, "%s", knob->top_word);
  if (knob->scale == KNOB_IN_NOTES) return pitch_text(kept, text, size);
  if (is_part(knob)) return snprintf(text, size, "%.4g %%", 100 * part_of(knob, range, kept));
  return snprintf(text, size, "%.6g%s%s", kept, *range->unit ? " " : "", range->unit);
}

/* Returns what follows the number and blanks; NULL if there is none. */
static const char *read_number(const char *text, double *value) {
  char *end = NULL;
  *value = strtod(text, &end);
  if (end == text || !isfinite(*value)) return NULL;
  return end + strspn(end, " ");
}

/* A number of a part of the whole is one of per cent, unless the knob's unit follows it. */
static bool read_value(const Knob *knob, const KnobRange *range, const char *text, double *value) {
  if (knob->scale == KNOB_IN_NOTES) return pitch_read(text, value);
  const char *const unit = read_number(text, value);
  if (!unit) return false;
  const bool is_plain = *range->unit && strcmp(unit, range->unit) == 0;
  if (is_part(knob) && !is_plain) *value = at_part(knob, range, *value / 100);
  return true;
}

static bool read_word(const Knob *knob, const KnobRange *range, const char *text, double *value) {
  if (!isnan(knob->off) && strcasecmp(text, knob_off_word(knob)) == 0) {
    *value = knob->off;
    return true;
  }
  if (!knob->top_word || strcasecmp(text, knob->top_word) != 0) return false;
  *value = most_of(range);
  return true;
}

int knob_label(const Knob *knob, const KnobRange *range, double value, char *text, size_t size) {
  if (!knob->choices) return knob_text(knob, range, value, text, size);
  const double kept = fmin(fmax(value, knob_decimal(range->minimum)), knob_decimal(range->maximum));
  return choice_text(knob->choices, (int)kept, text, (uint32_t)size);
}

bool knob_text_read(const Knob *knob, const KnobRange *range, const char *text, double *value) {
  double read;
  if (!read_word(knob, range, text, &read) && !read_value(knob, range, text, &read)) return false;
  *value = limited(range, read);
  return true;
}
