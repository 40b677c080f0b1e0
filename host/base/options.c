/* SPDX-License-Identifier: MIT */
#include "base/options.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/suggest.h"

const Option common_options[] = {
  {"json", 0, NULL, "print facts as JSON on standard output"},
  {"quiet", 'q', NULL, "print nothing but errors and warnings"},
  {"help", 'h', NULL, "print this help and do nothing else"},
  {"version", 0, NULL, "print the version and do nothing else"},
  {0},
};

/* A command line while it is being read. */
typedef struct Reader {
  const Command *command;
  char *const *argv;
  int argc, next;
  Arguments *arguments;
} Reader;

static const Option *option_at(const Command *command, size_t index) {
  size_t own = 0;
  while (command->options[own].name) own++;
  const Option *const option =
    index < own ? &command->options[index] : &common_options[index - own];
  return option->name ? option : NULL;
}

static const char *option_name_at(const void *command, size_t index) {
  const Option *const option = option_at(command, index);
  return option ? option->name : NULL;
}

static const Option *find_name(const Command *command, const char *name, size_t length) {
  const Option *option;
  for (size_t i = 0; (option = option_at(command, i)) != NULL; i++) {
    if (strlen(option->name) == length && memcmp(option->name, name, length) == 0) break;
  }
  return option;
}

static const Option *find_letter(const Command *command, char letter) {
  const Option *option;
  for (size_t i = 0; (option = option_at(command, i)) != NULL; i++) {
    if (option->letter == letter) break;
  }
  return option;
}

static void add_use(Reader *reader, const Option *option, const char *value) {
  reader->arguments->uses[reader->arguments->use_count++] = (OptionUse){option, value};
}

static Outcome unknown_option(const Command *command, const char *text, size_t length) {
  char word[64] = "", hint[96];
  if (length < sizeof word) {
    memcpy(word, text, length);
    word[length] = '\0';
  }
  suggest_hint(hint, sizeof hint, word, "--", option_name_at, command);
  return refuse("unknown option '--%.*s'%s", (int)(length < 80 ? length : 80), text, hint);
}

/* Takes the next argument as the value of an option that was written without one. */
static Outcome take_value(Reader *reader, const Option *option) {
  if (reader->next == reader->argc) {
    return refuse("--%s needs a value (%s)", option->name, option->value);
  }
  add_use(reader, option, reader->argv[reader->next++]);
  return OUTCOME_OK;
}

static Outcome read_long(Reader *reader, const char *text) {
  const size_t length = strcspn(text, "=");
  const Option *const option = find_name(reader->command, text, length);
  if (!option) return unknown_option(reader->command, text, length);
  const char *const value = text[length] ? text + length + 1 : NULL;
  if (!option->value && value)
    return refuse("--%s takes no value, but '%s' was given", option->name, value);
  if (option->value && !value) return take_value(reader, option);
  add_use(reader, option, value);
  return OUTCOME_OK;
}

static Outcome read_letters(Reader *reader, const char *letters) {
  for (; *letters; letters++) {
    const Option *const option = find_letter(reader->command, *letters);
    if (!option) return refuse("unknown option '-%c'", *letters);
    if (option->value && letters[1]) {
      add_use(reader, option, letters + 1);
      return OUTCOME_OK;
    }
    if (option->value) return take_value(reader, option);
    add_use(reader, option, NULL);
  }
  return OUTCOME_OK;
}

static size_t most_operands(const Command *command) {
  if (!command->operand) return 0;
  return strstr(command->operand, "...") ? SIZE_MAX : 1;
}

static Outcome read_operand(Reader *reader, const char *text) {
  Arguments *const arguments = reader->arguments;
  if (arguments->operand_count == most_operands(reader->command)) {
    return refuse("unexpected argument '%s'", text);
  }
  arguments->operands[arguments->operand_count++] = text;
  arguments->operand = arguments->operands[0];
  return OUTCOME_OK;
}

/* Every letter of a cluster is a use, so characters are counted, not arguments. */
static size_t most_uses(int argc, char *const *argv) {
  size_t most = 1;
  for (int i = 1; i < argc; i++)
    most += argv[i][0] == '-' && argv[i][1] != '-' ? strlen(argv[i]) : 1;
  return most;
}

Outcome arguments_read(const Command *command, int argc, char *const *argv, Arguments *arguments) {
  *arguments = (Arguments){0};
  arguments->uses = calloc(most_uses(argc, argv), sizeof *arguments->uses);
  arguments->operands = calloc((size_t)argc + 1, sizeof *arguments->operands);
  if (!arguments->uses || !arguments->operands) return fail_memory();
  Reader reader = {command, argv, argc, 1, arguments};
  bool options_ended = false;
  Outcome outcome = OUTCOME_OK;
  while (outcome == OUTCOME_OK && reader.next < argc) {
    const char *const text = argv[reader.next++];
    if (options_ended || text[0] != '-' || text[1] == '\0') {
      outcome = read_operand(&reader, text);
    } else if (strcmp(text, "--") == 0) {
      options_ended = true;
    } else if (text[1] == '-') {
      outcome = read_long(&reader, text + 2);
    } else {
      outcome = read_letters(&reader, text + 1);
    }
  }
  return outcome;
}

void arguments_free(Arguments *arguments) {
  free(arguments->uses);
  free(arguments->operands);
  *arguments = (Arguments){0};
}

Outcome arguments_copy(const Arguments *from, const char *operand, Arguments *copy) {
  *copy = (Arguments){.use_count = from->use_count, .operand = operand};
  copy->uses = calloc(from->use_count + 1, sizeof *copy->uses);
  copy->operands = calloc(1, sizeof *copy->operands);
  if (!copy->uses || !copy->operands) return fail_memory();
  if (from->use_count > 0) memcpy(copy->uses, from->uses, from->use_count * sizeof *copy->uses);
  if (operand) copy->operands[copy->operand_count++] = operand;
  return OUTCOME_OK;
}

void arguments_replace(Arguments *arguments, const char *name, const char *value) {
  OptionUse *kept = NULL;
  size_t count = 0;
  for (size_t i = 0; i < arguments->use_count; i++) {
    const OptionUse use = arguments->uses[i];
    const bool is_named = strcmp(use.option->name, name) == 0;
    if (is_named && kept) continue;
    arguments->uses[count] = use;
    if (is_named) kept = &arguments->uses[count];
    count++;
  }
  if (kept) kept->value = value;
  arguments->use_count = count;
}

bool arguments_has(const Arguments *arguments, const char *name) {
  for (size_t i = 0; i < arguments->use_count; i++) {
    if (strcmp(arguments->uses[i].option->name, name) == 0) return true;
  }
  return false;
}

const char *arguments_next(const Arguments *arguments, const char *name, size_t *position) {
  while (*position < arguments->use_count) {
    const OptionUse *const use = &arguments->uses[(*position)++];
    if (strcmp(use->option->name, name) == 0) return use->value;
  }
  return NULL;
}

const char *arguments_value(const Arguments *arguments, const char *name) {
  const char *value = NULL, *last = NULL;
  size_t position = 0;
  while ((value = arguments_next(arguments, name, &position)) != NULL) last = value;
  return last;
}

Outcome arguments_number(const Arguments *arguments, const NumberField *field, double *value) {
  const char *const text = arguments_value(arguments, field->name + strlen("--"));
  return text ? number_read(field, text, value) : OUTCOME_OK;
}
