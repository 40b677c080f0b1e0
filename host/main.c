/* SPDX-License-Identifier: MIT */
/**
 * @file main.c
 * `tabor COMMAND [OPTION]...`: finds the command, reads its command line, and runs it.
 */
#include <stdio.h>
#include <string.h>

#include "base/command.h"
#include "base/interrupt.h"
#include "base/json_output.h"
#include "base/suggest.h"
#include "platform/process.h"

static const Command *const commands[] = {&render_command,
                                          &library_command,
                                          &play_command,
                                          &presets_command,
                                          &show_command,
                                          &modes_command,
                                          &bench_command,
                                          &analyze_command,
                                          &devices_command,
                                          &fit_command,
                                          NULL};

static const char *command_name_at(const void *list, size_t index) {
  const Command *const command = ((const Command *const *)list)[index];
  return command ? command->name : NULL;
}

static const Command *find_command(const char *name) {
  for (size_t i = 0; commands[i]; i++) {
    if (strcmp(commands[i]->name, name) == 0) return commands[i];
  }
  return NULL;
}

static void print_options(const Option *options) {
  for (const Option *option = options; option->name; option++) {
    char left[40];
    (void)snprintf(left, sizeof left, "--%s%s%s", option->name, option->value ? " " : "",
                   option->value ? option->value : "");
    if (option->letter) {
      printf("  -%c, %-22s %s\n", option->letter, left, option->text);
    } else {
      printf("      %-22s %s\n", left, option->text);
    }
  }
}

static void print_help(const Command *command) {
  printf("Usage: tabor %s%s%s [OPTION]...\n\n", command->name, command->operand ? " " : "",
         command->operand ? command->operand : "");
  printf("%s.\n\n", command->summary);
  print_options(command->options);
  print_options(common_options);
  if (command->notes) printf("\n%s", command->notes);
}

/* Without a command: what there is. */
static Outcome run_top(const Arguments *arguments) {
  (void)arguments;
  return refuse("no command; see 'tabor --help'");
}

static const Option no_options[] = {{0}};

static const Command top_command = {
  .name = "COMMAND",
  .summary = "Tabor, drums and cymbals computed from physics",
  .options = no_options,
  .run = run_top,
};

static void print_top_help(void) {
  printf("Usage: tabor COMMAND [OPTION]...\n\n%s.\n\n", top_command.summary);
  for (size_t i = 0; commands[i]; i++)
    printf("  %-9s %s\n", commands[i]->name, commands[i]->summary);
  printf("\n'tabor COMMAND --help' explains a command. Exit status: 0 done, 1 failed, 2 wrong "
         "request.\n");
}

static Outcome print_version(const Arguments *arguments) {
  if (!arguments_has(arguments, "json")) {
    printf("tabor %s\n", tabor_version());
    return OUTCOME_OK;
  }
  return json_print(json_pack("{s:s, s:s}", "name", "tabor", "version", tabor_version()));
}

static Outcome print_help_or_run(const Command *command, const Arguments *arguments) {
  if (arguments_has(arguments, "help")) {
    if (command == &top_command) {
      print_top_help();
    } else {
      print_help(command);
    }
    return OUTCOME_OK;
  }
  if (arguments_has(arguments, "version")) return print_version(arguments);
  return command->run(arguments);
}

static Outcome unknown_command(const char *name) {
  char hint[160];
  suggest_choice(hint, sizeof hint, name, "", command_name_at, commands);
  return refuse("unknown command '%.80s'%s", name, hint);
}

/* 'tabor help' and 'tabor help render' are what 'tabor --help' and 'tabor render --help' are. */
static Outcome run_help(int argc, char *const *argv) {
  const bool top = argc <= 2 || argv[2][0] == '-';
  const Command *const command = top ? NULL : find_command(argv[2]);
  if (argc > 3) return refuse("unexpected argument '%.80s'", argv[3]);
  if (!top && !command) return unknown_command(argv[2]);
  if (command) {
    print_help(command);
  } else {
    print_top_help();
  }
  return OUTCOME_OK;
}

static Outcome run(int argc, char *const *argv) {
  const Command *command = &top_command;
  if (argc > 1 && strcmp(argv[1], "help") == 0) return run_help(argc, argv);
  if (argc > 1 && argv[1][0] != '-') {
    command = find_command(argv[1]);
    if (!command) return unknown_command(argv[1]);
    argc--;
    argv++;
  }
  Arguments arguments;
  Outcome outcome = arguments_read(command, argc, argv, &arguments);
  if (outcome == OUTCOME_OK) outcome = print_help_or_run(command, &arguments);
  arguments_free(&arguments);
  return outcome;
}

/* Data that did not reach the standard output are a failure, too; errno is the last write's. */
static Outcome finish_standard_output(Outcome outcome) {
  const bool complete = fflush(stdout) == 0 && !ferror(stdout);
  if (complete || outcome != OUTCOME_OK) return outcome;
  return standard_output_failure();
}

int main(int argc, char **argv) {
  process_begin(&argc, &argv);
  interrupt_install();
  return (int)finish_standard_output(run(argc, argv));
}
