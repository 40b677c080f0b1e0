/* SPDX-License-Identifier: MIT */
/**
 * @file message.h
 * What the program says on standard error, and the exit status that goes with it.
 *
 * A function that can go wrong says so itself, in one line, and returns the outcome; its callers
 * only pass the outcome on. So every error is printed once, where most is known about it. Any
 * thread may speak: lines stay whole.
 */
#ifndef TABOR_HOST_MESSAGE_H
#define TABOR_HOST_MESSAGE_H

#include <stddef.h>
#include <tabor/tabor.h>

#ifdef __GNUC__
#  define PRINTF_LIKE __attribute__((format(printf, 1, 2)))
#else
#  define PRINTF_LIKE
#endif

/** How a request ended; the values are the program's exit status. */
typedef enum Outcome {
  OUTCOME_OK = 0,
  OUTCOME_FAILED = 1,       /**< a right request failed: files, memory, devices */
  OUTCOME_REFUSED = 2,      /**< the request is wrong */
  OUTCOME_READER_LEFT = 141 /**< nobody reads the standard output any more; nothing to say: it is as
                                 if SIGPIPE had ended the program */
} Outcome;

/** Says what is wrong with the request; returns OUTCOME_REFUSED. */
PRINTF_LIKE Outcome refuse(const char *format, ...);
/** Says what failed; returns OUTCOME_FAILED. */
PRINTF_LIKE Outcome fail(const char *format, ...);
/** fail() for memory. */
Outcome fail_memory(void);
/** Fails with the reason of errno; says nothing where the reader left, as in 'tabor modes | head'. */
Outcome standard_output_failure(void);
/** Says what the engine found wrong: refused for wrong requests, failed for memory and numerics. */
Outcome report_engine_error(const TaborError *error);
/** Something the user should know although the request is carried out. */
PRINTF_LIKE void warn(const char *format, ...);
/** Something the user may like to know. */
PRINTF_LIKE void note(const char *format, ...);

/** What this thread's messages are about: put before those that do not name it. NULL: nothing. */
void message_subject(const char *subject);

/** Takes a message, one line without its end. Called by any thread, one at a time; must not speak. */
typedef void MessageSink(void *context, const char *line);

/** From now on @p sink gets every message instead of the standard error; NULL: as before. */
void message_redirect(MessageSink *sink, void *context);
/** Where what a thread says goes instead of being seen. */
typedef struct MessageCapture {
  char *text; /**< NULL: nowhere, it is seen */
  size_t size;
} MessageCapture;

/**
 * Until message_release(), what this thread says comes into @p text, the first line of it, "" if there
 * is none; nobody else sees it. Returns what message_release() needs; captures may lie within each other.
 */
MessageCapture message_capture(char *text, size_t size);
void message_release(MessageCapture before);

/** Shows a line that the next one or any message replaces; "" takes it away. For terminals. */
void status_line(const char *text);

/** "standard input" for "-", any other name as it is. */
const char *input_name(const char *name);
/** The quote that goes around input_name(): none around the standard input. */
const char *input_quote(const char *name);
/** An input file in a message: "cannot read " INPUT with the arguments INPUT_OF(name). */
#define INPUT "%s%s%s"
#define INPUT_OF(name) input_quote(name), input_name(name), input_quote(name)

#endif
