/* SPDX-License-Identifier: MIT */
#include "base/suggest.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#define LONGEST_WORD 64

static size_t smaller(size_t a, size_t b) { return a < b ? a : b; }

/* Optimal string alignment distance, row by row; words longer than LONGEST_WORD are far. */
static size_t edit_distance(const char *a, const char *b) {
  const size_t columns = strlen(b);
  if (strlen(a) > LONGEST_WORD || columns > LONGEST_WORD) return LONGEST_WORD;
  size_t rows[3][LONGEST_WORD + 1]; /* of i - 2, i - 1 and i characters of a */
  size_t *before = rows[0], *last = rows[1], *row = rows[2];
  for (size_t j = 0; j <= columns; j++) last[j] = j;
  for (size_t i = 1; a[i - 1]; i++) {
    row[0] = i;
    for (size_t j = 1; j <= columns; j++) {
      const size_t change = last[j - 1] + (a[i - 1] != b[j - 1]);
      row[j] = smaller(change, smaller(last[j], row[j - 1]) + 1);
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = smaller(row[j], before[j - 2] + 1);
      }
    }
    size_t *const spare = before;
    before = last;
    last = row;
    row = spare;
  }
  return last[columns];
}

/* An abbreviation counts as one change. */
static size_t distance_to(const char *word, size_t length, const char *name) {
  const bool abbreviates = length >= 2 && strncmp(word, name, length) == 0;
  return abbreviates ? strlen(name) != length : edit_distance(word, name);
}

const char *suggest(const char *word, NameAt *name_at, const void *list) {
  const size_t length = strlen(word);
  const char *nearest = NULL;
  size_t best = length < 3 ? length : length / 3 + 1; /* only nearer ones count */
  const char *name;
  for (size_t i = 0; (name = name_at(list, i)) != NULL; i++) {
    const size_t distance = distance_to(word, length, name);
    if (distance < best) {
      nearest = name;
      best = distance;
    }
  }
  return nearest;
}

const char *suggest_hint(char *hint, size_t size, const char *word, const char *prefix,
                         NameAt *name_at, const void *list) {
  const char *const nearest = suggest(word, name_at, list);
  if (nearest) {
    (void)snprintf(hint, size, "; did you mean '%s%s'?", prefix, nearest);
  } else {
    hint[0] = '\0';
  }
  return hint;
}

const char *suggest_choice(char *hint, size_t size, const char *word, const char *prefix,
                           NameAt *name_at, const void *list) {
  static const char dots[] = ", ...";
  suggest_hint(hint, size, word, prefix, name_at, list);
  if (*hint || size <= sizeof dots) return hint;
  size_t length = 0;
  const char *name;
  for (size_t i = 0; (name = name_at(list, i)) != NULL; i++) {
    const char *const before = i > 0 ? ", " : "; there are: ";
    if (length + strlen(before) + strlen(prefix) + strlen(name) + sizeof dots > size) {
      (void)snprintf(hint + length, size - length, "%s", dots);
      break;
    }
    length += (size_t)snprintf(hint + length, size - length, "%s%s%s", before, prefix, name);
  }
  return hint;
}
