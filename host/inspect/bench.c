/* SPDX-License-Identifier: MIT */
/**
 * @file bench.c
 * `tabor bench`: measures the processor time of a drum during continuous play and while it sleeps.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/command.h"
#include "base/json_output.h"
#include "base/suggest.h"
#include "drums/drum_args.h"
#include "inspect/workload.h"
#include "platform/clock.h"

#define DURATION 4.0 /* [s] */
#define STROKES 32

#define LONGEST_BLOCK 8192

typedef struct Bench {
  const char *preset;
  TaborDrumDef def;
  TaborModelOptions model_options;
  uint32_t block, repeats;
  TaborModelInfo info;
  TaborDrum *drum;
  TaborEvent strokes[STROKES];
  float *sound;               /* of a block, of the first microphone */
  double *times, *best;       /* processor time of each block [s]; of the fastest repeat, sorted */
  uint32_t blocks, frames;    /* of a repeat */
  double best_sum;            /* [s] */
  double best_idle;           /* the least that as many blocks took a sleeping drum [s] */
  TaborStatistics statistics; /* the same in every repeat */
} Bench;

static void prepare_strokes(Bench *bench) {
  for (uint32_t i = 0; i < STROKES; i++) {
    bench->strokes[i] = workload_stroke(&bench->def, bench->model_options.sample_rate, i);
  }
}

static Outcome prepare(Bench *bench) {
  bench->frames = (uint32_t)lround(DURATION * bench->model_options.sample_rate);
  bench->blocks = (bench->frames + bench->block - 1) / bench->block;
  bench->sound = calloc(bench->block, sizeof *bench->sound);
  bench->times = calloc(bench->blocks, sizeof *bench->times);
  bench->best = calloc(bench->blocks, sizeof *bench->best);
  bench->best_sum = bench->best_idle = INFINITY;
  if (!bench->sound || !bench->times || !bench->best) return fail_memory();
  prepare_strokes(bench);
  const Outcome outcome = drum_create(&bench->def, &bench->model_options, NULL, &bench->drum);
  if (outcome == OUTCOME_OK) tabor_model_info(tabor_drum_model(bench->drum), &bench->info);
  return outcome;
}

/* Plays the block from @p start on; returns its processor time. *next is the next stroke. */
static double time_block(Bench *bench, uint32_t start, uint32_t *next) {
  TaborEvent events[STROKES];
  float *outputs[TABOR_MAX_MICS] = {bench->sound};
  const uint32_t left = bench->frames - start;
  const uint32_t frames = left < bench->block ? left : bench->block;
  uint32_t count = 0;
  for (; *next < STROKES && bench->strokes[*next].frame < start + frames; (*next)++) {
    events[count] = bench->strokes[*next];
    events[count++].frame -= start;
  }
  const double before = processor_seconds();
  tabor_drum_process(bench->drum, events, count, outputs, frames);
  return processor_seconds() - before;
}

static void play(Bench *bench) {
  double sum = 0;
  uint32_t next = 0;
  tabor_drum_reset(bench->drum);
  for (uint32_t i = 0; i < bench->blocks; i++) {
    bench->times[i] = time_block(bench, i * bench->block, &next);
    sum += bench->times[i];
  }
  tabor_drum_statistics(bench->drum, &bench->statistics);
  if (!(sum < bench->best_sum)) return;
  bench->best_sum = sum;
  double *const spare = bench->best;
  bench->best = bench->times;
  bench->times = spare;
}

/* Leaves the drum at rest for as long; a block would be too short for the clock. */
static void rest(Bench *bench) {
  float *outputs[TABOR_MAX_MICS] = {bench->sound};
  tabor_drum_reset(bench->drum);
  const double before = processor_seconds();
  for (uint32_t i = 0; i < bench->blocks; i++) {
    tabor_drum_process(bench->drum, NULL, 0, outputs, bench->block);
  }
  bench->best_idle = fmin(bench->best_idle, processor_seconds() - before);
}

static int compare_times(const void *left, const void *right) {
  const double a = *(const double *)left, b = *(const double *)right;
  return a < b ? -1 : a > b;
}

/* ---- the figures ---- */

typedef struct Figures {
  double real_time_factor, idle_factor;
  double median, p99, max; /* of blocks [us] */
  double contacts_mean;
} Figures;

/* The smallest time that a share of the blocks, sorted, does not exceed. */
static double quantile(const Bench *bench, double share) {
  return bench->best[(uint32_t)ceil(share * bench->blocks) - 1];
}

static Figures summarise(const Bench *bench) {
  const TaborStatistics *const statistics = &bench->statistics;
  const double solves = (double)statistics->solves, rate = bench->model_options.sample_rate;
  qsort(bench->best, bench->blocks, sizeof *bench->best, compare_times);
  return (Figures){
    .real_time_factor = bench->best_sum * rate / bench->frames,
    .idle_factor = bench->best_idle * rate / ((double)bench->blocks * bench->block),
    .median = 1e6 * quantile(bench, 0.5),
    .p99 = 1e6 * quantile(bench, 0.99),
    .max = 1e6 * quantile(bench, 1),
    .contacts_mean = solves > 0 ? (double)statistics->contact_sum / solves : 0,
  };
}

static Outcome print_json(const Bench *bench, const Figures *figures) {
  json_t *const block_time =
    json_pack("{s:o, s:o, s:o}", "median", json_number(figures->median), "p99",
              json_number(figures->p99), "max", json_number(figures->max));
  json_t *const contacts = json_pack(
    "{s:I, s:o, s:I}", "points", (json_int_t)bench->info.contact_points, "mean",
    json_number(figures->contacts_mean), "max", (json_int_t)bench->statistics.contact_max);
  return json_print(json_pack(
    "{s:o, s:I, s:I, s:s, s:o, s:o, s:o, s:I, s:o}", "preset", json_text(bench->preset), "rate",
    (json_int_t)bench->model_options.sample_rate, "block", (json_int_t)bench->block, "quality",
    quality_name(bench->info.quality), "real_time_factor", json_number(figures->real_time_factor),
    "idle_factor", json_number(figures->idle_factor), "block_time_us", block_time, "modes",
    (json_int_t)bench->info.mode_count, "contacts", contacts));
}

static void print_row(const char *name, const char *value) { printf("%-18s %s\n", name, value); }

static Outcome print_table(const Bench *bench, const Figures *figures) {
  char text[128];
  print_row("preset", bench->preset);
  (void)snprintf(text, sizeof text, "%.0f Hz", bench->model_options.sample_rate);
  print_row("rate", text);
  (void)snprintf(text, sizeof text, "%u frames (%.0f us)", (unsigned)bench->block,
                 1e6 * bench->block / bench->model_options.sample_rate);
  print_row("block", text);
  print_row("quality", quality_name(bench->info.quality));
  (void)snprintf(text, sizeof text, "%.4f", figures->real_time_factor);
  print_row("real-time factor", text);
  (void)snprintf(text, sizeof text, "%.6f", figures->idle_factor);
  print_row("idle factor", text);
  (void)snprintf(text, sizeof text, "median %.1f us, 99 %% below %.1f us, at most %.1f us",
                 figures->median, figures->p99, figures->max);
  print_row("block time", text);
  (void)snprintf(text, sizeof text, "%u", (unsigned)bench->info.mode_count);
  print_row("modes", text);
  (void)snprintf(text, sizeof text, "%u points, of which touch: mean %.2f, most %u",
                 (unsigned)bench->info.contact_points, figures->contacts_mean,
                 (unsigned)bench->statistics.contact_max);
  print_row("contacts", text);
  return OUTCOME_OK;
}

/* ---- the command ---- */

/* Names of TaborInstructions, in its order. */
static const char *const instruction_names[] = {"auto", "baseline", "avx2", "avx512", NULL};

static const char *instruction_name_at(const void *names, size_t index) {
  return ((const char *const *)names)[index];
}

/* The library would take narrower ones in place of those that the processor lacks. */
static bool processor_has(uint32_t instructions) {
#if defined(__x86_64__) && defined(__GNUC__)
  if (instructions == TABOR_INSTRUCTIONS_AVX2) return __builtin_cpu_supports("avx2");
  if (instructions == TABOR_INSTRUCTIONS_AVX512) {
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
  }
#endif
  return instructions <= TABOR_INSTRUCTIONS_BASELINE;
}

static Outcome read_instructions(const Arguments *arguments, uint32_t *instructions) {
  const char *const text = arguments_value(arguments, "instructions");
  if (!text) return OUTCOME_OK;
  for (uint32_t i = 0; instruction_names[i]; i++) {
    if (strcmp(instruction_names[i], text) != 0) continue;
    *instructions = i;
    return processor_has(i) ? OUTCOME_OK
                            : refuse("--instructions '%s': this processor has not got them", text);
  }
  char hint[96];
  suggest_hint(hint, sizeof hint, text, "", instruction_name_at, instruction_names);
  return refuse("--instructions '%.80s': unknown; allowed: auto, baseline, avx2, avx512%s", text,
                hint);
}

static Outcome read_request(const Arguments *arguments, Bench *bench) {
  static const NumberField block_field = {"--block", 1, LONGEST_BLOCK, true};
  static const NumberField repeat_field = {"--repeat", 1, 1000, true};
  double block = 64, repeats = 5;
  Outcome outcome = arguments_number(arguments, &block_field, &block);
  if (outcome == OUTCOME_OK) outcome = arguments_number(arguments, &repeat_field, &repeats);
  bench->preset = preset_argument(arguments);
  bench->block = (uint32_t)block;
  bench->repeats = (uint32_t)repeats;
  if (outcome == OUTCOME_OK) outcome = drum_load(arguments, &bench->def);
  if (outcome == OUTCOME_OK) {
    outcome = model_options_read(arguments, &bench->def, &bench->model_options);
  }
  if (outcome != OUTCOME_OK) return outcome;
  return read_instructions(arguments, &bench->model_options.instructions);
}

static Outcome measure(const Arguments *arguments, Bench *bench) {
  Outcome outcome = read_request(arguments, bench);
  if (outcome == OUTCOME_OK) outcome = prepare(bench);
  if (outcome != OUTCOME_OK) return outcome;
  for (uint32_t i = 0; i < bench->repeats; i++) {
    play(bench);
    rest(bench);
  }
  const Figures figures = summarise(bench);
  return arguments_has(arguments, "json") ? print_json(bench, &figures)
                                          : print_table(bench, &figures);
}

static Outcome run(const Arguments *arguments) {
  Bench *const bench = calloc(1, sizeof *bench);
  if (!bench) return fail_memory();
  const Outcome outcome = measure(arguments, bench);
  tabor_drum_destroy(bench->drum);
  free(bench->sound);
  free(bench->times);
  free(bench->best);
  free(bench);
  return outcome;
}

static const Option options[] = {
  OPTION_RATE,
  {"block", 0, "FRAMES", "frames computed at once, 1 to 8192 (default 64)"},
  OPTION_QUALITY,
  {"instructions", 0, "SET", "auto, baseline, avx2 or avx512 (default auto: the widest there are)"},
  {"repeat", 0, "TIMES", "how often to measure; the fastest counts, 1 to 1000 (default 5)"},
  OPTION_SET,
  {0},
};

static const char notes[] =
  "The drum is played for 4 s: a stroke every 125 ms, at 1 and 4 m/s in turn, at 0, 0.2, 0.4, 0.6\n"
  "and 0.8 of the head's radius in turn, with the preset's striker and angle, heard by its first\n"
  "microphone. The real-time factor is processor time over the duration of the sound: below 1 the\n"
  "drum can be played live. Times of blocks are processor times, of the fastest repeat. The idle\n"
  "factor is the real-time factor of the drum at rest, asleep, as it is once it has died away.\n"
  "\n" PRESET_NOTES;

const Command bench_command = {
  .name = "bench",
  .operand = "[PRESET]",
  .summary = "Measure how much processor time a drum takes",
  .notes = notes,
  .options = options,
  .run = run,
};
