/* SPDX-License-Identifier: MIT */
#include "definition/text_write.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "definition/error.h"

#define COMMENT_COLUMN 37 /* where comments begin */
#define COMMENT_SIZE 512

TbTextWriter tb_text_write_begin(char *text, size_t size, uint32_t form, TaborError *error) {
  TbTextWriter writer = {.text = text, .size = text ? size : 0, .error = error};
  if (!text && size > 0) writer.status = tb_error_null(error, "text");
  if (form > TABOR_TEXT_KEEP) {
    writer.status = tb_error_set(error, TABOR_ERROR_ARGUMENT, NULL, NULL, 0, TABOR_TEXT_KEEP,
                                 "the form %u of a text is none", (unsigned)form);
  }
  return writer;
}

static void write_bytes(TbTextWriter *writer, const char *bytes, size_t count) {
  if (writer->length < writer->size) {
    const size_t room = writer->size - writer->length;
    memcpy(writer->text + writer->length, bytes, count < room ? count : room);
  }
  writer->length += count;
}

static void write_text(TbTextWriter *writer, const char *text) {
  write_bytes(writer, text, strlen(text));
}

void tb_text_write_section(TbTextWriter *writer, const char *section, size_t length) {
  if (writer->status != TABOR_OK) return;
  if (writer->length > 0) write_text(writer, "\n");
  write_text(writer, "[");
  write_bytes(writer, section, length);
  write_text(writer, "]\n");
}

/* True if the text, which nothing quotes, is read back as it is. */
static bool survives(const char *value) {
  const size_t length = strlen(value);
  if (length == 0) return true;
  return value[0] != ' ' && value[0] != ';' && value[length - 1] != ' ' && !strstr(value, " ;");
}

static TaborStatus refuse_value(const TbTextWriter *writer, const char *key, const char *value) {
  return tb_error_set(
    writer->error, TABOR_ERROR_VALUE, key, value, NAN, NAN,
    "%s: a file cannot hold the text '%s', as nothing quotes it: it begins with a "
    "blank or ';', ends with a blank, or has ' ;' in it",
    key, value);
}

/* "; [N/m] what", or nothing. */
static void join_comment(char comment[COMMENT_SIZE], const char *unit, const char *what) {
  const bool has_unit = unit && *unit, has_text = what && *what;
  comment[0] = '\0';
  if (!has_unit && !has_text) return;
  (void)snprintf(comment, COMMENT_SIZE, "; %s%s%s%s%s", has_unit ? "[" : "", has_unit ? unit : "",
                 has_unit ? "]" : "", has_unit && has_text ? " " : "", has_text ? what : "");
}

static void write_comment(TbTextWriter *writer, const char *comment, size_t length) {
  for (size_t column = length + 1; column < COMMENT_COLUMN; column++) write_text(writer, " ");
  write_text(writer, " ");
  write_text(writer, comment);
}

void tb_text_write_pair(TbTextWriter *writer, const char *full, const char *key, const char *value,
                        const char *unit, const char *what) {
  if (writer->status != TABOR_OK) return;
  if (!survives(value)) {
    writer->status = refuse_value(writer, full, value);
    return;
  }
  char comment[COMMENT_SIZE];
  join_comment(comment, unit, what);
  const size_t length = strlen(key) + strlen(" = ") + strlen(value), place = COMMENT_COLUMN;
  const size_t before = length + 1 < place ? place : length + 1;
  const bool is_apart = *comment && before + strlen(comment) > TABOR_TEXT_LINE;
  if (is_apart) {
    write_text(writer, comment);
    write_text(writer, "\n");
  }
  write_text(writer, key);
  write_text(writer, " = ");
  write_text(writer, value);
  if (*comment && !is_apart) write_comment(writer, comment, length);
  write_text(writer, "\n");
}

TaborStatus tb_text_write_end(TbTextWriter *writer, size_t *length) {
  const bool fits = !writer->text || writer->length < writer->size;
  if (writer->status == TABOR_OK && !fits) {
    writer->status = tb_error_set(writer->error, TABOR_ERROR_ARGUMENT, NULL, NULL, NAN, NAN,
                                  "the text has %zu bytes and does not fit into %zu",
                                  writer->length, writer->size);
  }
  const bool is_good = writer->status == TABOR_OK;
  if (writer->size > 0) writer->text[is_good ? writer->length : 0] = '\0';
  if (length) *length = is_good ? writer->length : 0;
  return is_good ? tb_error_clear(writer->error) : writer->status;
}
