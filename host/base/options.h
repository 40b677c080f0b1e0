/* SPDX-License-Identifier: MIT */
/**
 * @file options.h
 * Commands, their options, and the reading of a command line by these tables.
 *
 * "--rate 48000", "--rate=48000", "-o FILE", "-oFILE" and "-nq" all work; options may follow
 * operands; "--" ends the options. Where an option that is not repeatable comes twice, the last one
 * counts.
 */
#ifndef TABOR_HOST_OPTIONS_H
#define TABOR_HOST_OPTIONS_H

#include "base/number.h"

/** One row of a table of options; tables end with a row without a name. */
typedef struct Option {
  const char *name;  /**< "rate" for --rate */
  char letter;       /**< 'o' for -o, or 0 */
  const char *value; /**< what to write for its value in the help, "HZ"; NULL if it takes none */
  const char *text;  /**< one line of help */
} Option;

typedef struct Arguments Arguments;

typedef struct Command {
  const char *name;
  const char
    *operand; /**< "[PRESET]", or NULL if it takes none; takes several if it ends in "..." */
  const char *summary; /**< one line */
  const char *notes;   /**< further lines of help, or NULL */
  const Option *options;
  Outcome (*run)(const Arguments *arguments);
} Command;

/** An option that was given. */
typedef struct OptionUse {
  const Option *option;
  const char *value; /**< NULL if it takes none */
} OptionUse;

/** A command line, read. Points into argv. */
struct Arguments {
  OptionUse *uses;
  size_t use_count;
  const char **operands;
  size_t operand_count;
  const char *operand; /**< the first; NULL if none was given */
};

/** Options that every command has. */
extern const Option common_options[];

/** Reads argv[1...] by @p command's table. Free with arguments_free(), whatever the outcome. */
Outcome arguments_read(const Command *command, int argc, char *const *argv, Arguments *arguments);
void arguments_free(Arguments *arguments);

/** Copies @p from with @p operand as its only one, or without any if that is NULL. */
Outcome arguments_copy(const Arguments *from, const char *operand, Arguments *copy);
/** Where option @p name was given, it is as if it had been once, with @p value (not copied). */
void arguments_replace(Arguments *arguments, const char *name, const char *value);

/** True if option @p name was given. */
bool arguments_has(const Arguments *arguments, const char *name);
/** Value of the last option @p name, or NULL. */
const char *arguments_value(const Arguments *arguments, const char *name);
/** Reads that as a number: the option is @p field's name, "--rate". Not given, *value stays. */
Outcome arguments_number(const Arguments *arguments, const NumberField *field, double *value);
/** Value of the next option @p name from *position on, which moves behind it; NULL at the end. */
const char *arguments_next(const Arguments *arguments, const char *name, size_t *position);

#endif
