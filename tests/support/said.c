/* SPDX-License-Identifier: MIT */
#include "said.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/message.h"

char said[1024];
unsigned said_count;

void said_nothing(void) {
  said[0] = '\0';
  said_count = 0;
}

#define KEEP(format)                                                                               \
  va_list arguments;                                                                               \
  va_start(arguments, format);                                                                     \
  (void)vsnprintf(said, sizeof said, format, arguments);                                           \
  va_end(arguments);                                                                               \
  said_count++

Outcome refuse(const char *format, ...) {
  KEEP(format);
  return OUTCOME_REFUSED;
}

Outcome fail(const char *format, ...) {
  KEEP(format);
  return OUTCOME_FAILED;
}

void note(const char *format, ...) { KEEP(format); }
void warn(const char *format, ...) { KEEP(format); }

Outcome fail_memory(void) { return fail("out of memory"); }
const char *input_name(const char *name) {
  return strcmp(name, "-") == 0 ? "standard input" : name;
}
const char *input_quote(const char *name) { return strcmp(name, "-") == 0 ? "" : "'"; }
