/* SPDX-License-Identifier: MIT */
#include "base/json_output.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

json_t *json_number(double number) { return isfinite(number) ? json_real(number) : json_null(); }

json_t *json_text(const char *text) {
  json_t *const value = json_string(text);
  if (value) return value;
  char *const copy = strdup(text);
  for (char *byte = copy; byte && *byte; byte++) {
    if ((unsigned char)*byte >= 0x80) *byte = '?';
  }
  json_t *const plain = copy ? json_string(copy) : NULL;
  free(copy);
  return plain;
}

/* 15 digits: every decimal number of so many comes out as it went in, 0.1 as 0.1. */
Outcome json_print(json_t *value) {
  char *const text = value ? json_dumps(value, JSON_INDENT(2) | JSON_REAL_PRECISION(15)) : NULL;
  json_decref(value);
  if (!text) return fail_memory();
  (void)puts(text);
  free(text);
  return OUTCOME_OK;
}
