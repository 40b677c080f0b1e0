/* SPDX-License-Identifier: MIT */
/**
 * @file modes.c
 * `tabor modes`: lists frequencies and decays of the heads coupled to the air, sorted by frequency,
 * and the pitches of the heads.
 */
#include <math.h>
#include <stdio.h>

#include "base/command.h"
#include "base/json_output.h"
#include "drums/drum_args.h"
#include "drums/model_build.h"
#include "drums/pitch_text.h"

/* Time in which the amplitude falls by 60 dB [s]; infinite without losses. */
static double t60(double decay_rate) { return log(1000.0) / decay_rate; }

static const char *part_word(TaborModePart part) {
  static const char *const words[] = {"batter", "resonant", "both",  "cavity",
                                      "rim",    "plate",    "bottom"};
  return words[part];
}

static const char *phase_word(int phase) { return phase > 0 ? "in" : "out"; }

/* The pitches of a drum's heads [Hz]. */
typedef struct Pitches {
  uint32_t heads; /* 0 of a plate, 1 or 2: batter, resonant */
  double pitch[2];
} Pitches;

static Outcome find_pitches(const TaborDrumDef *def, Pitches *pitches) {
  TaborError error;
  for (pitches->heads = 0; pitches->heads < 2; pitches->heads++) {
    double *const pitch = &pitches->pitch[pitches->heads];
    const TaborStatus status = tabor_drum_def_pitch(def, pitches->heads, pitch, &error);
    if (status == TABOR_ERROR_NAME) break; /* there is no such head */
    if (status != TABOR_OK) return report_engine_error(&error);
  }
  return OUTCOME_OK;
}

/* The nearest note with the cents that are missing, as "C#4-14". */
static void write_note(double frequency, char *text, size_t size) {
  const double semitones = 57 + 12 * log2(frequency / 440); /* above C0 */
  const int nearest = (int)lround(semitones);
  const long cents = lround(100 * (semitones - nearest));
  (void)snprintf(text, size, "%s%d%+ld", pitch_names[(nearest + 120) % 12],
                 (nearest + 120) / 12 - 10, cents);
}

static void print_pitches(const Pitches *pitches) {
  if (pitches->heads == 0) return;
  printf("\nat a lug%s:", pitches->heads == 2 ? ", the other head held" : "");
  for (uint32_t head = 0; head < pitches->heads; head++) {
    char note[32];
    write_note(pitches->pitch[head], note, sizeof note);
    printf("%s %s %.2f Hz (%s)", head > 0 ? "," : "", part_word((TaborModePart)head),
           pitches->pitch[head], note);
  }
  printf("\n");
}

static Outcome print_table(const TaborModel *model, const Pitches *pitches) {
  printf("%3s %3s %14s %11s %9s %7s %-9s %s\n", "m", "n", "frequency/Hz", "decay/(1/s)", "t60/s",
         "copies", "head", "phase");
  TaborModeInfo mode;
  for (uint32_t row = 0; tabor_model_mode(model, row, &mode); row++) {
    printf("%3u %3u %14.4f %11.4f %9.4f %7u %-9s %s\n", (unsigned)mode.m, (unsigned)mode.n,
           mode.frequency, mode.decay_rate, t60(mode.decay_rate), (unsigned)mode.multiplicity,
           part_word(mode.part), mode.phase ? phase_word(mode.phase) : "-");
  }
  print_pitches(pitches);
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

static json_t *pitches_json(const Pitches *pitches) {
  json_t *object = json_object();
  for (uint32_t head = 0; head < pitches->heads; head++) {
    object =
      json_with_field(object, part_word((TaborModePart)head), json_number(pitches->pitch[head]));
  }
  return object;
}

static Outcome print_json(const TaborModel *model, const Pitches *pitches) {
  json_t *list = json_array();
  TaborModeInfo mode;
  for (uint32_t row = 0; tabor_model_mode(model, row, &mode); row++) {
    list = json_with_item(list, mode_json(&mode));
  }
  return json_print(json_pack("{s:o, s:o}", "modes", list, "pitches", pitches_json(pitches)));
}

static Outcome run(const Arguments *arguments) {
  TaborDrumDef def;
  TaborModelOptions model_options;
  Outcome outcome = drum_load(arguments, &def);
  if (outcome == OUTCOME_OK) outcome = model_options_read(arguments, &def, &model_options);
  Pitches pitches;
  if (outcome == OUTCOME_OK) outcome = find_pitches(&def, &pitches);
  if (outcome != OUTCOME_OK) return outcome;
  TaborModel *model = NULL;
  outcome = model_build(&def, &model_options, &model);
  if (outcome != OUTCOME_OK) return outcome;
  outcome =
    arguments_has(arguments, "json") ? print_json(model, &pitches) : print_table(model, &pitches);
  tabor_model_release(model);
  return outcome;
}

static const Option options[] = {OPTION_SET, OPTION_RATE, OPTION_QUALITY, {0}};

const Command modes_command = {
  .name = "modes",
  .operand = "[PRESET]",
  .summary = "List the modes of a drum: frequency, decay, multiplicity; and its pitches at a lug",
  .notes = PRESET_NOTES,
  .options = options,
  .run = run,
};
