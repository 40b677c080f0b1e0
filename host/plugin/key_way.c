/* SPDX-License-Identifier: MIT */
#include "plugin/key_way.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plugin/choice_text.h"
#include "plugin/knob.h"

/* Where ratios are equal but the range begins at 0, the way has the last six powers of ten. */
static const double LEAST = 1e-6;

static KnobRange range_of(const TaborParameter *parameter) {
  const bool is_bent = parameter->logarithmic;
  const bool has_zero = parameter->minimum <= 0;
  return (KnobRange){.minimum = (float)parameter->minimum,
                     .maximum = (float)parameter->maximum,
                     .logarithmic = is_bent && !has_zero,
                     .least = is_bent && has_zero ? (float)(LEAST * parameter->maximum) : 0};
}

double key_position(const TaborParameter *parameter, const char *value) {
  const KnobRange range = range_of(parameter);
  double place = 0;
  const bool is_pitch = strcmp(parameter->key, "pitch") == 0;
  if (parameter->type == TABOR_TYPE_TEXT || !*value) return -1;
  if (is_pitch && strtod(value, NULL) == 0) return -1; /* the tension leads */
  if (parameter->type != TABOR_TYPE_CHOICE)
    return fmin(fmax(knob_position(&range, strtod(value, NULL)), 0), 1);
  const uint32_t count = choice_count(parameter->choices);
  return choice_find(parameter->choices, value, &place) && count > 1 ? place / (count - 1u) : 0;
}

void key_at_position(const TaborParameter *parameter, double position, char *value, size_t size) {
  const KnobRange range = range_of(parameter);
  if (parameter->type == TABOR_TYPE_CHOICE) {
    const uint32_t most = choice_count(parameter->choices) - 1;
    (void)choice_text(parameter->choices, (int)lround(position * most), value, (uint32_t)size);
  } else if (parameter->type == TABOR_TYPE_WHOLE) {
    (void)snprintf(value, size, "%.0f", knob_at_position(&range, position));
  } else {
    (void)snprintf(value, size, "%.4g", knob_at_position(&range, position));
  }
}

uint32_t key_choices(const TaborParameter *parameter) {
  if (parameter->type == TABOR_TYPE_CHOICE) return choice_count(parameter->choices);
  if (parameter->type != TABOR_TYPE_WHOLE) return 0;
  return (uint32_t)fmin(parameter->maximum - parameter->minimum, 1e9) + 1;
}
