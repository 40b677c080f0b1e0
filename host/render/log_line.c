/* SPDX-License-Identifier: MIT */
#include "render/log_line.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/json_output.h"
#include "drums/definition_text.h"
#include "drums/drum_args.h"
#include "kit/kit_file.h"
#include "kit/kit_values.h"
#include "strokes/stroke.h"

#define KEY_SIZE (2 * TABOR_NAME_SIZE)
#define ENTRY_SIZE (KEY_SIZE + TABOR_TEXT_SIZE + sizeof " = ")
#define MOST_GAIN 1e6                 /* 120 dB */
#define MOST_EXACT 9007199254740992.0 /* 2^53: more frames than anybody plays */

/* Names of the events that are messages of their own; their index is the type. */
static const char *const event_names[] = {
  [TABOR_EVENT_STRIKE] = "strike",       [TABOR_EVENT_PRESS] = "press",
  [TABOR_EVENT_DAMP] = "damp",           [TABOR_EVENT_RELEASE] = "release",
  [TABOR_EVENT_PARAMETER] = "parameter", [TABOR_EVENT_RESET] = "reset",
  [TABOR_EVENT_MOVE] = "move",           [TABOR_EVENT_SILENCE] = "silence",
  [TABOR_EVENT_GAIN] = "gain",
};
#define EVENT_NAMES (sizeof event_names / sizeof event_names[0])

/* Index of a name; -1 if there is none. */
static int find_name(const char *const *names, size_t count, const char *name) {
  for (size_t i = 0; i < count; i++) {
    if (names[i] && strcmp(names[i], name) == 0) return (int)i;
  }
  return -1;
}

/* "wires.strainer"; "mic.gain", as an event has the microphone's index. */
static void parameter_name(const TaborParameter *parameter, char *name, size_t size) {
  const char *const section = parameter->section;
  const size_t length = strcspn(section, ".");
  (void)snprintf(name, size, "%.*s.%s", (int)length, section, parameter->key);
}

/* ---- writing -------------------------------------------------------------------------------- */

static char *write_line(json_t *object) {
  char *const line = json_write_line(object);
  json_decref(object);
  return line;
}

static json_t *integer_json(uint64_t value) { return json_integer((json_int_t)value); }

static json_t *drum_json(const TaborDrumDef *def) {
  char key[KEY_SIZE], value[TABOR_TEXT_SIZE], entry[ENTRY_SIZE];
  json_t *list = json_array();
  for (uint32_t i = 0; tabor_drum_def_key(def, i, key, sizeof key); i++) {
    if (tabor_drum_def_get(def, key, value, sizeof value, NULL) != TABOR_OK) continue;
    (void)snprintf(entry, sizeof entry, "%s = %s", key, value);
    list = json_with_item(list, json_text(entry));
  }
  return list;
}

static json_t *with_preset(json_t *object, const TaborModel *model, const char *preset) {
  TaborModelInfo info;
  tabor_model_info(model, &info);
  object = json_with_field(object, "preset", json_text(preset));
  return json_with_field(object, "quality", json_text(quality_name(info.quality)));
}

static json_t *with_drum(json_t *object, const TaborModel *model, const char *preset) {
  object = with_preset(object, model, preset);
  return json_with_field(object, "drum", drum_json(tabor_model_definition(model)));
}

/* NULL: the kit cannot be written, which has been said. */
static json_t *kit_json(const TaborKitDef *kit) {
  TaborKitDef *const rooted = malloc(sizeof *rooted);
  TaborError error;
  if (!rooted) {
    (void)fail_memory();
    return NULL;
  }
  *rooted = *kit;
  kit_file_root_samples(rooted);
  char *const text = definition_write_kit(rooted, TABOR_TEXT_KEEP, NULL, &error);
  free(rooted);
  if (!text) (void)report_engine_error(&error);
  json_t *const json = text ? json_text(text) : NULL;
  free(text);
  return json;
}

static json_t *mics_json(const LogStart *start, const TaborDrumDef *def) {
  json_t *mics = json_array();
  for (uint32_t i = 0; i < start->channels; i++) {
    mics = json_with_item(mics, json_text(def->mic[start->mics[i]].name));
  }
  return mics;
}

char *log_line_start(const LogStart *start, const TaborModel *model, const char *preset) {
  json_t *object = json_with_field(json_object(), "tabor_log", integer_json(LOG_VERSION));
  object = json_with_field(object, "program", json_text(start->program));
  object = json_with_field(object, "rate", json_real(start->rate));
  object = json_with_field(object, "gain", json_real(start->gain));
  if (start->kit) {
    object = with_preset(object, model, preset);
    return write_line(json_with_field(object, "kit", kit_json(start->kit)));
  }
  object = json_with_field(object, "mics", mics_json(start, tabor_model_definition(model)));
  return write_line(with_drum(object, model, preset));
}

char *log_line_model(uint32_t number, const TaborModel *model, const char *preset) {
  json_t *const object = json_with_field(json_object(), "model", integer_json(number));
  return write_line(with_drum(object, model, preset));
}

static json_t *with_integer(json_t *object, const char *key, uint32_t value) {
  return value == 0 ? object : json_with_field(object, key, integer_json(value));
}

/* -0 is written. */
static json_t *with_number(json_t *object, const char *key, double value) {
  if (value == 0 && !signbit(value)) return object;
  return json_with_field(object, key, json_number(value));
}

static json_t *with_parameter(json_t *object, uint32_t id) {
  char name[KEY_SIZE];
  const TaborParameter *parameter = NULL;
  for (uint32_t i = 0; (parameter = tabor_parameter(i)) && parameter->id != id; i++) continue;
  if (!parameter) return object;
  parameter_name(parameter, name, sizeof name);
  return json_with_field(object, "parameter", json_text(name));
}

static json_t *with_event(json_t *object, uint32_t drum, const TaborEvent *event) {
  object = json_with_field(object, "event", json_text(event_names[event->type]));
  object = with_integer(object, "id", event->id);
  object = with_integer(object, "striker", event->striker);
  if (event->type == TABOR_EVENT_PARAMETER && drum == TABOR_KIT_MIX) {
    const char *const key = kit_value_keys[event->parameter];
    object = json_with_field(object, "parameter", json_text(key));
  } else if (event->type == TABOR_EVENT_PARAMETER) {
    object = with_parameter(object, event->parameter);
  }
  object = with_integer(object, "index", event->index);
  if (event->technique != TABOR_TECHNIQUE_NORMAL) {
    object = json_with_field(object, "technique", json_text(technique_names[event->technique]));
  }
  object = with_number(object, "velocity", event->velocity);
  object = with_number(object, "radius", event->radius);
  object = with_number(object, "angle", event->angle);
  return with_number(object, "value", event->value);
}

/* Of a kit, the drum, the sample or the mix. */
static json_t *with_address(json_t *object, uint32_t drum) {
  if (drum == TABOR_KIT_ALL) return json_with_field(object, "drum", json_text("all"));
  if (drum == TABOR_KIT_MIX) return json_with_field(object, "drum", json_text("mix"));
  if (drum < TABOR_KIT_NOTE) return with_integer(object, "drum", drum);
  return json_with_field(object, "note", integer_json(drum - TABOR_KIT_NOTE));
}

char *log_line_message(const PlayerMessage *message) {
  const bool replaces = message->event.type == TABOR_EVENT_REPLACE;
  json_t *object = json_with_field(json_object(), "frame", integer_json(message->frame));
  switch (message->type) {
  case PLAYER_EVENT:
    object = with_event(with_address(object, message->drum), message->drum, &message->event);
    break;
  case PLAYER_MODEL:
    object = json_with_field(object, replaces ? "replace" : "swap", integer_json(message->model));
    object = with_address(object, message->drum);
    break;
  case PLAYER_GAIN: object = json_with_field(object, "gain", json_number(message->value)); break;
  default: object = json_with_field(object, "expression", json_number(message->value)); break;
  }
  return write_line(object);
}

static char *write_frames(const char *key, uint64_t frames, uint64_t lost) {
  json_t *const object = json_with_field(json_object(), key, integer_json(frames));
  return write_line(json_with_field(object, "lost", integer_json(lost)));
}

char *log_line_mark(uint64_t frames, uint64_t lost) { return write_frames("played", frames, lost); }

char *log_line_end(uint64_t frames, uint64_t lost) { return write_frames("frames", frames, lost); }

/* ---- reading -------------------------------------------------------------------------------- */

/* The fields of a line; those that have been read are removed. */
typedef struct Fields {
  const char *where;
  json_t *object;
  Outcome outcome; /* of the fields so far: the first error is the one that is printed */
} Fields;

static bool has(const Fields *fields, const char *key) {
  return json_object_get(fields->object, key) != NULL;
}

static void complain(Fields *fields, const char *key, const char *wanted) {
  if (fields->outcome != OUTCOME_OK) return;
  fields->outcome = refuse("%s '%s': allowed: %s", fields->where, key, wanted);
}

/* A number that is left out is 0. */
static double take_number(Fields *fields, const char *key) {
  const json_t *const value = json_object_get(fields->object, key);
  if (!value) return 0;
  if (!json_is_number(value)) complain(fields, key, "a number");
  const double number = json_number_value(value);
  (void)json_object_del(fields->object, key);
  return number;
}

static double take_number_within(Fields *fields, const char *key, double least, double most) {
  const double number = take_number(fields, key);
  if (number >= least && number <= most) return number;
  char wanted[64];
  (void)snprintf(wanted, sizeof wanted, "%.10g to %.10g", least, most);
  complain(fields, key, wanted);
  return number;
}

static uint64_t take_integer(Fields *fields, const char *key, double most) {
  const json_t *const value = json_object_get(fields->object, key);
  if (!value) return 0;
  const json_int_t number = json_integer_value(value);
  if (!json_is_integer(value) || number < 0 || (double)number > most) {
    char wanted[64];
    (void)snprintf(wanted, sizeof wanted, "a whole number from 0 to %.0f", most);
    complain(fields, key, wanted);
  }
  (void)json_object_del(fields->object, key);
  return (uint64_t)number;
}

static uint32_t take_index(Fields *fields, const char *key) {
  return (uint32_t)take_integer(fields, key, UINT32_MAX);
}

/* A text that must be there, cut to @p size bytes with its end; "" after an error. */
static void take_text(Fields *fields, const char *key, char *text, size_t size) {
  const json_t *const value = json_object_get(fields->object, key);
  text[0] = '\0';
  if (!json_is_string(value)) {
    complain(fields, key, "a text");
    return;
  }
  (void)snprintf(text, size, "%s", json_string_value(value));
  (void)json_object_del(fields->object, key);
}

/* Index of the name that must be there. */
static uint32_t take_name(Fields *fields, const char *key, const char *const *names, size_t count) {
  char name[TABOR_NAME_SIZE];
  take_text(fields, key, name, sizeof name);
  const int found = find_name(names, count, name);
  if (found < 0 && fields->outcome == OUTCOME_OK) {
    fields->outcome = refuse("%s '%s': unknown: '%s'", fields->where, key, name);
  }
  return found < 0 ? 0 : (uint32_t)found;
}

/* ---- drums ---- */

/* "shell.radius = 0.2" */
static Outcome set_entry(const char *where, const char *entry, TaborDrumDef *def) {
  const char *const equals = strstr(entry, " = ");
  char key[KEY_SIZE];
  TaborError error;
  if (!equals || (size_t)(equals - entry) >= sizeof key) {
    return refuse("%s 'drum': not of the form 'KEY = VALUE': '%.80s'", where, entry);
  }
  (void)snprintf(key, sizeof key, "%.*s", (int)(equals - entry), entry);
  if (tabor_drum_def_set(def, key, equals + 3, &error) == TABOR_OK) return OUTCOME_OK;
  return refuse("%s %s", where, error.message);
}

static Outcome read_definition(const char *where, const json_t *list, TaborDrumDef *def) {
  TaborError error;
  if (!json_is_array(list)) return refuse("%s 'drum': allowed: a list of texts", where);
  tabor_drum_def_clear(def);
  for (size_t i = 0; i < json_array_size(list); i++) {
    const char *const entry = json_string_value(json_array_get(list, i));
    if (!entry) return refuse("%s 'drum': allowed: a list of texts", where);
    const Outcome outcome = set_entry(where, entry, def);
    if (outcome != OUTCOME_OK) return outcome;
  }
  if (tabor_drum_def_validate(def, &error) != TABOR_OK) {
    return refuse("%s %s", where, error.message);
  }
  return def->mic_count > 0 ? OUTCOME_OK : refuse("%s the drum has no microphone", where);
}

static uint32_t take_quality(Fields *fields) {
  const char *names[TABOR_QUALITY_REFERENCE + 1] = {NULL};
  for (uint32_t i = TABOR_QUALITY_DRAFT; i <= TABOR_QUALITY_REFERENCE; i++) {
    names[i] = quality_name(i);
  }
  return take_name(fields, "quality", names, TABOR_QUALITY_REFERENCE + 1);
}

static void take_drum(Fields *fields, LogLine *line) {
  LogDrum *const drum = line->drum = calloc(1, sizeof *drum);
  if (!drum) fields->outcome = fail_memory();
  if (fields->outcome != OUTCOME_OK) return;
  take_text(fields, "preset", drum->preset, sizeof drum->preset);
  drum->quality = take_quality(fields);
  if (fields->outcome != OUTCOME_OK) return;
  fields->outcome =
    read_definition(fields->where, json_object_get(fields->object, "drum"), &drum->def);
  (void)json_object_del(fields->object, "drum");
}

/* ---- kits ---- */

static Outcome read_kit(const char *where, const char *text, TaborKitDef *kit) {
  char message[2 * TABOR_TEXT_SIZE];
  if (kit_file_parse("kit", text, strlen(text), kit, message, sizeof message) == PRESET_FILE_OK &&
      kit_file_check("kit", kit, message, sizeof message)) {
    return OUTCOME_OK;
  }
  return refuse("%s %s", where, message);
}

static void take_kit(Fields *fields, LogLine *line) {
  const char *const text = json_string_value(json_object_get(fields->object, "kit"));
  LogDrum *const drum = line->drum = calloc(1, sizeof *drum);
  TaborKitDef *const kit = line->kit = calloc(1, sizeof *kit);
  if (!text) complain(fields, "kit", "the text of a kit file");
  if (!drum || !kit) fields->outcome = fail_memory();
  if (fields->outcome != OUTCOME_OK) return;
  take_text(fields, "preset", drum->preset, sizeof drum->preset);
  drum->quality = take_quality(fields);
  if (fields->outcome == OUTCOME_OK) fields->outcome = read_kit(fields->where, text, kit);
  (void)json_object_del(fields->object, "kit");
}

/* ---- kinds of lines ---- */

static void take_mics(Fields *fields, const TaborDrumDef *def, LogStart *start) {
  const json_t *const list = json_object_get(fields->object, "mics");
  const size_t count = json_array_size(list); /* 0 of anything else */
  if (count < 1 || count > TABOR_MAX_MICS) complain(fields, "mics", "names of 1 to 8 microphones");
  for (size_t i = 0; fields->outcome == OUTCOME_OK && i < count; i++) {
    const char *const name = json_string_value(json_array_get(list, i));
    const int mic = name ? tabor_drum_def_find_mic(def, name) : -1;
    if (mic < 0) complain(fields, "mics", "names of the drum's microphones");
    start->mics[start->channels++] = (uint32_t)mic;
  }
  (void)json_object_del(fields->object, "mics");
}

static void take_start(Fields *fields, LogLine *line) {
  LogStart *const start = &line->start;
  line->type = LOG_START;
  const uint64_t version = take_integer(fields, "tabor_log", UINT32_MAX);
  if (fields->outcome == OUTCOME_OK && version != LOG_VERSION) {
    fields->outcome = refuse("%s a log of format %llu; this program reads format %d", fields->where,
                             (unsigned long long)version, LOG_VERSION);
  }
  take_text(fields, "program", start->program, sizeof start->program);
  start->rate = take_number_within(fields, "rate", 22050, 192000);
  start->gain = take_number_within(fields, "gain", 0, MOST_GAIN);
  if (has(fields, "kit")) {
    take_kit(fields, line);
    return;
  }
  take_drum(fields, line);
  if (fields->outcome == OUTCOME_OK) take_mics(fields, &line->drum->def, start);
}

static void take_model(Fields *fields, LogLine *line) {
  line->type = LOG_MODEL;
  line->model = take_index(fields, "model");
  take_drum(fields, line);
}

static uint32_t take_kit_value(Fields *fields) {
  char name[KEY_SIZE];
  take_text(fields, "parameter", name, sizeof name);
  const int value = kit_value_find(name);
  if (value < 0) complain(fields, "parameter", "a key of the kit that moves while it plays");
  return value < 0 ? 0 : (uint32_t)value;
}

static uint32_t take_parameter(Fields *fields) {
  char name[KEY_SIZE], other[KEY_SIZE];
  const TaborParameter *parameter = NULL;
  take_text(fields, "parameter", name, sizeof name);
  for (uint32_t i = 0; (parameter = tabor_parameter(i)); i++) {
    parameter_name(parameter, other, sizeof other);
    if (parameter->live && strcmp(name, other) == 0) return parameter->id;
  }
  complain(fields, "parameter", "the key of a live parameter");
  return 0;
}

static void take_event(Fields *fields, uint32_t drum, TaborEvent *event) {
  event->type = take_name(fields, "event", event_names, EVENT_NAMES);
  event->id = take_index(fields, "id");
  event->striker = take_index(fields, "striker");
  if (event->type == TABOR_EVENT_PARAMETER) {
    event->parameter = drum == TABOR_KIT_MIX ? take_kit_value(fields) : take_parameter(fields);
  }
  event->index = take_index(fields, "index");
  if (has(fields, "technique")) {
    event->technique = take_name(fields, "technique", technique_names, TECHNIQUE_NAMES);
  }
  event->velocity = take_number(fields, "velocity");
  event->radius = take_number(fields, "radius");
  event->angle = take_number(fields, "angle");
  event->value = take_number(fields, "value");
}

static uint32_t take_address(Fields *fields) {
  const char *const word = json_string_value(json_object_get(fields->object, "drum"));
  if (has(fields, "note")) {
    return TABOR_KIT_NOTE + (uint32_t)take_integer(fields, "note", MIDI_VALUES - 1);
  }
  const bool is_all = word && strcmp(word, "all") == 0, is_mix = word && strcmp(word, "mix") == 0;
  if (!is_all && !is_mix) return (uint32_t)take_integer(fields, "drum", TABOR_KIT_DRUMS - 1);
  (void)json_object_del(fields->object, "drum");
  return is_all ? TABOR_KIT_ALL : TABOR_KIT_MIX;
}

static void take_message(Fields *fields, LogLine *line) {
  PlayerMessage *const message = &line->message;
  line->type = LOG_MESSAGE;
  message->frame = take_integer(fields, "frame", MOST_EXACT);
  if (has(fields, "gain") || has(fields, "expression")) {
    message->type = has(fields, "gain") ? PLAYER_GAIN : PLAYER_EXPRESSION;
    message->value = take_number(fields, has(fields, "gain") ? "gain" : "expression");
  } else if (has(fields, "swap") || has(fields, "replace")) {
    message->type = PLAYER_MODEL;
    message->drum = take_address(fields);
    message->event.type = has(fields, "swap") ? TABOR_EVENT_SWAP : TABOR_EVENT_REPLACE;
    message->model = take_index(fields, has(fields, "swap") ? "swap" : "replace");
  } else {
    message->type = PLAYER_EVENT;
    message->drum = take_address(fields);
    take_event(fields, message->drum, &message->event);
  }
}

static void take_frames(Fields *fields, const char *key, LogLineType type, LogLine *line) {
  line->type = type;
  line->frames = take_integer(fields, key, MOST_EXACT);
  line->lost = take_integer(fields, "lost", MOST_EXACT);
}

static Outcome read_fields(Fields *fields, LogLine *line) {
  if (has(fields, "tabor_log")) {
    take_start(fields, line);
  } else if (has(fields, "model")) {
    take_model(fields, line);
  } else if (has(fields, "frame")) {
    take_message(fields, line);
  } else if (has(fields, "frames")) {
    take_frames(fields, "frames", LOG_END, line);
  } else if (has(fields, "played")) {
    take_frames(fields, "played", LOG_MARK, line);
  } else {
    return refuse("%s not a line of a log", fields->where);
  }
  const char *const unknown = json_object_iter_key(json_object_iter(fields->object));
  if (fields->outcome != OUTCOME_OK || !unknown) return fields->outcome;
  return refuse("%s unknown field '%.80s'", fields->where, unknown);
}

static bool is_json(const char *text, size_t length) {
  json_t *const value = json_loadb(text, length, JSON_REJECT_DUPLICATES, NULL);
  const bool is_good = value != NULL;
  json_decref(value);
  return is_good;
}

/* Where memory is short, jansson 2.14 may take a good text for a bad one: then it can be read at
 * another try. */
static Outcome refuse_text(const char *where, const char *text, size_t length) {
  return is_json(text, length) ? fail_memory() : refuse("%s not a line of a log", where);
}

bool log_line_is_cut(const char *text, size_t length) {
  return !is_json(text, length) && !is_json(text, length);
}

Outcome log_line_read(const char *where, const char *text, size_t length, LogLine *line) {
  *line = (LogLine){0};
  json_t *const object = json_loadb(text, length, JSON_REJECT_DUPLICATES, NULL);
  if (!object) return refuse_text(where, text, length);
  Fields fields = {.where = where, .object = object};
  const Outcome outcome =
    json_is_object(object) ? read_fields(&fields, line) : refuse("%s not a line of a log", where);
  json_decref(object);
  return outcome;
}
