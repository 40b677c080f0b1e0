/* SPDX-License-Identifier: MIT */
#include "library/library_batch.h"

#include <stdlib.h>
#include <string.h>

#include "base/folder.h"
#include "library/library_kit.h"

/* The preset's own stroke gives way to that of the sound. */
static Outcome take_stroke(const LibrarySound *sound, RenderRequest *request) {
  Stroke stroke = stroke_default(&request->def, "[strike]");
  stroke.event = sound->event;
  return strokes_replace(&request->strokes, &stroke);
}

static Outcome read_job(const LibrarySound *sound, RenderJob *job) {
  const Outcome outcome = render_job_read(job);
  if (outcome != OUTCOME_OK) return outcome;
  job->request.json = false;
  job->request.quiet = !job->request.verbose;
  return take_stroke(sound, &job->request);
}

static Outcome add_job(const Arguments *arguments, const LibraryRequest *request,
                       const LibrarySound *sound, char *path, RenderBatch *batch) {
  RenderJob *const job = &batch->jobs[batch->count++];
  render_request_clear(&job->request);
  job->output = path;
  job->name = strdup(path);
  Outcome outcome = arguments_copy(arguments, arguments->operand, &job->arguments);
  if (outcome == OUTCOME_OK && !job->name) outcome = fail_memory();
  if (outcome != OUTCOME_OK) return outcome;
  arguments_replace(&job->arguments, "output", path);
  if (!request->kit) return read_job(sound, job);
  library_kit_prepare(request, sound, job);
  return OUTCOME_OK;
}

static Outcome add_missing(const Arguments *arguments, LibrarySums *sums, size_t index,
                           RenderBatch *batch) {
  const LibraryRequest *const request = sums->request;
  const LibrarySound *const sound = &request->plan.sounds[index];
  char *const path = folder_path(request->folder, sound->file);
  if (!path) return fail_memory();
  if (library_sums_keep(sums, index, path)) {
    free(path);
    return OUTCOME_OK;
  }
  return add_job(arguments, request, sound, path, batch);
}

Outcome library_batch_make(const Arguments *arguments, LibrarySums *sums, RenderBatch *batch) {
  const LibraryPlan *const plan = &sums->request->plan;
  *batch = (RenderBatch){.threads = sums->request->threads,
                         .jobs = calloc(plan->count, sizeof *batch->jobs),
                         .render = sums->request->kit ? library_kit_render : NULL,
                         .rendered = library_sums_add,
                         .context = sums};
  Outcome outcome = batch->jobs ? OUTCOME_OK : fail_memory();
  for (size_t i = 0; i < plan->count && outcome == OUTCOME_OK; i++) {
    outcome = add_missing(arguments, sums, i, batch);
  }
  return outcome;
}
