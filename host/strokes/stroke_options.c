/* SPDX-License-Identifier: MIT */
#include "strokes/stroke_options.h"

#include <string.h>

#include "midi/midi_options.h"
#include "strokes/events_file.h"

/* One NAME=VALUE of @p length bytes. */
static Outcome read_field(Stroke *stroke, const char *text, size_t length) {
  const char *const equals = memchr(text, '=', length);
  if (!equals) {
    return refuse("--strike '%.*s': not of the form FIELD=VALUE", (int)(length < 80 ? length : 80),
                  text);
  }
  const size_t name_length = (size_t)(equals - text);
  const StrokeField *const field = stroke_field(text, name_length);
  if (!field) return stroke_unknown_field("--strike:", "field", text, name_length);
  return stroke_set(stroke, field, equals + 1, length - name_length - 1);
}

static Outcome read_stroke(const char *text, Stroke *stroke) {
  Outcome outcome = OUTCOME_OK;
  while (outcome == OUTCOME_OK) {
    const size_t length = strcspn(text, ",");
    outcome = read_field(stroke, text, length);
    if (text[length] == '\0') break;
    text += length + 1;
  }
  return outcome;
}

static Outcome read_options(const Arguments *arguments, const TaborDrumDef *def, Strokes *strokes) {
  Outcome outcome = OUTCOME_OK;
  const char *text;
  size_t position = 0;
  while (outcome == OUTCOME_OK && (text = arguments_next(arguments, "strike", &position))) {
    Stroke stroke = stroke_default(def, "--strike");
    stroke.response = strokes->response;
    outcome = read_stroke(text, &stroke);
    if (outcome == OUTCOME_OK) outcome = strokes_add(strokes, &stroke);
  }
  return outcome;
}

Outcome strokes_read(const Arguments *arguments, const TaborDrumDef *def, double rate,
                     Strokes *strokes) {
  *strokes = (Strokes){.rate = rate, .response = midi_response_default};
  const char *file;
  size_t position = 0;
  Outcome outcome = midi_response_read(arguments, &strokes->response);
  if (outcome == OUTCOME_OK) outcome = read_options(arguments, def, strokes);
  while (outcome == OUTCOME_OK && (file = arguments_next(arguments, "events", &position))) {
    outcome = events_file_read(file, def, strokes);
  }
  if (outcome == OUTCOME_OK && strokes->count == 0 && !arguments_has(arguments, "midi-file") &&
      !arguments_has(arguments, "input")) {
    const Stroke stroke = stroke_default(def, "[strike]");
    outcome = strokes_add(strokes, &stroke);
  }
  if (outcome != OUTCOME_OK || strokes->count == 0) return outcome;
  strokes_sort(strokes);
  return OUTCOME_OK;
}
