/* SPDX-License-Identifier: MIT */
/**
 * @file message.h
 * Messages on standard error, and the exit status.
 *
 * A function that fails prints one line about its error and returns the outcome; its callers only
 * return the outcome. So every error is printed once, where most is known about it. Any thread may
 * print; lines are never interleaved.
 */
#ifndef TABOR_HOST_MESSAGE_H
#define TABOR_HOST_MESSAGE_H

#include <stddef.h>
#include <tabor/tabor.h>

/* PRINTF_AT(FORMAT, FIRST): the numbers of these parameters, counted from 1. */
#ifdef __GNUC__
/* With C11's formats: gcc takes those of Windows for "printf" there. */
#  if defined(__MINGW32__) && !defined(__clang__)
#    define PRINTF_AT(text, first) __attribute__((format(gnu_printf, text, first)))
#  else
#    define PRINTF_AT(text, first) __attribute__((format(printf, text, first)))
#  endif
#else
#  define PRINTF_AT(text, first)
#endif
#define PRINTF_LIKE PRINTF_AT(1, 2)

/** How a request ended; the values are the program's exit status. */
typedef enum Outcome {
  OUTCOME_OK = 0,
  OUTCOME_FAILED = 1,       /**< a valid request failed: files, memory, devices */
  OUTCOME_REFUSED = 2,      /**< the request is invalid */
  OUTCOME_READER_LEFT = 141 /**< the reader of standard output is gone; ends without a message,
                                 with the status of SIGPIPE */
} Outcome;

/** Prints what is wrong with the request; returns OUTCOME_REFUSED. */
PRINTF_LIKE Outcome refuse(const char *format, ...);
/** Prints what failed; returns OUTCOME_FAILED. */
PRINTF_LIKE Outcome fail(const char *format, ...);
/** fail() for lack of memory. */
Outcome fail_memory(void);
/** Fails with the reason of errno; prints nothing if the reader is gone, as in 'tabor modes |
 * head'. */
Outcome standard_output_failure(void);
/** Prints an error of the engine: refused for invalid requests, failed for memory and numerics. */
Outcome report_engine_error(const TaborError *error);
/** Prints a warning; the request is executed nevertheless. */
PRINTF_LIKE void warn(const char *format, ...);
/** Prints a piece of information. */
PRINTF_LIKE void note(const char *format, ...);

/** Sets the subject of this thread's messages, a prefix of messages that do not name it. NULL:
 * none. */
void message_subject(const char *subject);

/** Takes a message, one line without its end. Called by any thread, one at a time; must not print.
 */
typedef void MessageSink(void *context, const char *line);

/** Sends every message to @p sink instead of standard error; NULL: back to standard error. */
void message_redirect(MessageSink *sink, void *context);
/** Buffer for the messages of a thread that are captured instead of printed. */
typedef struct MessageCapture {
  char *text; /**< NULL: messages are printed */
  size_t size;
} MessageCapture;

/**
 * Captures this thread's messages until message_release(). @p text gets the first line, "" if there
 * is none; nothing is printed. Returns the argument of message_release(). Captures may be nested.
 */
MessageCapture message_capture(char *text, size_t size);
void message_release(MessageCapture before);

/** Shows a line that the next status line or any message replaces; "" removes it. For terminals. */
void status_line(const char *text);

/** Returns "standard input" for "-", any other name unchanged. */
const char *input_name(const char *name);
/** Returns the quote around input_name(): none for standard input. */
const char *input_quote(const char *name);
/** Format of an input file in a message: "cannot read " INPUT with the arguments INPUT_OF(name). */
#define INPUT "%s%s%s"
#define INPUT_OF(name) input_quote(name), input_name(name), input_quote(name)

#endif
