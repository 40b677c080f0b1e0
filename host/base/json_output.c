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

static json_t *complete(json_t *whole, bool has_all) {
  if (has_all) return whole;
  json_decref(whole);
  return NULL;
}

json_t *json_with_item(json_t *list, json_t *value) {
  return complete(list, json_array_append_new(list, value) == 0);
}

json_t *json_with_field(json_t *object, const char *key, json_t *value) {
  return complete(object, json_object_set_new(object, key, value) == 0);
}

/* Jansson 2.14 leaves out a key where it finds no memory for it, and says nothing. */
static bool is_whole(const char *text) {
  json_t *const again = json_loads(text, 0, NULL);
  json_decref(again);
  return again != NULL;
}

static char *write_text(const json_t *value, size_t flags) {
  char *const text = value ? json_dumps(value, flags) : NULL;
  if (!text || is_whole(text)) return text;
  free(text);
  return NULL;
}

/* 15 digits: every decimal number of so many comes out as it went in, 0.1 as 0.1. */
char *json_write(const json_t *value) {
  return write_text(value, JSON_INDENT(2) | JSON_REAL_PRECISION(15));
}

char *json_write_line(const json_t *value) {
  char *const text = write_text(value, JSON_COMPACT | JSON_REAL_PRECISION(17));
  const size_t length = text ? strlen(text) : 0;
  char *const line = text ? realloc(text, length + sizeof "\n") : NULL;
  if (line) {
    memcpy(line + length, "\n", sizeof "\n");
  } else {
    free(text);
  }
  return line;
}

Outcome json_print(json_t *value) {
  char *const text = json_write(value);
  json_decref(value);
  if (!text) return fail_memory();
  (void)puts(text);
  free(text);
  return OUTCOME_OK;
}
