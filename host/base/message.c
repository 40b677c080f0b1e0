/* SPDX-License-Identifier: MIT */
#include "base/message.h"

#include <errno.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LONGEST_LINE 1000 /* bytes */

static _Thread_local const char *thread_subject;
static _Thread_local MessageCapture captured;
static pthread_mutex_t speaking = PTHREAD_MUTEX_INITIALIZER;
static MessageSink *sink; /* or NULL; this and its context while speaking */
static void *sink_context;
static int status_length; /* of what stands on the terminal; while speaking */

void message_subject(const char *subject) { thread_subject = subject; }

void message_redirect(MessageSink *new_sink, void *context) {
  (void)pthread_mutex_lock(&speaking);
  sink = new_sink;
  sink_context = context;
  (void)pthread_mutex_unlock(&speaking);
}

MessageCapture message_capture(char *text, size_t size) {
  const MessageCapture before = captured;
  captured = (MessageCapture){text, size};
  if (size > 0) text[0] = '\0';
  return before;
}

void message_release(MessageCapture before) { captured = before; }

static void wipe_status(void) {
  if (status_length > 0) (void)fprintf(stderr, "\r%*s\r", status_length, "");
  status_length = 0;
}

void status_line(const char *text) {
  (void)pthread_mutex_lock(&speaking);
  wipe_status();
  const int length = fprintf(stderr, "%s", text);
  status_length = length > 0 ? length : 0;
  (void)pthread_mutex_unlock(&speaking);
}

/* User input appears in messages: without this a line feed in it would make two lines of one. */
static void replace_controls(char *text) {
  for (; *text; text++) {
    if ((unsigned char)*text < 0x20 || *text == 0x7f) *text = '?';
  }
}

/* Start of the first whole character at or behind @p text, which may lie within one of UTF-8. */
static const char *whole(const char *text) {
  while (((unsigned char)*text & 0xC0u) == 0x80u) text++;
  return text;
}

static void capture(const char *line) {
  if (captured.size == 0 || *captured.text) return;
  (void)snprintf(captured.text, captured.size, "%s", line);
}

/* A path can be as long as it likes: the middle goes, so that the reason at the end is seen. */
static void print_line(const char *prefix, const char *line) {
  const size_t length = strlen(line);
  char text[LONGEST_LINE + 64]; /* and a prefix, and a character that does not end at the middle */
  if (length <= LONGEST_LINE) {
    (void)snprintf(text, sizeof text, "%s%s", prefix, line);
  } else {
    const char *const head = whole(line + LONGEST_LINE / 2);
    const char *const tail = whole(line + length - LONGEST_LINE / 2);
    (void)snprintf(text, sizeof text, "%s%.*s...%s", prefix, (int)(head - line), line, tail);
  }
  if (sink) {
    sink(sink_context, text);
  } else {
    (void)fprintf(stderr, "%s\n", text);
  }
}

static void print(const char *prefix, char *line) {
  replace_controls(line);
  if (captured.text) {
    capture(line);
    return;
  }
  (void)pthread_mutex_lock(&speaking);
  wipe_status();
  print_line(prefix, line);
  (void)pthread_mutex_unlock(&speaking);
}

/* "SUBJECT: text", or the text alone if it names the subject or there is none; NULL without memory.
 */
static char *with_subject(const char *text) {
  const bool named = !thread_subject || strstr(text, thread_subject);
  const char *const subject = named ? "" : thread_subject;
  const size_t size = strlen(subject) + strlen(text) + sizeof ": ";
  char *const line = malloc(size);
  if (line) (void)snprintf(line, size, "%s%s%s", subject, named ? "" : ": ", text);
  return line;
}

/* Without memory for a long line its beginning is printed, without the subject. */
static void say(const char *prefix, const char *format, va_list arguments) {
  char first[LONGEST_LINE];
  va_list again;
  va_copy(again, arguments);
  const int length = vsnprintf(first, sizeof first, format, arguments);
  char *const longer = length >= LONGEST_LINE ? malloc((size_t)length + 1) : NULL;
  if (longer) (void)vsnprintf(longer, (size_t)length + 1, format, again);
  char *const text = longer ? longer : first, *const line = with_subject(text);
  print(prefix, line ? line : text);
  free(line);
  free(longer);
  va_end(again);
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
  case TABOR_ERROR_STATE:
  case TABOR_ERROR_LIMIT:
  case TABOR_ERROR_CANCELLED: break;
  }
  return fail("%s", error->message);
}

const char *input_name(const char *name) {
  return strcmp(name, "-") == 0 ? "standard input" : name;
}

const char *input_quote(const char *name) { return strcmp(name, "-") == 0 ? "" : "'"; }

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
