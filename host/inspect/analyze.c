/* SPDX-License-Identifier: MIT */
/**
 * @file analyze.c
 * `tabor analyze`: lists the strongest partials of a recording.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/command.h"
#include "base/json_output.h"
#include "files/audio_clip.h"
#include "inspect/partials.h"

#define LONGEST_TIME 86400

typedef struct Analysis {
  const char *file;
  AudioClipPart part;
  PartialSearch search;
  AudioClip recording;
  Partials partials;
} Analysis;

/* Time in which the amplitude falls by 60 dB [s]; NaN if it does not fall. */
static double t60(const Partial *partial) {
  return partial->decay_rate > 0 ? log(1000.0) / partial->decay_rate : NAN;
}

/* ---- the request ---- */

static Outcome read_request(const Arguments *arguments, Analysis *analysis) {
  double channel = 1, from = 0, to = INFINITY, count = 10, level = -120;
  const struct {
    NumberField field;
    double *number;
  } options[] = {
    {{"--channel", 1, 1024, true}, &channel},    {{"--from", 0, LONGEST_TIME, false}, &from},
    {{"--to", 0, LONGEST_TIME, false}, &to},     {{"--count", 1, MOST_PARTIALS, true}, &count},
    {{"--min-level", -200, 100, false}, &level},
  };
  Outcome outcome = OUTCOME_OK;
  for (size_t i = 0; i < sizeof options / sizeof options[0] && outcome == OUTCOME_OK; i++) {
    outcome = arguments_number(arguments, &options[i].field, options[i].number);
  }
  if (outcome != OUTCOME_OK) return outcome;
  if (!arguments->operand || !*arguments->operand) return refuse("analyze needs a sound file");
  if (from >= to) return refuse("--from '%.10g': not before --to %.10g", from, to);
  analysis->file = arguments->operand;
  analysis->part = (AudioClipPart){(uint32_t)channel, from, to};
  analysis->search = (PartialSearch){.most = (size_t)count, .least_level = level};
  return OUTCOME_OK;
}

/* ---- the result ---- */

static json_t *partial_json(const Partial *partial) {
  return json_pack("{s:o, s:o, s:o, s:o}", "frequency", json_number(partial->frequency), "level",
                   json_number(partial->level), "decay_rate", json_number(partial->decay_rate),
                   "t60", json_number(t60(partial)));
}

static Outcome print_json(const Analysis *analysis) {
  const AudioClip *const recording = &analysis->recording;
  json_t *list = json_array();
  for (size_t i = 0; i < analysis->partials.count; i++) {
    list = json_with_item(list, partial_json(&analysis->partials.list[i]));
  }
  return json_print(json_pack("{s:o, s:I, s:I, s:I, s:o}", "file", json_text(analysis->file),
                              "rate", (json_int_t)recording->rate, "channels",
                              (json_int_t)recording->channels, "frames",
                              (json_int_t)recording->frames, "partials", list));
}

static Outcome print_table(const Analysis *analysis) {
  printf("%14s %11s %12s %9s\n", "frequency/Hz", "level/dBFS", "decay/(1/s)", "t60/s");
  for (size_t i = 0; i < analysis->partials.count; i++) {
    const Partial *const partial = &analysis->partials.list[i];
    char time[32] = "-";
    if (partial->decay_rate > 0) (void)snprintf(time, sizeof time, "%.4f", t60(partial));
    printf("%14.4f %11.2f %12.4f %9s\n", partial->frequency, partial->level, partial->decay_rate,
           time);
  }
  return OUTCOME_OK;
}

/* ---- the command ---- */

static Outcome find_partials(Analysis *analysis) {
  const AudioClip *const recording = &analysis->recording;
  const size_t onset = find_onset(recording->samples, recording->count);
  if (onset == recording->count) {
    warn(INPUT " is silent", INPUT_OF(analysis->file));
    return OUTCOME_OK;
  }
  const size_t left = recording->count - onset, least = partials_least_samples(recording->rate);
  analysis->search.rate = recording->rate;
  if (left < least) {
    return fail(INPUT " is too short: %.3f s from its onset on; needed: %.3f s",
                INPUT_OF(analysis->file), (double)left / recording->rate,
                (double)least / recording->rate);
  }
  const Outcome outcome =
    partials_find(&analysis->search, recording->samples + onset, left, &analysis->partials);
  if (outcome == OUTCOME_OK && analysis->partials.count == 0) {
    warn(INPUT " has no partial that stands out", INPUT_OF(analysis->file));
  }
  return outcome;
}

static Outcome analyze(const Arguments *arguments, Analysis *analysis) {
  Outcome outcome = read_request(arguments, analysis);
  if (outcome == OUTCOME_OK) {
    outcome = audio_clip_read(analysis->file, &analysis->part, &analysis->recording);
  }
  if (outcome == OUTCOME_OK) outcome = find_partials(analysis);
  if (outcome != OUTCOME_OK) return outcome;
  return arguments_has(arguments, "json") ? print_json(analysis) : print_table(analysis);
}

static Outcome run(const Arguments *arguments) {
  Analysis *const analysis = calloc(1, sizeof *analysis);
  if (!analysis) return fail_memory();
  const Outcome outcome = analyze(arguments, analysis);
  audio_clip_free(&analysis->recording);
  free(analysis);
  return outcome;
}

static const Option options[] = {
  {"count", 0, "NUMBER", "partials to list, 1 to 1000 (default 10)"},
  {"channel", 0, "NUMBER", "channel to analyze, from 1 (default 1)"},
  {"from", 0, "SECONDS", "where to begin in the file (default 0)"},
  {"to", 0, "SECONDS", "where to end (default: the file's end)"},
  {"min-level", 0, "DBFS", "leave out weaker partials, -200 to 100 (default -120)"},
  {0},
};

static const char notes[] =
  "FILE is a sound file, WAV, FLAC, AU and others, or '-' for standard input; at most 120 s of it\n"
  "are taken. It should hold one stroke: use --from and --to. Partials come strongest first.\n"
  "  level   of the amplitude at the onset; 0 dBFS is that of a full-scale sine\n"
  "  decay   of the amplitude, as exp(-decay t), from the slope of its level above the noise\n"
  "  t60     time in which the level falls by 60 dB\n"
  "Where partials are closer than some 3 Hz, or beat, the decay is that of both together.\n";

const Command analyze_command = {
  .name = "analyze",
  .operand = "FILE",
  .summary = "List the strongest partials of a recording: frequency, level, decay",
  .notes = notes,
  .options = options,
  .run = run,
};
