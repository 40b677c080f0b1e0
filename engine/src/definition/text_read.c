/* SPDX-License-Identifier: MIT */
/* Texts of sections and keys: tabor_text_read(). The whole text is checked before its first line is
 * given. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "definition/def_text.h"
#include "definition/error.h"

#define BYTE_ORDER_MARK "\xEF\xBB\xBF"

/* Bytes of the text: [start, end). */
typedef struct Span {
  const char *start, *end;
} Span;

typedef enum LineKind { LINE_EMPTY, LINE_SECTION, LINE_PAIR } LineKind;

typedef struct Line {
  Span all; /* without its end */
  uint32_t number;
  LineKind kind;
  Span name;  /* of the section, or the key */
  Span value; /* of a pair */
} Line;

/* A name that must not occur twice in its scope: scope 0 has the sections, scope n the keys of the
 * n-th. */
typedef struct Name {
  uint32_t scope, number; /* number of its line */
  Span span;
} Name;

typedef struct Reader {
  char *text; /* a copy with a terminator */
  size_t size;
  const char *next; /* line */
  uint32_t line_count;
  Name *names;
  size_t name_count;
  uint32_t section_count;
  TaborError *error;
} Reader;

static size_t length_of(Span span) { return (size_t)(span.end - span.start); }

static bool is_blank(char c) { return c == ' ' || c == '\t'; }

static Span trim(Span span) {
  while (span.start < span.end && is_blank(*span.start)) span.start++;
  while (span.start < span.end && is_blank(span.end[-1])) span.end--;
  return span;
}

/* The span as a string for a message, which cuts what is longer. */
static const char *quote(Span span, char text[TABOR_TEXT_WORD + 1]) {
  const size_t length = length_of(span) < TABOR_TEXT_WORD ? length_of(span) : TABOR_TEXT_WORD;
  memcpy(text, span.start, length);
  text[length] = '\0';
  return text;
}

/* `at` is in the line, or NULL: the line as a whole. */
static TaborStatus refuse_at(Reader *reader, const Line *line, const char *at, const char *format,
                             Span what) {
  char text[TABOR_TEXT_WORD + 1];
  (void)tb_error_set(reader->error, TABOR_ERROR_VALUE, NULL, NULL, NAN, NAN, format,
                     quote(what, text));
  return tb_error_place(reader->error, TABOR_ERROR_VALUE, line->number,
                        at ? (uint32_t)(at - line->all.start) + 1 : 1);
}

/* ---- characters ------------------------------------------------------------------------------ */

/* Length of the control character at `c`, 0 if there is none. */
static size_t control_length(const unsigned char *c) {
  if (c[0] < 0x20 || c[0] == 0x7F) return 1;
  return c[0] == 0xC2 && c[1] >= 0x80 && c[1] < 0xA0 ? 2 : 0;
}

static bool is_allowed(const unsigned char *c) {
  return c[0] == '\t' || c[0] == '\n' || (c[0] == '\r' && (c[1] == '\n' || c[1] == '\0'));
}

static TaborStatus refuse_character(Reader *reader, const char *at, uint32_t line, size_t column) {
  const unsigned char *const c = (const unsigned char *)at;
  const size_t control = control_length(c);
  char byte[8];
  (void)snprintf(byte, sizeof byte, "0x%02x", control ? c[control - 1] : c[0]);
  (void)tb_error_set(reader->error, TABOR_ERROR_VALUE, NULL, NULL, NAN, NAN,
                     control ? "a control character (%s)" : "not UTF-8 text (byte %s)", byte);
  return tb_error_place(reader->error, TABOR_ERROR_VALUE, line, (uint32_t)column);
}

static TaborStatus check_characters(Reader *reader) {
  const char *const end = reader->text + reader->size;
  const char *line_start = reader->text;
  uint32_t line = 1;
  for (const char *at = reader->text; at < end;) {
    const bool is_plain = is_allowed((const unsigned char *)at);
    const size_t step = is_plain ? 1 : tb_text_step(at);
    if (step == 0) return refuse_character(reader, at, line, (size_t)(at - line_start) + 1);
    if (*at == '\n') {
      line++;
      line_start = at + 1;
    }
    at += step;
  }
  return TABOR_OK;
}

/* ---- lines ----------------------------------------------------------------------------------- */

/* A comment behind something begins with a ';' after a blank. */
static bool is_comment(const char *at) { return *at == ';' && is_blank(at[-1]); }

static TaborStatus check_word(Reader *reader, const Line *line, const char *without,
                              const char *too_long) {
  if (length_of(line->name) == 0) {
    return refuse_at(reader, line, line->name.start, without, line->name);
  }
  if (length_of(line->name) <= TABOR_TEXT_WORD) return TABOR_OK;
  return refuse_at(reader, line, line->name.start, too_long, line->name);
}

#define AS_TEXT_(number) #number
#define AS_TEXT(number) AS_TEXT_(number)

static TaborStatus read_section(Reader *reader, Line *line) {
  const Span content = trim(line->all);
  const char *end = content.start + 1;
  while (end < content.end && *end != ']' && !is_comment(end)) end++;
  if (end == content.end || *end != ']') {
    return refuse_at(reader, line, NULL, "a '[' without a ']'", content);
  }
  line->kind = LINE_SECTION;
  line->name = (Span){content.start + 1, end};
  const Span rest = trim((Span){end + 1, content.end});
  if (length_of(rest) > 0 && *rest.start != ';') {
    return refuse_at(reader, line, rest.start, "'%s' after the section's ']'", rest);
  }
  return check_word(reader, line, "a section without a name",
                    "the section '%s' is longer than " AS_TEXT(TABOR_TEXT_WORD) " bytes");
}

static Span value_of(Span rest) {
  const char *end = rest.start;
  while (end < rest.end && !is_comment(end)) end++;
  return trim((Span){rest.start, end});
}

static TaborStatus read_pair(Reader *reader, Line *line) {
  const Span content = trim(line->all);
  const char *end = content.start;
  while (end < content.end && *end != '=' && *end != ':' && !is_comment(end)) end++;
  if (end == content.end || *end != '=') {
    return refuse_at(reader, line, NULL, "'%s' is neither [section], key = value nor ; comment",
                     content);
  }
  line->kind = LINE_PAIR;
  line->name = trim((Span){content.start, end});
  line->value = value_of((Span){end + 1, content.end});
  return check_word(reader, line, "a key without a name",
                    "the key '%s' is longer than " AS_TEXT(TABOR_TEXT_WORD) " bytes");
}

static TaborStatus read_line(Reader *reader, Line *line) {
  const Span content = trim(line->all);
  const char first = length_of(content) > 0 ? *content.start : ';';
  if (first == ';' || first == '#') return TABOR_OK;
  if (content.start > line->all.start) {
    return refuse_at(reader, line, content.start, "the line is indented", content);
  }
  return first == '[' ? read_section(reader, line) : read_pair(reader, line);
}

/* Moves on to the next line, which ends before its line end; false after the last. */
static bool next_line(Reader *reader, Line *line, TaborStatus *status) {
  const char *const end = reader->text + reader->size, *const start = reader->next;
  if (start >= end) return false;
  const char *const feed = memchr(start, '\n', (size_t)(end - start));
  const char *const stop = feed ? feed : end;
  const bool has_return = stop > start && stop[-1] == '\r';
  reader->next = feed ? feed + 1 : end;
  *line = (Line){.all = {start, stop - has_return}, .number = ++reader->line_count};
  if (stop - start > TABOR_TEXT_LINE) {
    *status = refuse_at(reader, line, NULL,
                        "the line is longer than " AS_TEXT(TABOR_TEXT_LINE) " bytes", line->all);
    return true;
  }
  *status = read_line(reader, line);
  if (*status == TABOR_OK && !feed) {
    *status = refuse_at(reader, line, stop, "the last line has no line end: was the file cut off?",
                        line->all);
  }
  return true;
}

static void rewind_lines(Reader *reader) {
  reader->next = reader->text;
  reader->line_count = 0;
}

/* ---- names ----------------------------------------------------------------------------------- */

static int compare_words(const Name *a, const Name *b) {
  if (a->scope != b->scope) return a->scope < b->scope ? -1 : 1;
  const size_t least =
    length_of(a->span) < length_of(b->span) ? length_of(a->span) : length_of(b->span);
  const int order = memcmp(a->span.start, b->span.start, least);
  if (order != 0) return order;
  return (length_of(a->span) > least) - (length_of(b->span) > least);
}

/* For qsort(): equal words by their lines. */
static int compare_names(const void *a, const void *b) {
  const Name *const first = a, *const second = b;
  const int order = compare_words(first, second);
  if (order != 0) return order;
  return (first->number > second->number) - (first->number < second->number);
}

static TaborStatus refuse_twice(Reader *reader, const Name *name, uint32_t first) {
  char text[TABOR_TEXT_WORD + 1];
  (void)tb_error_set(reader->error, TABOR_ERROR_VALUE, NULL, NULL, NAN, NAN,
                     name->scope == 0 ? "section [%s] occurs twice, first in line %u"
                                      : "'%s' occurs twice in its section, first in line %u",
                     quote(name->span, text), (unsigned)first);
  return tb_error_place(reader->error, TABOR_ERROR_VALUE, name->number, name->scope == 0 ? 2 : 1);
}

static TaborStatus check_names(Reader *reader) {
  const Name *twice = NULL;
  uint32_t first = 0;
  if (reader->name_count > 0) {
    qsort(reader->names, reader->name_count, sizeof *reader->names, compare_names);
  }
  for (size_t i = 1; i < reader->name_count; i++) {
    const Name *const name = &reader->names[i];
    if (compare_words(name - 1, name) != 0 || (twice && twice->number < name->number)) continue;
    twice = name;
    first = name[-1].number;
  }
  return twice ? refuse_twice(reader, twice, first) : TABOR_OK;
}

static TaborStatus take_name(Reader *reader, const Line *line) {
  const bool is_section = line->kind == LINE_SECTION;
  if (is_section) reader->section_count++;
  const bool is_full = memchr(line->name.start, '.', length_of(line->name)) != NULL;
  if (!is_section && reader->section_count == 0 && !is_full) {
    return refuse_at(reader, line, NULL, "'%s' stands before the first section", line->name);
  }
  reader->names[reader->name_count++] =
    (Name){is_section ? 0 : reader->section_count + 1, line->number, line->name};
  return TABOR_OK;
}

static TaborStatus check_lines(Reader *reader) {
  Line line;
  TaborStatus status = TABOR_OK;
  rewind_lines(reader);
  while (next_line(reader, &line, &status)) {
    if (status == TABOR_OK && line.kind != LINE_EMPTY) status = take_name(reader, &line);
    if (status != TABOR_OK) return status;
  }
  if (reader->name_count > 0) return check_names(reader);
  return tb_error_set(reader->error, TABOR_ERROR_VALUE, NULL, NULL, NAN, NAN,
                      "the file holds no section");
}

/* ---- giving ---------------------------------------------------------------------------------- */

static void copy_span(char *to, Span span) {
  memcpy(to, span.start, length_of(span));
  to[length_of(span)] = '\0';
}

/* Points at the value if it is not allowed, else at the name. */
static TaborStatus place_error(const Line *line, TaborStatus status, TaborError *error) {
  const bool is_value = line->kind == LINE_PAIR && status != TABOR_ERROR_KEY;
  const char *const at = is_value ? line->value.start : line->name.start;
  return tb_error_place(error, status, line->number, (uint32_t)(at - line->all.start) + 1);
}

static TaborStatus give_lines(Reader *reader, TaborTextTake *take, void *context) {
  char section[TABOR_TEXT_WORD + 1] = "", key[TABOR_TEXT_WORD + 1], value[TABOR_TEXT_LINE + 1];
  char full[sizeof section + sizeof key];
  Line line;
  TaborStatus status = TABOR_OK;
  rewind_lines(reader);
  while (status == TABOR_OK && next_line(reader, &line, &status)) {
    if (line.kind == LINE_EMPTY) continue;
    const bool is_pair = line.kind == LINE_PAIR;
    copy_span(is_pair ? key : section, line.name);
    if (is_pair) copy_span(value, line.value);
    (void)snprintf(full, sizeof full, "%s%s%s", section, is_pair && *section ? "." : "",
                   is_pair ? key : "");
    const TaborTextLine given = {.section = section,
                                 .key = is_pair ? key : NULL,
                                 .full = full,
                                 .value = is_pair ? value : NULL,
                                 .number = line.number};
    status = take(context, &given, reader->error);
    if (status != TABOR_OK) status = place_error(&line, status, reader->error);
  }
  return status;
}

static TaborStatus refuse_memory(TaborError *error) {
  return tb_error_set(error, TABOR_ERROR_MEMORY, NULL, NULL, NAN, NAN, "out of memory");
}

static TaborStatus copy_text(Reader *reader, const char *text, size_t size) {
  const size_t mark = strlen(BYTE_ORDER_MARK);
  const bool is_marked = size >= mark && memcmp(text, BYTE_ORDER_MARK, mark) == 0;
  reader->size = is_marked ? size - mark : size;
  reader->text = malloc(reader->size + 1);
  if (!reader->text) return refuse_memory(reader->error);
  if (reader->size > 0) memcpy(reader->text, text + (size - reader->size), reader->size);
  reader->text[reader->size] = '\0';
  size_t lines = 1;
  for (size_t i = 0; i < reader->size; i++) lines += reader->text[i] == '\n';
  reader->names = calloc(lines, sizeof *reader->names);
  return reader->names ? TABOR_OK : refuse_memory(reader->error);
}

TaborStatus tabor_text_read(const char *text, size_t size, TaborTextTake *take, void *context,
                            TaborError *error) {
  TaborError own;
  Reader reader = {.error = error ? error : &own};
  if (!text && size > 0) return tb_error_null(error, "text");
  if (!take) return tb_error_null(error, "function that takes lines");
  if (size > TABOR_TEXT_LIMIT) {
    return tb_error_set(error, TABOR_ERROR_VALUE, NULL, NULL, 0, TABOR_TEXT_LIMIT,
                        "the file is larger than %d bytes", TABOR_TEXT_LIMIT);
  }
  (void)tb_error_clear(reader.error);
  TaborStatus status = copy_text(&reader, text, size);
  if (status == TABOR_OK) status = check_characters(&reader);
  if (status == TABOR_OK) status = check_lines(&reader);
  if (status == TABOR_OK) status = give_lines(&reader, take, context);
  if (status == TABOR_OK) status = tb_error_clear(reader.error);
  free(reader.names);
  free(reader.text);
  return status;
}
