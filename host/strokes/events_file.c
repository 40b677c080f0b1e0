/* SPDX-License-Identifier: MIT */
#include "strokes/events_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/input_file.h"

#define BYTE_ORDER_MARK "\xEF\xBB\xBF"

/* A file while it is being read. */
typedef struct Reader {
  const char *name; /* "-": the standard input */
  char *text;       /* all of it, terminated */
  size_t length;
  unsigned line;
  char where[INPUT_PLACE_SIZE]; /* "drums.csv:3:" */
  const StrokeField *columns[STROKE_FIELDS];
  size_t column_count; /* 0 until the header was read */
  const StrokeTarget *target;
  Strokes *strokes; /* of each drum */
  size_t count;     /* strokes of the file */
} Reader;

/* ---- fields ---- */

static bool is_blank(char c) { return c == ' ' || c == '\t'; }

/* A field of a line: where its text begins, and its length. */
typedef struct Field {
  char *text;
  size_t length;
} Field;

static char *skip_blanks(char *at) {
  while (is_blank(*at)) at++;
  return at;
}

/* The rest of a quoted field from behind its first quote; "" stands for one quote. Returns what
   follows the last, or NULL if there is none. */
static char *take_quoted(char *at, Field *field) {
  *field = (Field){at, 0};
  for (; *at; at++) {
    if (*at == '"' && *++at != '"') return skip_blanks(at);
    field->text[field->length++] = *at;
  }
  return NULL;
}

static char *take_plain(char *at, Field *field) {
  *field = (Field){at, strcspn(at, ",")};
  at += field->length;
  while (field->length > 0 && is_blank(field->text[field->length - 1])) field->length--;
  return at;
}

/* Takes the field at *cursor, which moves to the next or becomes NULL behind the last. */
static Outcome take_field(const Reader *reader, char **cursor, Field *field) {
  char *at = skip_blanks(*cursor);
  at = *at == '"' ? take_quoted(at + 1, field) : take_plain(at, field);
  if (!at) return refuse("%s a quote is not closed", reader->where);
  if (*at && *at != ',') return refuse("%s text follows a closing quote", reader->where);
  *cursor = *at ? at + 1 : NULL;
  return OUTCOME_OK;
}

/* ---- lines ---- */

static bool has_column(const Reader *reader, const StrokeField *field) {
  for (size_t i = 0; i < reader->column_count; i++) {
    if (reader->columns[i] == field) return true;
  }
  return false;
}

static Outcome read_header(Reader *reader, char *line) {
  Outcome outcome = OUTCOME_OK;
  for (char *cursor = line; cursor && outcome == OUTCOME_OK;) {
    Field name;
    outcome = take_field(reader, &cursor, &name);
    if (outcome != OUTCOME_OK) break;
    const StrokeField *const field = stroke_field(name.text, name.length);
    if (!field) return stroke_unknown_field(reader->where, "column", name.text, name.length);
    if (has_column(reader, field)) {
      return refuse("%s the column '%s' occurs twice", reader->where, stroke_field_name(field));
    }
    reader->columns[reader->column_count++] = field;
  }
  return outcome;
}

static Outcome split_row(const Reader *reader, char *line, Field values[STROKE_FIELDS]) {
  size_t count = 0;
  for (char *cursor = line; cursor; count++) {
    Field value;
    const Outcome outcome = take_field(reader, &cursor, &value);
    if (outcome != OUTCOME_OK) return outcome;
    if (count < STROKE_FIELDS) values[count] = value;
  }
  if (count == reader->column_count) return OUTCOME_OK;
  return refuse("%s fields: %zu; the header names %zu", reader->where, count, reader->column_count);
}

/* The drum decides what the other fields may be. */
static Outcome begin_stroke(const Reader *reader, const Field *values, Stroke *stroke) {
  size_t i = 0;
  while (i < reader->column_count && !stroke_field_is_drum(reader->columns[i])) i++;
  const bool is_named = i < reader->column_count && values[i].length > 0;
  return stroke_begin(reader->target, reader->where, is_named ? values[i].text : NULL,
                      is_named ? values[i].length : 0, stroke);
}

static Outcome read_row(Reader *reader, char *line) {
  Field values[STROKE_FIELDS];
  Stroke stroke;
  Outcome outcome = split_row(reader, line, values);
  if (outcome == OUTCOME_OK) outcome = begin_stroke(reader, values, &stroke);
  if (outcome != OUTCOME_OK) return outcome;
  stroke.response = reader->strokes->response;
  for (size_t i = 0; i < reader->column_count && outcome == OUTCOME_OK; i++) {
    if (values[i].length == 0) continue;
    outcome = stroke_set(&stroke, reader->columns[i], values[i].text, values[i].length);
  }
  if (outcome == OUTCOME_OK) outcome = strokes_add(&reader->strokes[stroke.drum], &stroke);
  reader->count++;
  return outcome;
}

/* Spreadsheets end files with lines of commas. */
static bool is_empty(const char *line) {
  const char *const content = line + strspn(line, " \t");
  return *content == '#' || line[strspn(line, " \t,")] == '\0';
}

static Outcome read_line(Reader *reader, char *line) {
  input_place(reader->where, reader->name, reader->line);
  if (is_empty(line)) return OUTCOME_OK;
  return reader->column_count > 0 ? read_row(reader, line) : read_header(reader, line);
}

/* Ends the line at @p line, without its CR; returns the next, or NULL behind the last. */
static char *end_line(char *line) {
  char *const end = strchr(line, '\n');
  const size_t length = end ? (size_t)(end - line) : strlen(line);
  if (end) *end = '\0';
  if (length > 0 && line[length - 1] == '\r') line[length - 1] = '\0';
  return end ? end + 1 : NULL;
}

static Outcome read_lines(Reader *reader) {
  if (strlen(reader->text) < reader->length) {
    return refuse("%s: not a text: it holds a NUL", input_name(reader->name));
  }
  char *line = reader->text;
  if (strncmp(line, BYTE_ORDER_MARK, 3) == 0) line += 3;
  Outcome outcome = OUTCOME_OK;
  for (reader->line = 1; line && outcome == OUTCOME_OK; reader->line++) {
    char *const next = end_line(line);
    outcome = read_line(reader, line);
    line = next;
  }
  if (outcome == OUTCOME_OK && reader->count == 0) {
    return refuse("%s: the file holds no stroke", input_name(reader->name));
  }
  return outcome;
}

Outcome events_file_read(const char *name, const StrokeTarget *target, Strokes *strokes) {
  if (!*name) return refuse("--events needs the name of a file");
  Reader reader = {.name = name, .target = target, .strokes = strokes};
  Outcome outcome = input_file_read(name, EVENTS_FILE_LIMIT, &reader.text, &reader.length);
  if (outcome == OUTCOME_OK) outcome = read_lines(&reader);
  free(reader.text);
  return outcome;
}
