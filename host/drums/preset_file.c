/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "drums/preset_file.h"

#include <errno.h>
#include <ini.h>
#include <limits.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "platform/files.h"

/* What inih 55 keeps of a section or key, without its terminator. */
#define WORD_LIMIT 49

#define BYTE_ORDER_MARK "\xEF\xBB\xBF"

#ifdef __GNUC__
#  define PRINTF_LIKE __attribute__((format(printf, 3, 4)))
#else
#  define PRINTF_LIKE
#endif

/* A pair as it stands in the text. Offsets rather than pointers: all of it is one small file. */
typedef struct Pair {
  uint16_t section, section_length, key, key_length, line;
} Pair;

/* A section as it stands in the text. */
typedef struct Section {
  uint16_t start, length, line;
} Section;

/* A file being read. */
typedef struct Reader {
  const char *path;
  char *message; /* of the caller */
  size_t size;
  char text[PRESET_FILE_LIMIT + 2];            /* one byte too many shows that it is too large */
  Section sections[PRESET_FILE_LIMIT / 4 + 1]; /* "[a]\n" */
  Pair pairs[PRESET_FILE_LIMIT / 3 + 1];       /* "a=\n" */
  size_t length, section_count, pair_count;
  size_t sections_given, pairs_given; /* to the caller */
  bool refused;                       /* by the caller */
  PresetPairFn *pair;
  void *context;
} Reader;

/* A byte of a path or a quoted word that a message can carry. */
static char printable(char c) { return (unsigned char)c < 0x20 || c == 0x7F ? '?' : c; }

/* "path: " or "path:12: "; the end of a long path, so that the message keeps its room. */
static size_t write_place(Reader *reader, unsigned line) {
  const size_t room = reader->size / 2, length = strlen(reader->path);
  const bool cut = length > room;
  const char *const path = reader->path + (cut ? length - room : 0);
  int written = snprintf(reader->message, reader->size, "%s%s", cut ? "..." : "", path);
  for (char *c = reader->message; *c; c++) *c = printable(*c);
  if (line > 0 && written > 0 && (size_t)written < reader->size) {
    char *const end = reader->message + written;
    written += snprintf(end, reader->size - (size_t)written, ":%u", line);
  }
  return written >= 0 && (size_t)written < reader->size ? (size_t)written : reader->size - 1;
}

/* Writes "path:line: ..."; returns false, so that a check can end with it. Line 0: the whole
 * file. */
PRINTF_LIKE static bool refuse_line(Reader *reader, unsigned line, const char *format, ...) {
  if (reader->size == 0) return false;
  const size_t place = write_place(reader, line);
  char *const rest = reader->message + place;
  const size_t room = reader->size - place;
  const int separator = snprintf(rest, room, ": ");
  if (separator < 0 || (size_t)separator >= room) return false;
  va_list arguments;
  va_start(arguments, format);
  (void)vsnprintf(rest + separator, room - (size_t)separator, format, arguments);
  va_end(arguments);
  return false;
}

/* Reading ------------------------------------------------------------------------------------- */

static bool read_all(Reader *reader, int file) {
  const size_t room = PRESET_FILE_LIMIT + 1;
  while (reader->length < room) {
    const ssize_t count =
      read(file, reader->text + reader->length, (unsigned)(room - reader->length));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return refuse_line(reader, 0, "%s", strerror(errno));
    if (count == 0) break;
    reader->length += (size_t)count;
  }
  reader->text[reader->length] = '\0';
  return true;
}

static bool read_regular(Reader *reader, int file) {
  FileStatus status;
  if (!file_status_of(file, &status)) return refuse_line(reader, 0, "%s", strerror(errno));
  if (status.kind == FILE_KIND_FOLDER) return refuse_line(reader, 0, "%s", strerror(EISDIR));
  if (status.kind != FILE_KIND_REGULAR) return refuse_line(reader, 0, "not a regular file");
  return read_all(reader, file);
}

static bool read_file(Reader *reader) {
  /* Without waiting for a FIFO's writer; nothing else is read from it, as it is no regular file. */
  const int file = file_open_to_read(reader->path);
  if (file < 0) return refuse_line(reader, 0, "%s", strerror(errno));
  const bool read = read_regular(reader, file);
  (void)close(file);
  return read;
}

/* Checking ------------------------------------------------------------------------------------ */

static bool is_continuation(unsigned char c) { return (c & 0xC0u) == 0x80u; }

/* Bytes of the valid UTF-8 character at @p text, 0 if there is none: Unicode 15, table 3-7. */
static size_t utf8_step(const unsigned char *text) {
  const unsigned char first = text[0];
  if (first < 0x80) return 1;
  unsigned char low = 0x80, high = 0xBF; /* of the second byte */
  size_t bytes = 0;
  if (first >= 0xC2 && first <= 0xDF) bytes = 2;
  if (first >= 0xE0 && first <= 0xEF) bytes = 3;
  if (first >= 0xF0 && first <= 0xF4) bytes = 4;
  if (first == 0xE0) low = 0xA0;
  if (first == 0xED) high = 0x9F;
  if (first == 0xF0) low = 0x90;
  if (first == 0xF4) high = 0x8F;
  if (bytes == 0 || text[1] < low || text[1] > high) return 0;
  for (size_t i = 2; i < bytes; i++) {
    if (!is_continuation(text[i])) return 0;
  }
  return bytes;
}

/* The text is terminated, so no sequence is followed past its end. */
static bool check_characters(Reader *reader) {
  unsigned line = 1;
  for (size_t i = 0, step; i < reader->length; i += step) {
    const unsigned char *const c = (const unsigned char *)reader->text + i;
    step = utf8_step(c);
    if (step == 0) return refuse_line(reader, line, "not UTF-8 text (byte 0x%02x)", c[0]);
    const bool c1 = c[0] == 0xC2 && c[1] < 0xA0;
    const bool line_end = c[0] == '\n' || (c[0] == '\r' && (c[1] == '\n' || c[1] == '\0'));
    const bool control = c[0] < 0x20 || c[0] == 0x7F || c1;
    if (control && !line_end && c[0] != '\t') {
      return refuse_line(reader, line, "a control character (0x%02x)", c1 ? c[1] : c[0]);
    }
    if (c[0] == '\n') line++;
  }
  return true;
}

static bool is_blank(char c) { return c == ' ' || c == '\t'; }

/* A line, or a part of one: [start, end). */
typedef struct Span {
  const char *start, *end;
} Span;

static size_t span_length(Span span) { return (size_t)(span.end - span.start); }

static Span trim(Span span) {
  while (span.start < span.end && is_blank(*span.start)) span.start++;
  while (span.start < span.end && is_blank(span.end[-1])) span.end--;
  return span;
}

static bool same_text(const Reader *reader, size_t a, size_t a_length, size_t b, size_t b_length) {
  return a_length == b_length && memcmp(reader->text + a, reader->text + b, a_length) == 0;
}

/* An excerpt of a word for a message: whole, or its first characters. */
static int excerpt(Span span) {
  size_t length = span_length(span);
  if (length > WORD_LIMIT) length = WORD_LIMIT;
  while (length > 0 && is_continuation((unsigned char)span.start[length])) length--;
  return (int)length;
}

static bool check_word(Reader *reader, unsigned line, const char *what, Span word) {
  if (span_length(word) == 0) return refuse_line(reader, line, "a %s without a name", what);
  if (span_length(word) <= WORD_LIMIT) return true;
  return refuse_line(reader, line, "the %s '%.*s...' is longer than %d bytes", what, excerpt(word),
                     word.start, WORD_LIMIT);
}

/* inih ends an inline comment's text at a ';' after a blank. */
static bool is_comment(const char *at) { return *at == ';' && is_blank(at[-1]); }

static bool check_section(Reader *reader, unsigned line, Span span) {
  const Span inside = {span.start + 1, span.end};
  const char *end = inside.start;
  while (end < inside.end && *end != ']' && !is_comment(end)) end++;
  if (end == inside.end || *end != ']') return refuse_line(reader, line, "a '[' without a ']'");
  const Span name = {inside.start, end}, rest = trim((Span){end + 1, span.end});
  if (span_length(rest) > 0 && *rest.start != ';') {
    return refuse_line(reader, line, "'%.*s' after the section's ']'", excerpt(rest), rest.start);
  }
  if (!check_word(reader, line, "section", name)) return false;
  const Section section = {(uint16_t)(name.start - reader->text), (uint16_t)span_length(name),
                           (uint16_t)line};
  for (size_t i = 0; i < reader->section_count; i++) {
    const Section *const other = &reader->sections[i];
    if (same_text(reader, section.start, section.length, other->start, other->length)) {
      return refuse_line(reader, line, "section [%.*s] occurs twice, first in line %u",
                         excerpt(name), name.start, other->line);
    }
  }
  reader->sections[reader->section_count++] = section;
  return true;
}

/* Sections occur once, so the pairs of this one are the last. */
static bool check_duplicate(Reader *reader, const Pair *pair) {
  for (size_t i = reader->pair_count; i-- > 0 && reader->pairs[i].section == pair->section;) {
    const Pair *const other = &reader->pairs[i];
    if (same_text(reader, pair->key, pair->key_length, other->key, other->key_length)) {
      return refuse_line(reader, pair->line, "'%.*s' occurs twice in its section, first in line %u",
                         pair->key_length, reader->text + pair->key, other->line);
    }
  }
  return true;
}

static bool check_pair(Reader *reader, unsigned line, Span span) {
  const char *end = span.start;
  while (end < span.end && *end != '=' && *end != ':' && !is_comment(end)) end++;
  if (end == span.end || *end != '=') {
    return refuse_line(reader, line, "'%.*s' is neither [section], key = value nor ; comment",
                       excerpt(span), span.start);
  }
  const Span key = trim((Span){span.start, end});
  if (!check_word(reader, line, "key", key)) return false;
  if (reader->section_count == 0) {
    return refuse_line(reader, line, "'%.*s' stands before the first section", excerpt(key),
                       key.start);
  }
  const Section *const section = &reader->sections[reader->section_count - 1];
  const Pair pair = {section->start, section->length, (uint16_t)(key.start - reader->text),
                     (uint16_t)span_length(key), (uint16_t)line};
  if (!check_duplicate(reader, &pair)) return false;
  reader->pairs[reader->pair_count++] = pair;
  return true;
}

static bool check_line(Reader *reader, unsigned line, Span span) {
  const Span content = trim(span);
  const char first = span_length(content) > 0 ? *content.start : ';';
  if (first == ';' || first == '#') return true;
  if (content.start > span.start) return refuse_line(reader, line, "the line is indented");
  return first == '[' ? check_section(reader, line, content) : check_pair(reader, line, content);
}

static bool check_lines(Reader *reader) {
  const char *start = reader->text;
  const char *const end = reader->text + reader->length;
  for (unsigned line = 1; start < end; line++) {
    const char *line_end = memchr(start, '\n', (size_t)(end - start));
    const char *const next = line_end ? line_end + 1 : end;
    if (!line_end) line_end = end;
    if (line_end - start > PRESET_LINE_LIMIT) {
      return refuse_line(reader, line, "the line is longer than %d bytes", PRESET_LINE_LIMIT);
    }
    if (line_end > start && line_end[-1] == '\r') line_end--;
    if (!check_line(reader, line, (Span){start, line_end})) return false;
    if (next[-1] != '\n') {
      return refuse_line(reader, line, "the last line has no line end: was the file cut off?");
    }
    start = next;
  }
  return true;
}

static void drop_byte_order_mark(Reader *reader) {
  const size_t bytes = strlen(BYTE_ORDER_MARK);
  if (strncmp(reader->text, BYTE_ORDER_MARK, bytes) != 0) return;
  reader->length -= bytes;
  memmove(reader->text, reader->text + bytes, reader->length + 1);
}

static bool check_file(Reader *reader) {
  if (reader->length > PRESET_FILE_LIMIT) {
    return refuse_line(reader, 0, "the file is larger than %d bytes", PRESET_FILE_LIMIT);
  }
  drop_byte_order_mark(reader);
  if (!check_characters(reader) || !check_lines(reader)) return false;
  return reader->section_count > 0 || refuse_line(reader, 0, "the file holds no section");
}

/* Parsing ------------------------------------------------------------------------------------- */

static bool is_text(const Reader *reader, size_t start, size_t length, const char *text) {
  return strlen(text) == length && memcmp(reader->text + start, text, length) == 0;
}

/* Gives the caller a pair or, without key and value, a section. */
static bool give(Reader *reader, unsigned line, const char *section, const char *key,
                 const char *value) {
  char reason[512] = "refused";
  if (reader->pair(reader->context, section, key, value, line, reason, sizeof reason)) return true;
  reader->refused = true;
  return refuse_line(reader, line, "%s", reason);
}

/* Sections that begin before @p line. inih tells of a section only by its pairs. */
static bool give_sections(Reader *reader, unsigned line) {
  while (reader->sections_given < reader->section_count) {
    const Section *const section = &reader->sections[reader->sections_given];
    if (section->line >= line) break;
    char name[WORD_LIMIT + 1] = "";
    memcpy(name, reader->text + section->start, section->length);
    reader->sections_given++;
    if (!give(reader, section->line, name, NULL, NULL)) return false;
  }
  return true;
}

/* Called by inih, which goes on after an error: whatever follows it is passed over. */
static int take_pair(void *user, const char *section, const char *key, const char *value) {
  Reader *const reader = user;
  if (reader->refused) return 0;
  const bool expected = reader->pairs_given < reader->pair_count;
  const Pair pair = reader->pairs[expected ? reader->pairs_given : 0];
  reader->refused = !expected || !is_text(reader, pair.section, pair.section_length, section) ||
                    !is_text(reader, pair.key, pair.key_length, key);
  if (reader->refused) {
    (void)refuse_line(reader, pair.line, "inih takes the file apart differently from its checks");
    return 0;
  }
  reader->pairs_given++;
  return give_sections(reader, pair.line) && give(reader, pair.line, section, key, value);
}

static bool parse(Reader *reader) {
  const int line = ini_parse_string(reader->text, take_pair, reader);
  if (reader->refused) return false;
  if (line == 0 && reader->pairs_given == reader->pair_count)
    return give_sections(reader, UINT_MAX);
  return refuse_line(reader, line > 0 ? (unsigned)line : 0, "inih cannot take the file apart");
}

static Reader *reader_begin(const char *name, char *message, size_t size) {
  Reader *const reader = calloc(1, sizeof *reader);
  if (size > 0) message[0] = '\0';
  if (!reader) {
    (void)snprintf(message, size, "out of memory");
    return NULL;
  }
  reader->path = name;
  reader->message = message;
  reader->size = size;
  return reader;
}

static PresetFileStatus give_all(Reader *reader, PresetPairFn *pair, void *context) {
  reader->pair = pair;
  reader->context = context;
  return check_file(reader) && parse(reader) ? PRESET_FILE_OK : PRESET_FILE_INVALID;
}

static bool copy_out(const Reader *reader, char **text, size_t *length) {
  *text = malloc(reader->length + 1);
  if (!*text) return false;
  memcpy(*text, reader->text, reader->length + 1);
  *length = reader->length;
  return true;
}

PresetFileStatus preset_file_load(const char *path, char **text, size_t *length, char *message,
                                  size_t size) {
  Reader *const reader = reader_begin(path, message, size);
  *text = NULL;
  bool is_loaded = reader && read_file(reader);
  if (is_loaded && !copy_out(reader, text, length)) {
    is_loaded = refuse_line(reader, 0, "out of memory");
  }
  free(reader);
  return is_loaded ? PRESET_FILE_OK : PRESET_FILE_UNREADABLE;
}

PresetFileStatus preset_file_parse(const char *name, const char *text, size_t length,
                                   PresetPairFn *pair, void *context, char *message, size_t size) {
  Reader *const reader = reader_begin(name, message, size);
  if (!reader) return PRESET_FILE_UNREADABLE;
  reader->length = length <= PRESET_FILE_LIMIT ? length : PRESET_FILE_LIMIT + 1;
  memcpy(reader->text, text, reader->length);
  const PresetFileStatus status = give_all(reader, pair, context);
  free(reader);
  return status;
}

PresetFileStatus preset_file_read(const char *path, PresetPairFn *pair, void *context,
                                  char *message, size_t size) {
  Reader *const reader = reader_begin(path, message, size);
  PresetFileStatus status = PRESET_FILE_UNREADABLE;
  if (reader && read_file(reader)) status = give_all(reader, pair, context);
  free(reader);
  return status;
}
