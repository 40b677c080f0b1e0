/* SPDX-License-Identifier: MIT */
/**
 * @file modes.c
 * `tabor modes`: lists frequencies and decays of the heads coupled to the air, sorted by frequency.
 */
#include <math.h>
#include <stdio.h>

#include "base/command.h"
#include "base/json_output.h"
#include "drums/drum_args.h"

/* Time in which the amplitude falls by 60 dB [s]; infinite without losses. */
static double t60(double decay_rate) { return log(1000.0) / decay_rate; }

static const char *part_word(TaborModePart part) {
  static const char *const words[] = {"batter", "resonant", "both", "cavity", "rim"};
  return words[part];
}

static const char *phase_word(int phase) { return phase > 0 ? "in" : "out"; }

static Outcome print_table(const TaborModel *model) {
  printf("%3s %3s %14s %11s %9s %7s %-9s %s\n", "m", "n", "frequency/Hz", "decay/(1/s)", "t60/s",
         "copies", "head", "phase");
  TaborModeInfo mode;
  for (uint32_t row = 0; tabor_model_mode(model, row, &mode); row++) {
    printf("%3u %3u %14.4f %11.4f %9.4f %7u %-9s %s\n", (unsigned)mode.m, (unsigned)mode.n,
           mode.frequency, mode.decay_rate, t60(mode.decay_rate), (unsigned)mode.multiplicity,
           part_word(mode.part), mode.phase ? phase_word(mode.phase) : "-");
  }
  return OUTCOME_OK;
}

/* A single head's modes all belong to the batter; a phase is what two heads have to each other. */
static json_t *mode_json(const TaborModeInfo *mode) {
  return json_pack("{s:I, s:I, s:o, s:o, s:o, s:I, s:s, s:s?}", "m", (json_int_t)mode->m, "n",
                   (json_int_t)mode->n, "frequency", json_number(mode->frequency), "decay_rate",
                   json_number(mode->decay_rate), "t60", json_number(t60(mode->decay_rate)),
                   "multiplicity", (json_int_t)mode->multiplicity, "head", part_word(mode->part),
                   "phase", mode->phase ? phase_word(mode->phase) : NULL);
}

static Outcome print_json(const TaborModel *model) {
  json_t *const list = json_array();
  TaborModeInfo mode;
  uint32_t row = 0;
  for (; tabor_model_mode(model, row, &mode); row++) json_array_append_new(list, mode_json(&mode));
  if (json_array_size(list) != row) {
    json_decref(list);
    return fail_memory();
  }
  return json_print(json_pack("{s:o}", "modes", list));
}

static Outcome run(const Arguments *arguments) {
  TaborDrumDef def;
  TaborModelOptions model_options;
  Outcome outcome = drum_load(arguments, &def);
  if (outcome == OUTCOME_OK) outcome = model_options_read(arguments, &def, &model_options);
  if (outcome != OUTCOME_OK) return outcome;
  TaborModel *model = NULL;
  TaborError error;
  if (tabor_model_create(&def, &model_options, &model, &error) != TABOR_OK) {
    return report_engine_error(&error);
  }
  outcome = arguments_has(arguments, "json") ? print_json(model) : print_table(model);
  tabor_model_release(model);
  return outcome;
}

static const Option options[] = {OPTION_SET, OPTION_RATE, OPTION_QUALITY, {0}};

const Command modes_command = {
  .name = "modes",
  .operand = "[PRESET]",
  .summary = "List the modes of a drum: frequency, decay, multiplicity",
  .notes = PRESET_NOTES,
  .options = options,
  .run = run,
};
