/* SPDX-License-Identifier: MIT */
#include "strokes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"
#include "suggest.h"

#define LONGEST_VALUE 128

/* One --strike while it is being read. */
typedef struct Stroke {
  const TaborDrumDef *def;
  double time; /* [s] */
  TaborEvent event;
} Stroke;

static Outcome read_time(Stroke *stroke, const char *value) {
  static const NumberField field = {"--strike time", 0, 3600, false};
  return number_read(&field, value, &stroke->time);
}

/* The limits of a field that [strike] has, too. */
static NumberField preset_field(const char *name, const char *key) {
  const TaborParameter *const parameter = tabor_parameter_find(key);
  return (NumberField){name, parameter->minimum, parameter->maximum, false};
}

static Outcome read_velocity(Stroke *stroke, const char *value) {
  const NumberField field = preset_field("--strike velocity", "strike.velocity");
  return number_read(&field, value, &stroke->event.velocity);
}

/* The speed of a MIDI key: in ratios from 0.3 m/s for 1 to 12 m/s for 127. */
static Outcome read_midi(Stroke *stroke, const char *value) {
  static const NumberField field = {"--strike midi", 1, 127, true};
  double velocity = 0;
  const Outcome outcome = number_read(&field, value, &velocity);
  stroke->event.velocity = 0.3 * pow(12 / 0.3, (velocity - 1) / 126);
  return outcome;
}

/* Metres, or per cent of the head's radius. */
static Outcome read_radius(Stroke *stroke, const char *value) {
  const double head = stroke->def->shell.radius;
  const size_t length = strlen(value);
  if (length == 0 || value[length - 1] != '%') {
    const NumberField field = {"--strike radius", 0, head, false};
    return number_read(&field, value, &stroke->event.radius);
  }
  static const NumberField field = {"--strike radius in per cent", 0, 100, false};
  char number[LONGEST_VALUE];
  memcpy(number, value, length - 1);
  number[length - 1] = '\0';
  double percent = 0;
  const Outcome outcome = number_read(&field, number, &percent);
  stroke->event.radius = head * percent / 100;
  return outcome;
}

static Outcome read_angle(Stroke *stroke, const char *value) {
  const NumberField field = preset_field("--strike angle", "strike.angle");
  return number_read(&field, value, &stroke->event.angle);
}

static const char *striker_name_at(const void *def, size_t index) {
  const TaborDrumDef *const drum = def;
  return index < drum->striker_count ? drum->striker[index].name : NULL;
}

static Outcome read_striker(Stroke *stroke, const char *value) {
  const int index = tabor_drum_def_find_striker(stroke->def, value);
  char hint[96];
  suggest_hint(hint, sizeof hint, value, "", striker_name_at, stroke->def);
  if (index < 0)
    return refuse("--strike striker '%s': the drum has no such striker%s", value, hint);
  stroke->event.striker = (uint32_t)index;
  return OUTCOME_OK;
}

static const char *technique_at(const void *list, size_t index) {
  (void)list;
  static const char *const names[] = {"normal", "rimshot", "cross-stick", "rim",
                                      "buzz",   "sweep",   NULL};
  return names[index];
}

static Outcome read_technique(Stroke *stroke, const char *value) {
  (void)stroke;
  if (strcmp(value, technique_at(NULL, 0)) == 0) return OUTCOME_OK;
  for (size_t i = 1; technique_at(NULL, i); i++) {
    if (strcmp(value, technique_at(NULL, i)) == 0) {
      return refuse("--strike technique '%s': not in this version, only 'normal'", value);
    }
  }
  char hint[96];
  suggest_hint(hint, sizeof hint, value, "", technique_at, NULL);
  return refuse("--strike technique '%s': unknown%s", value, hint);
}

static const struct StrokeField {
  const char *name;
  Outcome (*read)(Stroke *stroke, const char *value);
  unsigned sets; /* no two fields of a stroke may set the same */
} fields[] = {
  {"time", read_time, 1},
  {"velocity", read_velocity, 2},
  {"midi", read_midi, 2},
  {"radius", read_radius, 4},
  {"angle", read_angle, 8},
  {"striker", read_striker, 16},
  {"technique", read_technique, 32},
};
#define FIELD_COUNT (sizeof fields / sizeof fields[0])

static const char *field_name_at(const void *list, size_t index) {
  (void)list;
  return index < FIELD_COUNT ? fields[index].name : NULL;
}

static const struct StrokeField *find_field(const char *name, size_t length) {
  for (size_t i = 0; i < FIELD_COUNT; i++) {
    if (strlen(fields[i].name) == length && memcmp(fields[i].name, name, length) == 0) {
      return &fields[i];
    }
  }
  return NULL;
}

static Outcome unknown_field(const char *text, size_t length) {
  char name[32] = "", hint[96];
  if (length < sizeof name) {
    memcpy(name, text, length);
    name[length] = '\0';
  }
  suggest_hint(hint, sizeof hint, name, "", field_name_at, NULL);
  return refuse("--strike: unknown field '%.*s'%s", (int)(length < 80 ? length : 80), text, hint);
}

/* One NAME=VALUE of @p length bytes. */
static Outcome read_field(Stroke *stroke, const char *text, size_t length, unsigned *set) {
  const char *const equals = memchr(text, '=', length);
  if (!equals) {
    return refuse("--strike '%.*s': not of the form FIELD=VALUE", (int)(length < 80 ? length : 80),
                  text);
  }
  const size_t name_length = (size_t)(equals - text);
  const size_t value_length = length - name_length - 1;
  const struct StrokeField *const field = find_field(text, name_length);
  if (!field) return unknown_field(text, name_length);
  if (*set & field->sets) {
    return refuse("--strike: '%s' given twice%s", field->name,
                  field->sets == 2 ? " (midi is a velocity, too)" : "");
  }
  *set |= field->sets;
  char value[LONGEST_VALUE];
  if (value_length >= sizeof value)
    return refuse("--strike %s: the value is too long", field->name);
  memcpy(value, equals + 1, value_length);
  value[value_length] = '\0';
  return field->read(stroke, value);
}

static Stroke default_stroke(const TaborDrumDef *def) {
  const int striker = tabor_drum_def_find_striker(def, def->strike.striker);
  return (Stroke){.def = def,
                  .event = {.type = TABOR_EVENT_STRIKE,
                            .striker = striker > 0 ? (uint32_t)striker : 0,
                            .velocity = def->strike.velocity,
                            .radius = def->strike.radius,
                            .angle = def->strike.angle}};
}

static Outcome read_stroke(const char *text, Stroke *stroke) {
  Outcome outcome = OUTCOME_OK;
  unsigned set = 0;
  while (outcome == OUTCOME_OK) {
    const size_t length = strcspn(text, ",");
    outcome = read_field(stroke, text, length, &set);
    if (text[length] == '\0') break;
    text += length + 1;
  }
  return outcome;
}

static void add_stroke(Strokes *strokes, const Stroke *stroke, double rate) {
  TaborEvent *const event = &strokes->events[strokes->count++];
  *event = stroke->event;
  event->frame = (uint32_t)llround(stroke->time * rate); /* 3600 s at 192 kHz is below 2^30 */
  event->id = (uint32_t)strokes->count;
}

/* By time; strokes of one frame stay in the order in which they were given. */
static int compare_events(const void *left, const void *right) {
  const TaborEvent *const a = left, *const b = right;
  if (a->frame != b->frame) return a->frame < b->frame ? -1 : 1;
  return a->id < b->id ? -1 : a->id > b->id;
}

static size_t count_strikes(const Arguments *arguments) {
  size_t count = 0, position = 0;
  while (arguments_next(arguments, "strike", &position)) count++;
  return count;
}

Outcome strokes_read(const Arguments *arguments, const TaborDrumDef *def, double rate,
                     Strokes *strokes) {
  *strokes = (Strokes){0};
  const size_t given = count_strikes(arguments);
  if (given > MOST_STROKES)
    return refuse("--strike: %zu strokes; allowed: up to %d", given, MOST_STROKES);
  strokes->events = calloc(given + 1, sizeof *strokes->events);
  if (!strokes->events) return fail_memory();
  Stroke stroke = default_stroke(def);
  if (given == 0) add_stroke(strokes, &stroke, rate);
  const char *text;
  size_t position = 0;
  while ((text = arguments_next(arguments, "strike", &position)) != NULL) {
    stroke = default_stroke(def);
    const Outcome outcome = read_stroke(text, &stroke);
    if (outcome != OUTCOME_OK) return outcome;
    add_stroke(strokes, &stroke, rate);
  }
  qsort(strokes->events, strokes->count, sizeof *strokes->events, compare_events);
  return OUTCOME_OK;
}

void strokes_free(Strokes *strokes) {
  free(strokes->events);
  *strokes = (Strokes){0};
}

uint32_t strokes_last_frame(const Strokes *strokes) {
  return strokes->events[strokes->count - 1].frame;
}
