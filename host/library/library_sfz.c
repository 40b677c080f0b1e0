/* SPDX-License-Identifier: MIT */
#include "library/library_sfz.h"

#include <stdio.h>
#include <stdlib.h>

#include "base/text_file.h"

static void print_head(FILE *stream, const LibraryRequest *request) {
  const LibraryShape *const shape = &request->plan.shape;
  (void)fprintf(
    stream,
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
static void print_group(FILE *stream, const LibrarySound *sound, const LibraryShape *shape) {
  (void)fprintf(
    stream, "\n// %s, %u %% of the radius, %.3g m/s\n<group>\nkey=%u\nlovel=%u\nhivel=%u\n",
    sound->technique->name, (unsigned)sound->radius_share, midi_speed(shape->response, sound->midi),
    (unsigned)sound->key, (unsigned)sound->low, (unsigned)sound->high);
  if (shape->takes > 1) (void)fprintf(stream, "seq_length=%u\n", (unsigned)shape->takes);
}

static void print_sound(FILE *stream, const LibrarySound *sound, const LibraryShape *shape) {
  if (sound->take == 1) print_group(stream, sound, shape);
  (void)fprintf(stream, "<region>\n");
  if (shape->takes > 1) (void)fprintf(stream, "seq_position=%u\n", (unsigned)sound->take);
  (void)fprintf(stream, "sample=%s\n", sound->file);
}

static Outcome print_text(const LibraryRequest *request, char **text) {
  size_t size;
  FILE *const stream = open_memstream(text, &size);
  if (!stream) return fail_memory();
  print_head(stream, request);
  for (size_t i = 0; i < request->plan.count; i++) {
    print_sound(stream, &request->plan.sounds[i], &request->plan.shape);
  }
  const bool complete = !ferror(stream);
  return fclose(stream) == 0 && complete ? OUTCOME_OK : fail_memory();
}

Outcome library_sfz_write(const LibraryRequest *request, const char *path) {
  char *text = NULL;
  Outcome outcome = print_text(request, &text);
  const bool is_there = outcome == OUTCOME_OK && text_file_holds(path, text);
  if (outcome == OUTCOME_OK && !is_there) outcome = text_file_write(path, text, false);
  free(text);
  return outcome;
}
