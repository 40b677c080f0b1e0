/* SPDX-License-Identifier: MIT */
/**
 * @file options.h
 * Tables of commands and options, and a parser of the command line for them.
 *
 * "--rate 48000", "--rate=48000", "-o FILE", "-oFILE" and "-nq" all work. Options may follow
 * operands;
 * "--" ends the options. If an option that is not repeatable comes twice, the last one counts.
 */
#ifndef TABOR_HOST_OPTIONS_H
#define TABOR_HOST_OPTIONS_H

#include "base/number.h"

/** One row of a table of options; tables end with a row without a name. */
typedef struct Option {
  const char *name;  /**< "rate" for --rate */
  char letter;       /**< 'o' for -o, or 0 */
  const char *value; /**< placeholder of its value in the help, "HZ"; NULL without a value */
  const char *text;  /**< one line of help */
} Option;

typedef struct Arguments Arguments;

typedef struct Command {
  const char *name;
  /** "[PRESET]"; a name that ends in "..." takes several; NULL without operands. */
  const char *operand;
  const char *summary; /**< one line */
  const char *notes;   /**< further lines of help, or NULL */
  const Option *options;
  Outcome (*run)(const Arguments *arguments);
} Command;

/** An option on the command line. */
typedef struct OptionUse {
  const Option *option;
  const char *value; /**< NULL without a value */
} OptionUse;

/** A parsed command line. Points into argv. */
struct Arguments {
  OptionUse *uses;
  size_t use_count;
  const char **operands;
  size_t operand_count;
  const char *operand; /**< the first operand; NULL without operands */
};

/** Options of every command. */
extern const Option common_options[];

/** Parses argv[1...] with @p command's table. Free with arguments_free(), whatever the outcome. */
Outcome arguments_read(const Command *command, int argc, char *const *argv, Arguments *arguments);
void arguments_free(Arguments *arguments);

/** Copies @p from with @p operand as its only operand; NULL: without operands. */
Outcome arguments_copy(const Arguments *from, const char *operand, Arguments *copy);
/** Replaces all uses of option @p name, if any, by one use with @p value (not copied). */
void arguments_replace(Arguments *arguments, const char *name, const char *value);

/** True if option @p name was given. */
bool arguments_has(const Arguments *arguments, const char *name);
/** Value of the last use of option @p name, or NULL. */
const char *arguments_value(const Arguments *arguments, const char *name);
/** Reads the value of option @p field->name, "--rate", as a number. *value stays if it was not
 * given. */
Outcome arguments_number(const Arguments *arguments, const NumberField *field, double *value);
/** Value of the next use of option @p name from *position on; moves *position past it. NULL at the
 * end. */
const char *arguments_next(const Arguments *arguments, const char *name, size_t *position);

#endif
