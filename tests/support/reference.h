/* SPDX-License-Identifier: MIT */
/* Loads the independent reference values of tests/reference (made by tools/make-reference.py and
 * tools/radiation_reference.py). */
#ifndef TEST_REFERENCE_H
#define TEST_REFERENCE_H

#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static inline json_t *reference_load(const char *name) {
  char path[1024];
  json_error_t error;
  snprintf(path, sizeof path, "%s/reference/%s", TABOR_TEST_DATA, name);
  json_t *root = json_load_file(path, 0, &error);
  if (!root) {
    fprintf(stderr, "%s: %s\n", path, error.text);
    abort();
  }
  return root;
}

static inline double reference_number(const json_t *array, size_t index) {
  return json_number_value(json_array_get(array, index));
}

/* Copies an array of numbers; returns its length. */
static inline size_t reference_vector(const json_t *array, double *out, size_t room) {
  const size_t count = json_array_size(array);
  if (count > room) abort();
  for (size_t i = 0; i < count; i++) out[i] = reference_number(array, i);
  return count;
}

#endif
