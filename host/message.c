/* SPDX-License-Identifier: MIT */
#include "message.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* User input appears in messages: without this a line feed in it would make two lines of one. */
static void replace_controls(char *text) {
  for (; *text; text++) {
    if ((unsigned char)*text < 0x20 || *text == 0x7f) *text = '?';
  }
}

static void say(const char *prefix, const char *format, va_list arguments) {
  char line[1024];
  (void)vsnprintf(line, sizeof line, format, arguments);
  replace_controls(line);
  (void)fprintf(stderr, "%s%s\n", prefix, line);
}

Outcome refuse(const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  say("tabor: ", format, arguments);
  va_end(arguments);
  return OUTCOME_REFUSED;
}

Outcome fail(const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  say("tabor: ", format, arguments);
  va_end(arguments);
  return OUTCOME_FAILED;
}

Outcome fail_memory(void) { return fail("out of memory"); }

Outcome standard_output_failure(void) {
  if (errno == EPIPE) return OUTCOME_READER_LEFT;
  return fail("cannot write to standard output: %s", strerror(errno));
}

Outcome report_engine_error(const TaborError *error) {
  switch (error->status) {
  case TABOR_OK: return OUTCOME_OK;
  case TABOR_ERROR_KEY:
  case TABOR_ERROR_NAME:
  case TABOR_ERROR_VALUE:
  case TABOR_ERROR_RANGE:
  case TABOR_ERROR_FULL: return refuse("%s", error->message);
  case TABOR_ERROR_ARGUMENT:
  case TABOR_ERROR_MEMORY:
  case TABOR_ERROR_NUMERICS:
  case TABOR_ERROR_STATE: break;
  }
  return fail("%s", error->message);
}

void warn(const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  say("tabor: warning: ", format, arguments);
  va_end(arguments);
}

void note(const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  say("", format, arguments);
  va_end(arguments);
}
