/* SPDX-License-Identifier: MIT */
#include "plugin/definition_text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define KEY_SIZE (2 * TABOR_NAME_SIZE)

char *definition_write(const TaborDrumDef *def) {
  char *const text = malloc(DEFINITION_TEXT_LIMIT);
  char key[KEY_SIZE], value[TABOR_TEXT_SIZE];
  size_t length = 0;
  if (!text) return NULL;
  for (uint32_t i = 0; tabor_drum_def_key(def, i, key, sizeof key); i++) {
    if (tabor_drum_def_get(def, key, value, sizeof value, NULL) != TABOR_OK) continue;
    length +=
      (size_t)snprintf(text + length, DEFINITION_TEXT_LIMIT - length, "%s = %s\n", key, value);
  }
  return text;
}

static bool refuse(TaborError *error, const char *message) {
  *error = (TaborError){.status = TABOR_ERROR_VALUE, .minimum = NAN, .maximum = NAN};
  (void)snprintf(error->message, sizeof error->message, "%s", message);
  return false;
}

/* The line is cut into key and value. */
static bool read_line(char *line, TaborDrumDef *def, TaborError *error) {
  char *const equals = strstr(line, " = ");
  if (!*line) return true;
  if (!equals) return refuse(error, "a line of the definition is not 'key = value'");
  *equals = '\0';
  const TaborStatus status = tabor_drum_def_set(def, line, equals + 3, error);
  return status == TABOR_OK || status == TABOR_ERROR_KEY;
}

static bool read_lines(char *text, TaborDrumDef *def, TaborError *error) {
  for (char *line = text; line;) {
    char *const end = strchr(line, '\n');
    if (end) *end = '\0';
    if (!read_line(line, def, error)) return false;
    line = end ? end + 1 : NULL;
  }
  return true;
}

bool definition_read(const char *text, size_t size, TaborDrumDef *def, TaborError *error) {
  TaborDrumDef read;
  if (size > DEFINITION_TEXT_LIMIT) return refuse(error, "the definition is longer than 64 KiB");
  char *const copy = calloc(1, size + 1);
  if (!copy) return refuse(error, "out of memory");
  memcpy(copy, text, size);
  tabor_drum_def_clear(&read);
  bool is_good = read_lines(copy, &read, error);
  free(copy);
  if (is_good && read.mic_count == 0) is_good = refuse(error, "the drum has no microphone");
  if (is_good) is_good = tabor_drum_def_validate(&read, error) == TABOR_OK;
  if (is_good) *def = read;
  return is_good;
}
