/* SPDX-License-Identifier: MIT */
#include "strokes/humanize_options.h"

Outcome humanize_read(const Arguments *arguments, double fallback, Humanizer *result) {
  static const NumberField amount_field = {"--humanize", 0, 1, false};
  static const NumberField seed_field = {"--seed", 0, UINT32_MAX, true};
  double amount = fallback, seed = 1;
  Outcome outcome = arguments_number(arguments, &amount_field, &amount);
  if (outcome == OUTCOME_OK) outcome = arguments_number(arguments, &seed_field, &seed);
  *result = humanizer(amount, (uint32_t)seed);
  return outcome;
}
