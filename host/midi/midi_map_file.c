/* SPDX-License-Identifier: MIT */
#include "midi/midi_map_file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/input_file.h"
#include "base/number.h"
#include "base/suggest.h"
#include "base/text_file.h"
#include "drums/preset_file.h"

#define LONGEST_PLACE 200     /* bytes of a path in messages about a line */
#define LARGEST_FILE 1000000u /* bytes of a map */

/* What the pairs that come belong to. */
typedef enum Section { SECTION_NONE, SECTION_MAP, SECTION_NOTE, SECTION_CONTROLLER } Section;

/* A file being read. */
typedef struct Reader {
  const char *path;
  MidiMap *map;
  Section section;
  int number;      /* of the note or controller */
  char where[320]; /* "map.ini:3: speed" */
  bool refused;    /* and said so */
} Reader;

/* ---- words ---- */

static const char *word_at(const void *words, size_t index) {
  return ((const char *const *)words)[index];
}

/* Index of @p text in a list that ends with NULL. */
static Outcome read_word(const char *where, const char *text, const char *const *words,
                         size_t *index) {
  for (*index = 0; words[*index]; ++*index) {
    if (strcmp(text, words[*index]) == 0) return OUTCOME_OK;
  }
  char hint[320];
  suggest_choice(hint, sizeof hint, text, "", word_at, words);
  return refuse("%s '%.80s': unknown%s", where, text, hint);
}

Outcome midi_curve_read(const char *where, const char *text, MidiCurve *curve) {
  size_t index = 0;
  const Outcome outcome = read_word(where, text, midi_curve_names, &index);
  if (outcome == OUTCOME_OK) *curve = (MidiCurve)index;
  return outcome;
}

Outcome midi_range_read(const char *where, const char *text, MidiRange *range) {
  size_t index = 0;
  const Outcome outcome = read_word(where, text, midi_range_names, &index);
  if (outcome == OUTCOME_OK) *range = (MidiRange)index;
  return outcome;
}

Outcome midi_channel_read(const char *where, const char *text, int *channel) {
  const NumberField field = {where, 1, MIDI_CHANNELS, true};
  double number = 0;
  *channel = MIDI_OMNI;
  if (strcmp(text, "omni") == 0) return OUTCOME_OK;
  const Outcome outcome = number_read(&field, text, &number);
  *channel = (int)number - 1;
  return outcome;
}

static Outcome read_switch(const char *where, const char *text, bool *on) {
  static const char *const words[] = {"no", "yes", NULL};
  size_t index = 0;
  const Outcome outcome = read_word(where, text, words, &index);
  *on = index == 1;
  return outcome;
}

/* ---- [map] ---- */

static Outcome empty_map(Reader *reader, const char *value) {
  bool defaults = true;
  const Outcome outcome = read_switch(reader->where, value, &defaults);
  if (outcome != OUTCOME_OK || defaults) return outcome;
  for (int i = 0; i < MIDI_VALUES; i++) {
    reader->map->notes[i] = (MidiNote){.radius = NAN, .angle = NAN, .speed = 1};
    reader->map->controls[i] = (MidiControl){0};
  }
  return OUTCOME_OK;
}

static const char *const map_keys[] = {
  "channel", "velocity", "velocity_range", "defaults", "pressure", "programs", NULL};

static Outcome set_map(Reader *reader, size_t key, const char *value) {
  MidiMap *const map = reader->map;
  switch (key) {
  case 0: return midi_channel_read(reader->where, value, &map->channel);
  case 1: return midi_curve_read(reader->where, value, &map->response.curve);
  case 2: return midi_range_read(reader->where, value, &map->response.range);
  case 3: return empty_map(reader, value);
  case 4: return read_switch(reader->where, value, &map->pressure);
  default: return read_switch(reader->where, value, &map->programs);
  }
}

/* ---- [note.N] ---- */

static Outcome set_number(const Reader *reader, const char *value, double minimum, double maximum,
                          double *number) {
  const NumberField field = {reader->where, minimum, maximum, false};
  return number_read(&field, value, number);
}

static Outcome set_stroke(const Reader *reader, const char *value, MidiNote *note) {
  size_t index = 0;
  const Outcome outcome = read_word(reader->where, value, midi_stroke_names, &index);
  if (outcome == OUTCOME_OK) note->stroke = (MidiStroke)index;
  return outcome;
}

static Outcome set_percent(const Reader *reader, const char *value, double *part) {
  double percent = 0;
  const Outcome outcome = set_number(reader, value, 0, 100, &percent);
  *part = percent / 100;
  return outcome;
}

static Outcome set_striker(const Reader *reader, const char *value, MidiNote *note) {
  if (*value && strlen(value) <= TABOR_NAME_LENGTH) {
    (void)snprintf(note->striker, sizeof note->striker, "%s", value);
    return OUTCOME_OK;
  }
  return refuse("%s '%.80s': allowed: a name of 1 to %d bytes", reader->where, value,
                TABOR_NAME_LENGTH);
}

static const char *const note_keys[] = {"stroke", "radius", "angle", "speed", "striker", NULL};

static Outcome set_note(Reader *reader, size_t key, const char *value) {
  MidiNote *const note = &reader->map->notes[reader->number];
  switch (key) {
  case 0: return set_stroke(reader, value, note);
  case 1: return set_percent(reader, value, &note->radius);
  case 2: return set_number(reader, value, -360, 360, &note->angle);
  case 3: return set_number(reader, value, 0.01, 10, &note->speed);
  default: return set_striker(reader, value, note);
  }
}

/* ---- [controller.N] ---- */

static Outcome set_key(const char *where, const char *value, MidiControl *control) {
  const TaborParameter *const row = tabor_parameter_find(value);
  if (!row) {
    return refuse(
      "%s '%.80s': unknown; allowed: radius, angle, grip, strainer, gain, silence, opening, "
      "none, or a live key as wires.tension",
      where, value);
  }
  if (!row->live || strlen(value) >= sizeof control->key) {
    return refuse("%s '%.80s': this key cannot move while the drum plays", where, value);
  }
  *control =
    (MidiControl){.target = MIDI_TARGET_PARAMETER, .from = row->minimum, .to = row->maximum};
  (void)snprintf(control->key, sizeof control->key, "%s", value);
  return OUTCOME_OK;
}

/* In the order of MidiTarget. */
static const char *const target_names[] = {"none", "radius",  "angle",   "grip", "strainer",
                                           "gain", "silence", "opening", NULL};

Outcome midi_control_read(const char *where, const char *text, MidiControl *control) {
  for (size_t i = 0; target_names[i]; i++) {
    if (strcmp(text, target_names[i]) != 0) continue;
    *control = (MidiControl){.target = (MidiTarget)i};
    return OUTCOME_OK;
  }
  return set_key(where, text, control);
}

static Outcome set_end(const Reader *reader, const char *value, const MidiControl *control,
                       double *end) {
  if (control->target != MIDI_TARGET_PARAMETER) {
    return refuse("%s: goes behind 'moves = KEY' with a live key", reader->where);
  }
  const TaborParameter *const row = tabor_parameter_find(control->key);
  return set_number(reader, value, row->minimum, row->maximum, end);
}

static const char *const controller_keys[] = {"moves", "from", "to", NULL};

static Outcome set_controller(Reader *reader, size_t key, const char *value) {
  MidiControl *const control = &reader->map->controls[reader->number];
  if (key == 0) return midi_control_read(reader->where, value, control);
  return set_end(reader, value, control, key == 1 ? &control->from : &control->to);
}

/* ---- sections and pairs ---- */

static const struct Kind {
  const char *name; /* before its number, if it has one */
  const char *const *keys;
  Outcome (*set)(Reader *reader, size_t key, const char *value);
} kinds[] = {
  [SECTION_MAP] = {"map", map_keys, set_map},
  [SECTION_NOTE] = {"note.", note_keys, set_note},
  [SECTION_CONTROLLER] = {"controller.", controller_keys, set_controller},
};

static Outcome begin_numbered(Reader *reader, Section section, const char *number) {
  const NumberField field = {reader->where, 0, MIDI_VALUES - 1, true};
  double value = 0;
  const Outcome outcome = number_read(&field, number, &value);
  if (outcome != OUTCOME_OK) return outcome;
  reader->section = section;
  reader->number = (int)value;
  MidiNote *const note = &reader->map->notes[reader->number];
  if (section == SECTION_NOTE && note->stroke == MIDI_STROKE_NONE) note->stroke = MIDI_STROKE_HEAD;
  return OUTCOME_OK;
}

static Outcome begin_section(Reader *reader, const char *name) {
  if (strcmp(name, kinds[SECTION_MAP].name) == 0) {
    if (reader->section != SECTION_NONE) return refuse("%s: has to stand first", reader->where);
    reader->section = SECTION_MAP;
    return OUTCOME_OK;
  }
  for (Section section = SECTION_NOTE; section <= SECTION_CONTROLLER; section++) {
    const size_t length = strlen(kinds[section].name);
    if (strncmp(name, kinds[section].name, length) == 0) {
      return begin_numbered(reader, section, name + length);
    }
  }
  return refuse("%s: unknown section; allowed: [map], [note.0] to [note.127], [controller.0] to "
                "[controller.127]",
                reader->where);
}

static Outcome set_pair(Reader *reader, const char *key, const char *value) {
  const struct Kind *const kind = &kinds[reader->section];
  for (size_t i = 0; kind->keys[i]; i++) {
    if (strcmp(key, kind->keys[i]) == 0) return kind->set(reader, i, value);
  }
  char hint[320];
  suggest_choice(hint, sizeof hint, key, "", word_at, kind->keys);
  return refuse("%s: unknown key%s", reader->where, hint);
}

/* A TaborTextTake. Says itself what is wrong. */
static TaborStatus take_line(void *context, const TaborTextLine *line, TaborError *error) {
  Reader *const reader = context;
  const size_t length = strlen(reader->path);
  const bool cut = length > LONGEST_PLACE;
  const bool is_key = line->key != NULL;
  (void)error;
  (void)snprintf(reader->where, sizeof reader->where, "%s%s:%lu: %s%s%s", cut ? "..." : "",
                 cut ? reader->path + length - LONGEST_PLACE : reader->path,
                 (unsigned long)line->number, is_key ? "" : "[", is_key ? line->key : line->section,
                 is_key ? "" : "]");
  const Outcome outcome =
    is_key ? set_pair(reader, line->key, line->value) : begin_section(reader, line->section);
  reader->refused = outcome != OUTCOME_OK;
  return reader->refused ? TABOR_ERROR_VALUE : TABOR_OK;
}

Outcome midi_map_file_read(const char *path, MidiMap *map) {
  char message[2 * TABOR_TEXT_SIZE];
  Reader reader = {.path = path, .map = map};
  midi_map_default(map);
  const PresetFileStatus status =
    preset_file_read(path, take_line, &reader, message, sizeof message);
  if (status == PRESET_FILE_OK) return OUTCOME_OK;
  if (status == PRESET_FILE_UNREADABLE) return fail("%s", message);
  return reader.refused ? OUTCOME_REFUSED : refuse("%s", message);
}

Outcome midi_map_file_add(const char *path, int controller, const char *text) {
  char *before = NULL;
  size_t length = 0;
  Outcome outcome = input_file_read(path, LARGEST_FILE, &before, &length);
  if (outcome == OUTCOME_OK) {
    const size_t size = length + strlen(text) + 64;
    char *const whole = malloc(size);
    if (whole) {
      (void)snprintf(whole, size, "%s[controller.%d]\nmoves = %s\n", before, controller, text);
    }
    outcome = whole ? text_file_write(path, whole, false) : fail_memory();
    free(whole);
  }
  free(before);
  return outcome;
}
