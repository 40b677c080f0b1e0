/* SPDX-License-Identifier: MIT */
#include "plugin/choice_text.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>

#define WORD_SIZE 256

uint32_t choice_count(const char *choices) {
  uint32_t count = 1;
  for (; *choices; choices++) count += *choices == '|';
  return count;
}

int choice_text(const char *choices, int number, char *text, uint32_t size) {
  for (; number > 0 && *choices; number--) {
    choices += strcspn(choices, "|");
    choices += *choices == '|';
  }
  return snprintf(text, size, "%.*s", (int)strcspn(choices, "|"), choices);
}

bool choice_find(const char *choices, const char *text, double *value) {
  char word[WORD_SIZE];
  for (int number = 0; choice_text(choices, number, word, sizeof word) > 0; number++) {
    *value = number;
    if (strcasecmp(word, text) == 0) return true;
  }
  return false;
}
