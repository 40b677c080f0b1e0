/* SPDX-License-Identifier: MIT */
#include "kit/kit_values.h"

#include <string.h>

#include "base/number.h"

const char *const kit_value_keys[KIT_VALUES + 1] = {
  [TABOR_KIT_OVERHEADS] = "kit.overheads",
  [TABOR_KIT_COUPLING] = "kit.coupling",
  [TABOR_KIT_SAMPLES] = "kit.samples",
};

int kit_value_find(const char *key) {
  int value = 0;
  while (value < KIT_VALUES && strcmp(kit_value_keys[value], key) != 0) value++;
  return value < KIT_VALUES ? value : -1;
}

Outcome kit_value_read(int value, const char *text, double *number) {
  const double least = value == TABOR_KIT_COUPLING ? -60 : KIT_VALUE_NONE;
  const NumberField field = {kit_value_keys[value], least, 24, false};
  if (strcmp(text, "off") != 0) return number_read(&field, text, number);
  *number = KIT_VALUE_NONE;
  return OUTCOME_OK;
}

void kit_value_define(TaborKitDef *def, int value, double number) {
  if (value == TABOR_KIT_OVERHEADS) def->overheads = number;
  if (value != TABOR_KIT_COUPLING) return;
  def->coupled = number > KIT_VALUE_NONE;
  if (def->coupled) def->coupling = number;
}
