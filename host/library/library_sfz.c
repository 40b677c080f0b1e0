/* SPDX-License-Identifier: MIT */
#include "library/library_sfz.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/text_file.h"

/* Text that grows. */
typedef struct Text {
  char *bytes; /* NULL: memory was short, or nothing was added */
  size_t length, capacity;
  bool is_complete;
} Text;

static bool make_room(Text *text, size_t length) {
  if (text->length + length < text->capacity) return true;
  const size_t capacity = 2 * (text->length + length) + 1024;
  char *const grown = realloc(text->bytes, capacity);
  if (!grown) return false;
  text->bytes = grown;
  text->capacity = capacity;
  return true;
}

PRINTF_AT(2, 3) static void add(Text *text, const char *format, ...) {
  va_list arguments, again;
  va_start(arguments, format);
  va_copy(again, arguments);
  const int length = vsnprintf(NULL, 0, format, arguments);
  text->is_complete = text->is_complete && length >= 0 && make_room(text, (size_t)length);
  if (text->is_complete) {
    (void)vsnprintf(text->bytes + text->length, (size_t)length + 1, format, again);
    text->length += (size_t)length;
  }
  va_end(again);
  va_end(arguments);
}

static void print_head(Text *text, const LibraryRequest *request) {
  const LibraryShape *const shape = &request->plan.shape;
  add(text,
      "// %s, computed by tabor %s\n"
      "// %zu sounds: velocities %u, positions %u, takes %u\n"
      "// The sounds have the levels of their strokes: no velocity tracking on top of that.\n\n"
      "<global>\n"
      "loop_mode=one_shot\n"
      "amp_veltrack=0\n",
      request->stem, tabor_version(), request->plan.count, (unsigned)shape->velocities,
      (unsigned)shape->positions, (unsigned)shape->takes);
}

/* Of the takes of one velocity at one place. */
static void print_group(Text *text, const LibrarySound *sound, const LibraryShape *shape) {
  add(text, "\n// %s, %u %% of the radius, %.3g m/s\n<group>\nkey=%u\nlovel=%u\nhivel=%u\n",
      sound->technique->name, (unsigned)sound->radius_share,
      midi_speed(shape->response, sound->midi), (unsigned)sound->key, (unsigned)sound->low,
      (unsigned)sound->high);
  if (shape->takes > 1) add(text, "seq_length=%u\n", (unsigned)shape->takes);
}

static void print_sound(Text *text, const LibrarySound *sound, const LibraryShape *shape) {
  if (sound->take == 1) print_group(text, sound, shape);
  add(text, "<region>\n");
  if (shape->takes > 1) add(text, "seq_position=%u\n", (unsigned)sound->take);
  add(text, "sample=%s\n", sound->file);
}

static Outcome print_text(const LibraryRequest *request, Text *text) {
  print_head(text, request);
  for (size_t i = 0; i < request->plan.count; i++) {
    print_sound(text, &request->plan.sounds[i], &request->plan.shape);
  }
  return text->is_complete ? OUTCOME_OK : fail_memory();
}

Outcome library_sfz_write(const LibraryRequest *request, const char *path) {
  Text text = {.is_complete = true};
  Outcome outcome = print_text(request, &text);
  const bool is_there = outcome == OUTCOME_OK && text_file_holds(path, text.bytes);
  if (outcome == OUTCOME_OK && !is_there) outcome = text_file_write(path, text.bytes, false);
  free(text.bytes);
  return outcome;
}
