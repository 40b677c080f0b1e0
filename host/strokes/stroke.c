/* SPDX-License-Identifier: MIT */
#include "strokes/stroke.h"

#include <stdio.h>
#include <string.h>

#include "base/number.h"
#include "base/suggest.h"
#include "drums/drum_args.h"

#define LONGEST_VALUE 128
#define LONGEST_LABEL 320

/* What a field is called in messages, as "--strike time". */
typedef struct Label {
  char text[LONGEST_LABEL];
} Label;

struct StrokeField {
  const char *name;
  Outcome (*read)(Stroke *stroke, const Label *label, const char *value);
  unsigned sets; /* no two fields of a stroke may set the same */
};

/* stroke_begin() has taken it. */
static Outcome read_drum(Stroke *stroke, const Label *label, const char *value) {
  (void)stroke, (void)label, (void)value;
  return OUTCOME_OK;
}

static Outcome read_time(Stroke *stroke, const Label *label, const char *value) {
  const NumberField field = {label->text, 0, 3600, false};
  return number_read(&field, value, &stroke->time);
}

/* The limits of a field that [strike] has, too. */
static NumberField preset_field(const Label *label, const char *key) {
  const TaborParameter *const parameter = tabor_parameter_find(key);
  return (NumberField){label->text, parameter->minimum, parameter->maximum, false};
}

static Outcome read_velocity(Stroke *stroke, const Label *label, const char *value) {
  const NumberField field = preset_field(label, "strike.velocity");
  return number_read(&field, value, &stroke->event.velocity);
}

/* The speed of a MIDI note. */
static Outcome read_midi(Stroke *stroke, const Label *label, const char *value) {
  const NumberField field = {label->text, 1, 127, true};
  double velocity = 0;
  const Outcome outcome = number_read(&field, value, &velocity);
  stroke->event.velocity = midi_speed(stroke->response, velocity);
  return outcome;
}

static Outcome read_percent(Stroke *stroke, const Label *label, const char *value) {
  char number[LONGEST_VALUE], text[LONGEST_LABEL + 16];
  const size_t length = strlen(value) - 1;
  memcpy(number, value, length);
  number[length] = '\0';
  (void)snprintf(text, sizeof text, "%s in per cent", label->text);
  const NumberField field = {text, 0, 100, false};
  double percent = 0;
  const Outcome outcome = number_read(&field, number, &percent);
  stroke->event.radius = stroke->def->shell.radius * percent / 100;
  return outcome;
}

/* Metres, or per cent of the head's radius. */
static Outcome read_radius(Stroke *stroke, const Label *label, const char *value) {
  const size_t length = strlen(value);
  if (length > 0 && value[length - 1] == '%') return read_percent(stroke, label, value);
  const NumberField field = {label->text, 0, stroke->def->shell.radius, false};
  return number_read(&field, value, &stroke->event.radius);
}

static Outcome read_angle(Stroke *stroke, const Label *label, const char *value) {
  const NumberField field = preset_field(label, "strike.angle");
  return number_read(&field, value, &stroke->event.angle);
}

static Outcome read_striker(Stroke *stroke, const Label *label, const char *value) {
  const int index = tabor_drum_def_find_striker(stroke->def, value);
  char hint[512];
  suggest_choice(hint, sizeof hint, value, "", drum_striker_name, stroke->def);
  if (index < 0) {
    return refuse("%s '%s': the drum has no such striker%s", label->text, value, hint);
  }
  stroke->event.striker = (uint32_t)index;
  return OUTCOME_OK;
}

const char *const technique_names[TECHNIQUE_NAMES] = {
  [TABOR_TECHNIQUE_NORMAL] = "normal",   [TABOR_TECHNIQUE_BUZZ] = "buzz",
  [TABOR_TECHNIQUE_RIMSHOT] = "rimshot", [TABOR_TECHNIQUE_CROSS_STICK] = "cross-stick",
  [TABOR_TECHNIQUE_RIM] = "rim",         [TABOR_TECHNIQUE_SWEEP] = "sweep",
  [TABOR_TECHNIQUE_PLUCK] = "pluck",     [TABOR_TECHNIQUE_PEDAL] = "pedal",
};

/* The order in which they are suggested. */
static const TaborTechnique techniques[TECHNIQUE_NAMES] = {
  TABOR_TECHNIQUE_NORMAL, TABOR_TECHNIQUE_RIMSHOT, TABOR_TECHNIQUE_CROSS_STICK,
  TABOR_TECHNIQUE_RIM,    TABOR_TECHNIQUE_BUZZ,    TABOR_TECHNIQUE_SWEEP,
  TABOR_TECHNIQUE_PEDAL,  TABOR_TECHNIQUE_PLUCK};

static const char *technique_at(const void *list, size_t index) {
  (void)list;
  return index < TECHNIQUE_NAMES ? technique_names[techniques[index]] : NULL;
}

static Outcome read_technique(Stroke *stroke, const Label *label, const char *value) {
  for (size_t i = 0; technique_at(NULL, i); i++) {
    if (strcmp(value, technique_at(NULL, i)) != 0) continue;
    stroke->event.technique = (uint32_t)techniques[i];
    return OUTCOME_OK;
  }
  char hint[160];
  suggest_choice(hint, sizeof hint, value, "", technique_at, NULL);
  return refuse("%s '%s': unknown%s", label->text, value, hint);
}

static Outcome read_pressure(Stroke *stroke, const Label *label, const char *value) {
  const NumberField field = {label->text, 0, 1, false};
  return number_read(&field, value, &stroke->event.value);
}

static Outcome read_hold(Stroke *stroke, const Label *label, const char *value) {
  const NumberField field = {label->text, 0.001, 60, false};
  return number_read(&field, value, &stroke->hold);
}

static Outcome read_id(Stroke *stroke, const Label *label, const char *value) {
  const NumberField field = {label->text, 0, STROKE_MOST_ID, true};
  double id = 0;
  const Outcome outcome = number_read(&field, value, &id);
  stroke->event.id = (uint32_t)id;
  return outcome;
}

static const char *event_at(const void *list, size_t index) {
  (void)list;
  static const char *const names[] = {"strike", "press", "release", "move", NULL};
  return names[index];
}

static Outcome read_event(Stroke *stroke, const Label *label, const char *value) {
  static const TaborEventType types[] = {TABOR_EVENT_STRIKE, TABOR_EVENT_PRESS, TABOR_EVENT_RELEASE,
                                         TABOR_EVENT_MOVE};
  for (size_t i = 0; event_at(NULL, i); i++) {
    if (strcmp(value, event_at(NULL, i)) != 0) continue;
    stroke->event.type = types[i];
    return OUTCOME_OK;
  }
  char hint[160];
  suggest_choice(hint, sizeof hint, value, "", event_at, NULL);
  return refuse("%s '%s': unknown%s", label->text, value, hint);
}

static Outcome read_wire(Stroke *stroke, const Label *label, const char *value) {
  const uint32_t wires = stroke->def->wires.count; /* without any, the stroke is refused */
  const NumberField field = {label->text, 1, wires > 0 ? wires : TABOR_MAX_WIRES, true};
  return number_read(&field, value, &stroke->pluck.wire);
}

static Outcome read_place(Stroke *stroke, const Label *label, const char *value) {
  const NumberField field = {label->text, 0, 1, false};
  return number_read(&field, value, &stroke->pluck.place);
}

static Outcome read_displacement(Stroke *stroke, const Label *label, const char *value) {
  const NumberField field = {label->text, 1e-6, 0.05, false};
  return number_read(&field, value, &stroke->pluck.displacement);
}

static Outcome read_pull(Stroke *stroke, const Label *label, const char *value) {
  const NumberField field = {label->text, 1e-4, 10, false};
  return number_read(&field, value, &stroke->pluck.pull);
}

#define SETS_VELOCITY 2u
#define SETS_RADIUS 4u
#define SETS_ANGLE 8u
#define SETS_STRIKER 16u
#define SETS_PRESSURE 64u
#define SETS_HOLD 128u
#define SETS_WIRE 1024u
#define SETS_PLACE 2048u
#define SETS_DISPLACEMENT 4096u
#define SETS_PULL 8192u
#define SETS_OF_PLUCKS (SETS_WIRE | SETS_PLACE | SETS_DISPLACEMENT | SETS_PULL)
#define SETS_OF_OTHERS                                                                             \
  (SETS_VELOCITY | SETS_RADIUS | SETS_ANGLE | SETS_STRIKER | SETS_PRESSURE | SETS_HOLD)

static const StrokeField fields[STROKE_FIELDS] = {
  {"time", read_time, 1},
  {"velocity", read_velocity, SETS_VELOCITY},
  {"midi", read_midi, SETS_VELOCITY},
  {"radius", read_radius, SETS_RADIUS},
  {"angle", read_angle, SETS_ANGLE},
  {"striker", read_striker, SETS_STRIKER},
  {"technique", read_technique, 32},
  {"pressure", read_pressure, SETS_PRESSURE},
  {"hold", read_hold, SETS_HOLD},
  {"id", read_id, 256},
  {"event", read_event, 512},
  {"wire", read_wire, SETS_WIRE},
  {"place", read_place, SETS_PLACE},
  {"displacement", read_displacement, SETS_DISPLACEMENT},
  {"pull", read_pull, SETS_PULL},
  {"drum", read_drum, 16384},
};

static const char *field_name_at(const void *list, size_t index) {
  (void)list;
  return index < STROKE_FIELDS ? fields[index].name : NULL;
}

const StrokeField *stroke_field(const char *name, size_t length) {
  for (size_t i = 0; i < STROKE_FIELDS; i++) {
    if (strlen(fields[i].name) == length && memcmp(fields[i].name, name, length) == 0) {
      return &fields[i];
    }
  }
  return NULL;
}

const char *stroke_field_name(const StrokeField *field) { return field->name; }

Outcome stroke_unknown_field(const char *where, const char *kind, const char *name, size_t length) {
  char word[32] = "", hint[160];
  if (length < sizeof word) {
    memcpy(word, name, length);
    word[length] = '\0';
  }
  suggest_choice(hint, sizeof hint, word, "", field_name_at, NULL);
  return refuse("%s unknown %s '%.*s'%s", where, kind, (int)(length < 80 ? length : 80), name,
                hint);
}

Stroke stroke_default(const TaborDrumDef *def, const char *where) {
  const int striker = tabor_drum_def_find_striker(def, def->strike.striker);
  return (Stroke){.def = def,
                  .where = where,
                  .hold = STROKE_HOLD,
                  .response = midi_response_default,
                  .pluck = {.wire = 1, .place = 0.3, .displacement = 3e-3, .pull = 0.01},
                  .event = {.type = TABOR_EVENT_STRIKE,
                            .striker = striker > 0 ? (uint32_t)striker : 0,
                            .velocity = def->strike.velocity,
                            .radius = def->strike.radius,
                            .angle = def->strike.angle,
                            .technique = def->strike.technique}};
}

bool stroke_field_is_drum(const StrokeField *field) { return field->read == read_drum; }

Outcome stroke_begin(const StrokeTarget *target, const char *where, const char *name, size_t length,
                     Stroke *stroke) {
  char word[TABOR_NAME_SIZE] = "", hint[512];
  if (!target->kit) {
    *stroke = stroke_default(target->def, where);
    return name ? refuse("%s drum: only a kit's strokes have one", where) : OUTCOME_OK;
  }
  if (name && length < sizeof word) memcpy(word, name, length);
  const int drum = tabor_kit_def_find(target->kit, word);
  suggest_choice(hint, sizeof hint, word, "", kit_drum_name, target->kit);
  if (!name) return refuse("%s drum: a kit's stroke needs one%s", where, hint);
  if (drum < 0) {
    return refuse("%s drum '%.*s': the kit has no such drum%s", where,
                  (int)(length < 80 ? length : 80), name, hint);
  }
  *stroke = stroke_default(&target->kit->drum[drum].def, where);
  stroke->kit = target->kit;
  stroke->drum = (uint32_t)drum;
  return OUTCOME_OK;
}

bool stroke_says_hold(const Stroke *stroke) { return stroke->set & SETS_HOLD; }

/* How fast a brush is drawn is limited as its preset's speed is, below the speed of strokes. */
static Outcome limit_sweep(const Stroke *stroke, const TaborEvent *event) {
  const TaborParameter *const speed = tabor_parameter_find("striker.brush.sweep_speed");
  if (event->velocity >= speed->minimum && event->velocity <= speed->maximum) return OUTCOME_OK;
  return refuse("%s velocity '%.10g': out of range for a sweep; allowed: %.10g to %.10g",
                stroke->where, event->velocity, speed->minimum, speed->maximum);
}

bool stroke_is_held(const TaborEvent *event) {
  return event->type == TABOR_EVENT_STRIKE &&
         (event->technique == TABOR_TECHNIQUE_BUZZ || event->technique == TABOR_TECHNIQUE_SWEEP);
}

bool striker_can(const TaborStrikerDef *striker, TaborTechnique technique) {
  const bool brush = striker->kind == TABOR_STRIKER_BRUSH;
  if (technique == TABOR_TECHNIQUE_SWEEP) return brush;
  return !brush ||
         (technique != TABOR_TECHNIQUE_RIMSHOT && technique != TABOR_TECHNIQUE_CROSS_STICK);
}

static Outcome fit_technique(const Stroke *stroke, const TaborEvent *event) {
  if (event->technique == TABOR_TECHNIQUE_PEDAL && stroke->def->body.kind != TABOR_BODY_HIHAT) {
    return refuse("%s technique 'pedal': the drum has no pedal", stroke->where);
  }
  const TaborStrikerDef *const striker = &stroke->def->striker[event->striker];
  const char *const technique = technique_names[event->technique];
  if (!striker_can(striker, (TaborTechnique)event->technique)) {
    return refuse("%s technique '%s': striker '%s' is %s", stroke->where, technique, striker->name,
                  event->technique == TABOR_TECHNIQUE_SWEEP
                    ? "no brush"
                    : "a brush, which has no shaft to meet the hoop");
  }
  if (stroke->set & (SETS_PRESSURE | SETS_HOLD) && !stroke_is_held(event)) {
    return refuse("%s %s: only strokes of technique buzz or sweep have one", stroke->where,
                  stroke->set & SETS_HOLD ? "hold" : "pressure");
  }
  return OUTCOME_OK;
}

/* The name of the first field in a set of which the stroke has one. */
static const char *field_among(const Stroke *stroke, unsigned set) {
  size_t i = 0;
  while (!(fields[i].sets & set & stroke->set)) i++;
  return fields[i].name;
}

/* A finger on a wire: its fields of the event are those of tabor.h. */
static Outcome complete_pluck(const Stroke *stroke, TaborEvent *event) {
  const uint32_t wires = stroke->def->wires.count;
  const Pluck *const pluck = &stroke->pluck;
  if (wires == 0) return refuse("%s technique 'pluck': the drum has no wires", stroke->where);
  if (stroke->set & SETS_OF_OTHERS) {
    return refuse("%s %s: a pluck has none; it has wire, place, displacement and pull",
                  stroke->where, field_among(stroke, SETS_OF_OTHERS));
  }
  event->striker = (uint32_t)pluck->wire - 1;
  event->radius = pluck->place;
  event->angle = 0;
  event->value = pluck->displacement;
  event->velocity = pluck->displacement / pluck->pull;
  return OUTCOME_OK;
}

Outcome stroke_complete(const Stroke *stroke, TaborEvent *event) {
  const bool plucks =
    event->type == TABOR_EVENT_STRIKE && event->technique == TABOR_TECHNIQUE_PLUCK;
  if (plucks) return complete_pluck(stroke, event);
  if (stroke->set & SETS_OF_PLUCKS) {
    return refuse("%s %s: only strokes of technique pluck have one", stroke->where,
                  field_among(stroke, SETS_OF_PLUCKS));
  }
  const TaborStrikerDef *const striker = &stroke->def->striker[event->striker];
  if (event->type == TABOR_EVENT_MOVE) event->value = 0; /* seconds: from row to row */
  if (event->type != TABOR_EVENT_STRIKE) return OUTCOME_OK;
  const Outcome fits = fit_technique(stroke, event);
  if (fits != OUTCOME_OK || event->technique != TABOR_TECHNIQUE_SWEEP) return fits;
  if (!(stroke->set & SETS_VELOCITY)) event->velocity = striker->sweep_speed;
  return limit_sweep(stroke, event);
}

Outcome stroke_set(Stroke *stroke, const StrokeField *field, const char *value, size_t length) {
  Label label;
  (void)snprintf(label.text, sizeof label.text, "%s %s", stroke->where, field->name);
  if (stroke->set & field->sets) {
    return refuse("%s: given twice%s", label.text,
                  field->sets == SETS_VELOCITY ? " (midi is a velocity, too)" : "");
  }
  stroke->set |= field->sets;
  char text[LONGEST_VALUE];
  if (length >= sizeof text) return refuse("%s: the value is too long", label.text);
  memcpy(text, value, length);
  text[length] = '\0';
  return field->read(stroke, &label, text);
}
