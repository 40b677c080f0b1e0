/* SPDX-License-Identifier: MIT */
#include "plugin/key_name.h"

#include <stdio.h>
#include <string.h>

static const char DRUM[] = "drum."; /* of a kit's drums, and of what a drum says of itself */

const TaborParameter *key_parameter(const char *key) {
  const bool is_of_drum = strncmp(key, DRUM, sizeof DRUM - 1) == 0;
  const char *const dot = is_of_drum ? strchr(key + sizeof DRUM - 1, '.') : NULL;
  return tabor_parameter_find(dot ? dot + 1 : key);
}

size_t key_section(const char *key) {
  const char *const dot = strrchr(key, '.');
  return dot ? (size_t)(dot - key) : 0;
}

bool key_is_same_section(const char *a, const char *b) {
  const size_t length = key_section(a);
  return length == key_section(b) && memcmp(a, b, length) == 0;
}

int key_title(const char *key, char *text, size_t size) {
  const char *const dot = strrchr(key, '.');
  const int length = snprintf(text, size, "%s", dot ? dot + 1 : key);
  for (char *mark = size > 0 ? strchr(text, '_') : NULL; mark; mark = strchr(mark, '_'))
    *mark = ' ';
  return length;
}
