/* SPDX-License-Identifier: MIT */
/**
 * @file fit_command.c
 * `tabor fit`: starts the module of the Python package that finds the drum of a recording.
 */
#include <stdio.h>
#include <stdlib.h>

#include "base/command.h"
#include "platform/process.h"

typedef char Word[32];

/* Status 0 if Python has all that fitting takes, which the package knows. */
static const char probe[] = "try:\n import tabor.fit\nexcept ImportError:\n raise SystemExit(1)";

/* Name of a Python that can fit, or NULL. */
static const char *find_python(void) {
  static const char *const names[] = {"python3", "python"};
  for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
    if (process_run((const char *[]){names[i], "-c", probe, NULL}) == 0) return names[i];
  }
  return NULL;
}

/* What the module is asked: the same options, spelled out in @p spelled, and the request. */
static void put_words(const Arguments *arguments, Word *spelled, const char **words) {
  for (size_t i = 0; i < arguments->use_count; i++) {
    const OptionUse *const use = &arguments->uses[i];
    (void)snprintf(spelled[i], sizeof *spelled, "--%s", use->option->name);
    *words++ = spelled[i];
    if (use->value) *words++ = use->value;
  }
  *words++ = "--";
  *words = arguments->operand;
}

static Outcome start(const Arguments *arguments, const char *python) {
  enum { FIRST = 3, OTHERS = 3 };
  Word *const spelled = calloc(arguments->use_count + 1, sizeof *spelled);
  const char **const words = calloc(FIRST + 2 * arguments->use_count + OTHERS, sizeof *words);
  Outcome outcome = OUTCOME_OK;
  if (spelled && words) {
    words[0] = python, words[1] = "-m", words[2] = "tabor.fit";
    put_words(arguments, spelled, words + FIRST);
    const int status = process_run(words);
    outcome =
      status < 0 ? fail("cannot start '%s'", python) : (Outcome)status; /* it has said why */
  } else {
    outcome = fail_memory();
  }
  free(words);
  free(spelled);
  return outcome;
}

static Outcome run(const Arguments *arguments) {
  if (!arguments->operand) return refuse("no request; allowed: a TOML file, as docs/fit.md has it");
  const char *const python = find_python();
  if (python) return start(arguments, python);
  return fail("fitting takes Python 3 with the package tabor: pip install 'tabor[fit]'");
}

/* Those of the module, python/src/tabor/fit/__main__.py. */
static const Option options[] = {
  {"output", 'o', "FOLDER", "where all is written (default: fit)"},
  {"jobs", 'j', "NUMBER", "threads (default: one for each processor)"},
  {"rounds", 0, "NUMBERS", "simulations of each round (default: 45,40,40)"},
  {"generations", 0, "NUMBER", "of the search after them (default: 100; 0: no search)"},
  {"seed", 0, "NUMBER", "of all that is drawn (default: 1)"},
  {0},
};

static const char notes[] =
  "REQUEST is a TOML file that names the recordings and says what is known of the drum. Written\n"
  "are a preset, a table of parameters with 90 % intervals, and a report in HTML. A fit that was\n"
  "ended goes on where it was when it is started again with the same folder.\n"
  "Takes Python 3 with the package tabor: pip install 'tabor[fit]'.\n";

const Command fit_command = {
  .name = "fit",
  .operand = "REQUEST",
  .summary = "Find the drum of a recording: a preset, and parameters with their intervals",
  .notes = notes,
  .options = options,
  .run = run,
};
