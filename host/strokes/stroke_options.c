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

/* Value of the field "drum" in a list of fields, and its length; NULL: it has none. */
static const char *find_drum(const char *text, size_t *length) {
  static const char name[] = "drum=";
  while (strncmp(text, name, sizeof name - 1) != 0) {
    text += strcspn(text, ",");
    if (*text++ == '\0') return NULL;
  }
  text += sizeof name - 1;
  *length = strcspn(text, ",");
  return text;
}

static Outcome read_fields(const char *text, Stroke *stroke) {
  Outcome outcome = OUTCOME_OK;
  while (outcome == OUTCOME_OK) {
    const size_t length = strcspn(text, ",");
    outcome = read_field(stroke, text, length);
    if (text[length] == '\0') break;
    text += length + 1;
  }
  return outcome;
}

static Outcome read_stroke(const char *text, const StrokeTarget *target, Strokes *strokes) {
  size_t length = 0;
  Stroke stroke;
  const char *const drum = find_drum(text, &length);
  Outcome outcome = stroke_begin(target, "--strike", drum, length, &stroke);
  if (outcome != OUTCOME_OK) return outcome;
  stroke.response = strokes->response;
  outcome = read_fields(text, &stroke);
  return outcome == OUTCOME_OK ? strokes_add(&strokes[stroke.drum], &stroke) : outcome;
}

/* All of --strike and --events, not sorted. */
static Outcome read_all(const Arguments *arguments, const StrokeTarget *target, Strokes *strokes) {
  Outcome outcome = OUTCOME_OK;
  const char *text;
  size_t position = 0;
  while (outcome == OUTCOME_OK && (text = arguments_next(arguments, "strike", &position))) {
    outcome = read_stroke(text, target, strokes);
  }
  position = 0;
  while (outcome == OUTCOME_OK && (text = arguments_next(arguments, "events", &position))) {
    outcome = events_file_read(text, target, strokes);
  }
  return outcome;
}

Outcome strokes_read(const Arguments *arguments, const TaborDrumDef *def, double rate,
                     Strokes *strokes) {
  const StrokeTarget target = {.def = def};
  *strokes = (Strokes){.rate = rate, .response = midi_response_default};
  Outcome outcome = midi_response_read(arguments, &strokes->response);
  if (outcome == OUTCOME_OK) outcome = read_all(arguments, &target, strokes);
  if (outcome == OUTCOME_OK && strokes->count == 0 && !arguments_has(arguments, "midi-file") &&
      !arguments_has(arguments, "input")) {
    const Stroke stroke = stroke_default(def, "[strike]");
    outcome = strokes_add(strokes, &stroke);
  }
  if (outcome != OUTCOME_OK || strokes->count == 0) return outcome;
  strokes_sort(strokes);
  return OUTCOME_OK;
}

Outcome strokes_read_for_kit(const Arguments *arguments, const TaborKitDef *kit, double rate,
                             Strokes strokes[TABOR_KIT_DRUMS]) {
  const StrokeTarget target = {.kit = kit};
  MidiResponse response = midi_response_default;
  Outcome outcome = midi_response_read(arguments, &response);
  for (uint32_t i = 0; i < TABOR_KIT_DRUMS; i++) {
    strokes[i] = (Strokes){.rate = rate, .response = response};
  }
  if (outcome == OUTCOME_OK) outcome = read_all(arguments, &target, strokes);
  for (uint32_t i = 0; i < TABOR_KIT_DRUMS; i++) {
    if (strokes[i].count > 0) strokes_sort(&strokes[i]);
  }
  return outcome;
}
