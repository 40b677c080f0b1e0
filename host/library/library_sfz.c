/* SPDX-License-Identifier: MIT */
#include "library/library_sfz.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/text_file.h"
#include "library/library_kit.h"

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
      "// %zu sounds: velocities %u, %s %u, takes %u\n"
      "// The sounds have the levels of their strokes: no velocity tracking on top of that.\n\n"
      "<global>\n"
      "loop_mode=one_shot\n"
      "amp_veltrack=0\n",
      request->stem, tabor_version(), request->plan.count, (unsigned)shape->velocities,
      request->kit ? "drums" : "positions",
      (unsigned)(request->kit ? request->kit->def.drum_count : shape->positions),
      (unsigned)shape->takes);
}

/* Of one velocity at one place of a drum, or of one kind of stroke on a drum of a kit. */
static void print_title(Text *text, const LibraryRequest *request, const LibrarySound *sound) {
  const double speed = midi_speed(request->plan.shape.response, sound->midi);
  if (request->kit) {
    add(text, "\n// %s, %s, %.3g m/s\n", request->kit->def.drum[sound->drum].name, sound->technique,
        speed);
  } else {
    add(text, "\n// %s, %u %% of the radius, %.3g m/s\n", sound->technique,
        (unsigned)sound->radius_share, speed);
  }
}

/* The takes of one velocity on one key. */
static void print_group(Text *text, const LibrarySound *sounds, uint32_t takes, uint8_t key) {
  add(text, "<group>\nkey=%u\nlovel=%u\nhivel=%u\n", (unsigned)key, (unsigned)sounds[0].low,
      (unsigned)sounds[0].high);
  if (takes > 1) add(text, "seq_length=%u\n", (unsigned)takes);
  for (uint32_t i = 0; i < takes; i++) {
    add(text, "<region>\n");
    if (takes > 1) add(text, "seq_position=%u\n", (unsigned)sounds[i].take);
    add(text, "sample=%s\n", sounds[i].file);
  }
}

static Outcome print_text(const LibraryRequest *request, Text *text) {
  print_head(text, request);
  const LibraryPlan *const plan = &request->plan;
  for (size_t i = 0; i < plan->count; i += plan->shape.takes) {
    const LibrarySound *const sounds = &plan->sounds[i];
    print_title(text, request, sounds);
    for (uint32_t k = 0; k < sounds->key_count; k++) {
      print_group(text, sounds, plan->shape.takes, sounds->keys[k]);
    }
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
