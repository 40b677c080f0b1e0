/* SPDX-License-Identifier: MIT */
#include "base/input_file.h"

#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/part_name.h"
#include "platform/files.h"

#define FIRST_CAPACITY 65536
#define LONGEST_PLACE 200 /* bytes of a path in messages about a line */

/* A program that was killed has left what it wrote under another name. */
static Outcome fail_missing(const char *name) {
  const char *const reason = strerror(ENOENT);
  char *const part = part_name(name, 1);
  const Outcome outcome =
    part && file_exists(part)
      ? fail("cannot read " INPUT ": %s; there is '%.200s', which was not completed",
             INPUT_OF(name), reason, part)
      : fail("cannot read " INPUT ": %s", INPUT_OF(name), reason);
  free(part);
  return outcome;
}

static Outcome fail_reading(const char *name) {
  if (errno == ENOENT) return fail_missing(name);
  if (errno == EISDIR) return fail("cannot read " INPUT ": it is a folder", INPUT_OF(name));
  return fail("cannot read " INPUT ": %s", INPUT_OF(name), strerror(errno));
}

/* One byte more than allowed shows that there are too many. */
static Outcome read_stream(const char *name, FILE *stream, size_t limit, char **bytes,
                           size_t *length) {
  size_t capacity = 0;
  while (*length == capacity && capacity <= limit) {
    capacity = capacity ? 4 * capacity : FIRST_CAPACITY;
    if (capacity > limit) capacity = limit + 1;
    char *const grown = realloc(*bytes, capacity + 1);
    if (!grown) return fail_memory();
    *bytes = grown;
    *length += fread(grown + *length, 1, capacity - *length, stream);
  }
  if (ferror(stream)) return fail_reading(name);
  (*bytes)[*length] = '\0';
  if (*length <= limit) return OUTCOME_OK;
  return refuse("%s: the file is larger than %zu bytes", input_name(name), limit);
}

Outcome input_file_read(const char *name, size_t limit, char **bytes, size_t *length) {
  *bytes = NULL;
  *length = 0;
  if (strcmp(name, "-") == 0) return read_stream(name, stdin, limit, bytes, length);
  FILE *const stream = file_stream_to_read(name);
  if (!stream) return fail_reading(name);
  const Outcome outcome = read_stream(name, stream, limit, bytes, length);
  (void)fclose(stream);
  return outcome;
}

void input_place(char place[INPUT_PLACE_SIZE], const char *name, unsigned line) {
  const char *const shown = input_name(name);
  const size_t length = strlen(shown);
  const bool cut = length > LONGEST_PLACE;
  (void)snprintf(place, INPUT_PLACE_SIZE, "%s%s:%u:", cut ? "..." : "",
                 cut ? shown + length - LONGEST_PLACE : shown, line);
}
