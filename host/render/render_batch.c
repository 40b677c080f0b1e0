/* SPDX-License-Identifier: MIT */
#include "render/render_batch.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/folder.h"
#include "drums/drum_args.h"
#include "platform/files.h"
#include "platform/paths.h"
#include "render/render_options.h"
#include "render/render_outputs.h"

#define EXTENSION ".wav"

/* ---- the folder ---- */

/* Must be there, or be meant to be created. */
static Outcome check_folder(const char *path) {
  FileStatus status;
  const bool found = file_status(path, &status);
  if (found && status.kind == FILE_KIND_FOLDER) return OUTCOME_OK;
  if (!path_ends_with_separator(path)) {
    return refuse("-o '%s': several sounds need a folder; '%s/' creates one", path, path);
  }
  return errno == ENOENT ? OUTCOME_OK : fail("cannot write to '%s': %s", path, strerror(errno));
}

static Outcome take_folder(const char *path, RenderBatch *batch) {
  const Outcome outcome = check_folder(path);
  if (outcome != OUTCOME_OK) return outcome;
  batch->folder = folder_name(path);
  return batch->folder ? OUTCOME_OK : fail_memory();
}

static Outcome read_folder(const Arguments *arguments, RenderBatch *batch) {
  const char *const path = arguments_value(arguments, "output");
  const bool several = arguments->operand_count > 1 || arguments_has(arguments, "each") ||
                       arguments_has(arguments, "vary");
  if (!several && !(path && path_ends_with_separator(path))) return OUTCOME_OK;
  if (arguments_has(arguments, "replay")) {
    return refuse("--replay: gives one sound, whose file -o names; other drums need no log");
  }
  if (!path) return refuse("several sounds need a folder: -o FOLDER/");
  if (!*path) return refuse("-o needs the name of a folder");
  if (strcmp(path, "-") == 0 || strcmp(path, "/dev/stdout") == 0) {
    return refuse("-o -: standard output takes one sound only");
  }
  return take_folder(path, batch);
}

/* ---- names ---- */

/* "soft" of "takes/soft.csv"; of no file nothing. */
static PresetStem events_stem(const char *events) {
  const char *const base = events ? path_base(events) : "";
  const char *const dot = strrchr(base, '.');
  return (PresetStem){base, (int)(dot && dot > base ? (size_t)(dot - base) : strlen(base))};
}

/* "-007" of the seventh of several hundred. */
static void write_number(const Variations *variations, size_t number, char *text, size_t size) {
  const int digits = snprintf(NULL, 0, "%zu", variations->count);
  *text = '\0';
  if (variations->count > 0) (void)snprintf(text, size, "-%0*zu", digits, number + 1);
}

static Outcome name_job(const RenderBatch *batch, const char *events, size_t number,
                        RenderJob *job) {
  const char *const folder = batch->folder;
  const char *const kit = arguments_value(&job->arguments, "kit");
  const PresetStem preset = preset_stem(kit ? kit : preset_argument(&job->arguments));
  const PresetStem take = events_stem(events);
  char suffix[32];
  write_number(&batch->variations, number, suffix, sizeof suffix);
  const size_t size = strlen(folder) + (size_t)preset.length + (size_t)take.length +
                      strlen(suffix) + sizeof "-" EXTENSION;
  job->name = malloc(size);
  job->output = malloc(size);
  if (!job->name || !job->output) return fail_memory();
  (void)snprintf(job->name, size, "%s%.*s%s%.*s%s", folder, preset.length, preset.text,
                 events ? "-" : "", take.length, take.text, suffix);
  (void)snprintf(job->output, size, "%s" EXTENSION, job->name);
  arguments_replace(&job->arguments, "output", job->output);
  if (events) arguments_replace(&job->arguments, "events", events);
  return OUTCOME_OK;
}

/* What two jobs of one name were made from. */
static Outcome refuse_name(const RenderJob *job, const RenderJob *other) {
  const char *a = preset_argument(&job->arguments), *b = preset_argument(&other->arguments);
  if (a == b) {
    a = arguments_value(&job->arguments, "events");
    b = arguments_value(&other->arguments, "events");
  }
  return refuse("'%s' and '%s' would both become '%s'", a, b, job->output);
}

static Outcome check_names(const RenderBatch *batch) {
  for (size_t i = 0; i < batch->count; i++) {
    for (size_t j = 0; j < i; j++) {
      const RenderJob *const job = &batch->jobs[i], *const other = &batch->jobs[j];
      if (strcmp(job->output, other->output) == 0) return refuse_name(other, job);
    }
  }
  return OUTCOME_OK;
}

/* ---- jobs ---- */

static size_t count_options(const Arguments *arguments, const char *name) {
  size_t count = 0, position = 0;
  while (arguments_next(arguments, name, &position)) count++;
  return count;
}

static Outcome add_job(const Arguments *arguments, const char *preset, const char *events,
                       size_t number, RenderBatch *batch) {
  RenderJob *const job = &batch->jobs[batch->count++];
  render_request_clear(&job->request);
  Outcome outcome = arguments_copy(arguments, preset, &job->arguments);
  if (outcome != OUTCOME_OK || !batch->folder) return outcome;
  if (batch->variations.count > 0)
    outcome =
      variations_apply(&batch->variations, number, render_options, &job->arguments, &job->settings);
  return outcome == OUTCOME_OK ? name_job(batch, events, number, job) : outcome;
}

/* Of one preset and one file of strokes: one, or all variations. */
static Outcome add_variations(const Arguments *arguments, const char *preset, const char *events,
                              RenderBatch *batch) {
  const size_t count = batch->variations.count > 0 ? batch->variations.count : 1;
  Outcome outcome = OUTCOME_OK;
  for (size_t i = 0; i < count && outcome == OUTCOME_OK; i++)
    outcome = add_job(arguments, preset, events, i, batch);
  return outcome;
}

/* Of one preset: one, or with --each one for each of its @p takes files. */
static Outcome add_preset(const Arguments *arguments, const char *preset, size_t takes,
                          RenderBatch *batch) {
  if (takes == 0) return add_variations(arguments, preset, NULL, batch);
  Outcome outcome = OUTCOME_OK;
  const char *events;
  size_t position = 0;
  while (outcome == OUTCOME_OK && (events = arguments_next(arguments, "events", &position))) {
    outcome = add_variations(arguments, preset, events, batch);
  }
  return outcome;
}

static Outcome make_jobs(const Arguments *arguments, RenderBatch *batch) {
  const size_t presets = arguments->operand_count > 0 ? arguments->operand_count : 1;
  const size_t takes = arguments_has(arguments, "each") ? count_options(arguments, "events") : 0;
  const size_t varied = batch->variations.count > 0 ? batch->variations.count : 1;
  const size_t most = presets * (takes > 0 ? takes : 1) * varied;
  batch->jobs = calloc(most, sizeof *batch->jobs);
  if (!batch->jobs) return fail_memory();
  Outcome outcome = OUTCOME_OK;
  for (size_t i = 0; i < presets && outcome == OUTCOME_OK; i++) {
    outcome = add_preset(arguments, arguments->operands[i], takes, batch);
  }
  return outcome;
}

/* ---- checks ---- */

/* What there is only one of. */
static Outcome check_shared(const Arguments *arguments, const RenderBatch *batch) {
  if (batch->count == 1) return OUTCOME_OK;
  const char *events;
  size_t position = 0;
  while ((events = arguments_next(arguments, "events", &position))) {
    if (strcmp(events, "-") == 0) {
      return refuse("--events -: several sounds cannot share the standard input");
    }
  }
  const char *const song = arguments_value(arguments, "midi-file");
  if (song && strcmp(song, "-") == 0) {
    return refuse("--midi-file -: several sounds cannot share the standard input");
  }
  if (!arguments_has(arguments, "trace")) return OUTCOME_OK;
  return refuse("--trace: takes one sound only, but %zu were asked for", batch->count);
}

Outcome render_job_read(RenderJob *job) {
  RenderRequest *const request = &job->request;
  message_subject(job->name);
  job->outcome = render_request_read(&job->arguments, request);
  message_subject(NULL);
  if (job->outcome != OUTCOME_OK) return job->outcome;
  job->rate = request->model.sample_rate;
  job->last_stroke = render_request_last_frame(request) / job->rate;
  job->length = request->frames / job->rate;
  return OUTCOME_OK;
}

void render_job_played(void *job, uint32_t frames) {
  RenderJob *const played = job;
  atomic_store_explicit(&played->played, frames, memory_order_relaxed);
}

static Outcome read_requests(RenderBatch *batch) {
  Outcome outcome = OUTCOME_OK;
  for (size_t i = 0; i < batch->count && outcome != OUTCOME_REFUSED; i++) {
    outcome = render_job_read(&batch->jobs[i]);
  }
  return outcome == OUTCOME_REFUSED ? outcome : OUTCOME_OK;
}

/* Links may lead to one file, and so may the names of microphones. */
static Outcome check_pair(const RenderRequest *a, const RenderRequest *b) {
  for (uint32_t i = 0; i < a->output_count; i++) {
    for (uint32_t j = 0; j < b->output_count; j++) {
      const OutputFile *const first = &a->outputs[i], *const second = &b->outputs[j];
      if (strcmp(first->name, second->name) == 0) {
        return refuse("two sounds would both become '%s'", first->name);
      }
      if (output_same(first, second)) {
        return refuse("'%s' and '%s' are the same file", first->name, second->name);
      }
    }
  }
  return OUTCOME_OK;
}

/* No sound may replace what another one is made from either. */
static Outcome protect_others(const RenderBatch *batch, const RenderJob *job) {
  Outcome outcome = OUTCOME_OK;
  for (size_t i = 0; i < batch->count && outcome == OUTCOME_OK; i++) {
    const RenderJob *const other = &batch->jobs[i];
    if (other != job) outcome = render_outputs_protect(&other->arguments, &job->request);
  }
  return outcome;
}

static Outcome check_outputs(const RenderBatch *batch) {
  Outcome outcome = OUTCOME_OK;
  for (size_t i = 0; i < batch->count && outcome == OUTCOME_OK; i++) {
    const RenderJob *const job = &batch->jobs[i];
    if (job->outcome != OUTCOME_OK) continue;
    for (size_t j = 0; j < i && outcome == OUTCOME_OK; j++) {
      const RenderJob *const other = &batch->jobs[j];
      if (other->outcome == OUTCOME_OK) outcome = check_pair(&other->request, &job->request);
    }
    if (outcome == OUTCOME_OK) outcome = protect_others(batch, job);
  }
  return outcome;
}

Outcome render_batch_read(const Arguments *arguments, RenderBatch *batch) {
  *batch = (RenderBatch){0};
  Outcome outcome = render_threads_read(arguments, &batch->threads);
  if (outcome == OUTCOME_OK) outcome = variations_read(arguments, &batch->variations);
  if (outcome == OUTCOME_OK) outcome = read_folder(arguments, batch);
  if (outcome == OUTCOME_OK) outcome = make_jobs(arguments, batch);
  if (outcome == OUTCOME_OK && batch->folder) outcome = check_names(batch);
  if (outcome == OUTCOME_OK) outcome = check_shared(arguments, batch);
  if (outcome == OUTCOME_OK) outcome = read_requests(batch);
  return outcome == OUTCOME_OK ? check_outputs(batch) : outcome;
}

void render_batch_free(RenderBatch *batch) {
  for (size_t i = 0; i < batch->count; i++) {
    RenderJob *const job = &batch->jobs[i];
    render_request_free(&job->request);
    json_decref(job->report);
    arguments_free(&job->arguments);
    free(job->name);
    free(job->output);
    free(job->settings);
  }
  variations_free(&batch->variations);
  free(batch->jobs);
  free(batch->folder);
  *batch = (RenderBatch){0};
}
