/* SPDX-License-Identifier: MIT */
#include "definition/error.h"
#include "definition/def_text.h"

#include <assert.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* Longest text that %s writes, so that one cannot push what comes after it out of the message. No
 * full key is longer. */
#define TEXT_LIMIT 96

/* Room left in a message. */
typedef struct Writer {
  char *at;
  size_t room; /* terminator included */
} Writer;

static void write_text(Writer *writer, const char *text) {
  tb_text_copy(writer->at, writer->room, text);
  const size_t length = strlen(writer->at);
  writer->at += length;
  writer->room -= length;
}

static void write_argument(Writer *writer, const char *text) {
  char cut[TEXT_LIMIT + 1];
  tb_text_copy(cut, sizeof cut, text);
  write_text(writer, cut);
  if (strlen(text) > TEXT_LIMIT) write_text(writer, "...");
}

/* @p conversion is what follows the '%'; returns its last character. */
static const char *write_conversion(Writer *writer, const char *conversion, va_list *arguments) {
  char text[TB_NUMBER_SIZE] = "%";
  switch (*conversion) {
  case 's': {
    const char *const string = va_arg(*arguments, const char *);
    write_argument(writer, string ? string : "");
    return conversion;
  }
  case 'd': (void)snprintf(text, sizeof text, "%d", va_arg(*arguments, int)); break;
  case 'u': (void)snprintf(text, sizeof text, "%u", va_arg(*arguments, unsigned)); break;
  case 'c': (void)snprintf(text, sizeof text, "%c", va_arg(*arguments, int)); break;
  case 'g': tb_number_print(va_arg(*arguments, double), text); break;
  case 'z':
    conversion++;
    assert(*conversion == 'u');
    (void)snprintf(text, sizeof text, "%zu", va_arg(*arguments, size_t));
    break;
  default: assert(*conversion == '%'); break;
  }
  write_text(writer, text);
  return conversion;
}

static void write_message(Writer writer, const char *format, va_list *arguments) {
  for (const char *c = format; *c; c++) {
    if (*c == '%') {
      c = write_conversion(&writer, c + 1, arguments);
    } else { /* up to the next conversion, so that characters of several bytes stay whole */
      char literal[TABOR_TEXT_SIZE];
      size_t length = strcspn(c, "%");
      if (length >= sizeof literal) length = sizeof literal - 1;
      memcpy(literal, c, length);
      literal[length] = '\0';
      write_text(&writer, literal);
      c += length - 1;
    }
  }
}

TaborStatus tb_error_set(TaborError *error, TaborStatus status, const char *key, const char *value,
                         double minimum, double maximum, const char *format, ...) {
  if (!error) return status;
  memset(error, 0, sizeof *error);
  error->status = status;
  tb_text_copy(error->key, sizeof error->key, key ? key : "");
  tb_text_copy(error->value, sizeof error->value, value ? value : "");
  error->minimum = minimum;
  error->maximum = maximum;
  va_list arguments;
  va_start(arguments, format);
  write_message((Writer){error->message, sizeof error->message}, format, &arguments);
  va_end(arguments);
  return status;
}

TaborStatus tb_error_null(TaborError *error, const char *what) {
  return tb_error_set(error, TABOR_ERROR_ARGUMENT, NULL, NULL, (double)NAN, (double)NAN,
                      "the %s is NULL", what);
}

TaborStatus tb_error_place(TaborError *error, TaborStatus status, uint32_t line, uint32_t column) {
  if (!error) return status;
  error->line = line;
  error->column = column;
  return status;
}

TaborStatus tb_error_add(TaborError *error, TaborStatus status, const char *text) {
  if (!error) return status;
  const size_t length = strlen(error->message);
  tb_text_copy(error->message + length, sizeof error->message - length, text);
  return status;
}

TaborStatus tb_error_clear(TaborError *error) {
  return tb_error_set(error, TABOR_OK, NULL, NULL, (double)NAN, (double)NAN, "%s", "");
}
