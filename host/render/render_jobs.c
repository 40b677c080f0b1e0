/* SPDX-License-Identifier: MIT */
#include "render/render_jobs.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/folder.h"
#include "base/json_output.h"
#include "base/text_file.h"
#include "drums/drum_args.h"
#include "platform/clock.h"
#include "platform/paths.h"
#include "render/render_file.h"
#include "render/render_options.h"
#include "render/render_progress.h"

#define PROGRESS_INTERVAL 0.2 /* [s] */
#define TABLE "variations.csv"
#define TABLE_VALUE 256 /* bytes of a value, a key or a name at most */

/* Jobs while they are being done. */
typedef struct Jobs {
  RenderBatch *batch;
  SharedModels models;
  pthread_mutex_t mutex;
  pthread_cond_t finished; /* another job has */
  size_t next;             /* job to begin */
  size_t left;             /* jobs that are not finished */
} Jobs;

/* ---- one job ---- */

static void do_job(Jobs *jobs, RenderJob *job) {
  const RenderBatch *const batch = jobs->batch;
  job->request.shared = &jobs->models;
  message_subject(job->name);
  job->outcome = batch->render ? batch->render(batch->context, job)
                               : render_file(&job->request, render_job_played, job, &job->report);
  message_subject(NULL);
}

static RenderJob *take_job(Jobs *jobs) {
  RenderJob *job = NULL;
  (void)pthread_mutex_lock(&jobs->mutex);
  if (jobs->next < jobs->batch->count) job = &jobs->batch->jobs[jobs->next++];
  (void)pthread_mutex_unlock(&jobs->mutex);
  return job;
}

static void finish_job(Jobs *jobs, RenderJob *job) {
  atomic_store(&job->finished, true);
  (void)pthread_mutex_lock(&jobs->mutex);
  if (jobs->batch->rendered && job->outcome == OUTCOME_OK)
    job->outcome = jobs->batch->rendered(jobs->batch->context, job);
  jobs->left--;
  (void)pthread_cond_signal(&jobs->finished);
  (void)pthread_mutex_unlock(&jobs->mutex);
}

static void *work(void *context) {
  Jobs *const jobs = context;
  RenderJob *job;
  while ((job = take_job(jobs))) {
    if (job->outcome == OUTCOME_OK) do_job(jobs, job); /* others have failed, and said so */
    finish_job(jobs, job);
  }
  return NULL;
}

/* ---- all of them ---- */

/* Until a job has finished, but no longer than a line of progress may be old. */
static void wait_for_job(Jobs *jobs) {
  const double until = stopwatch_seconds(CLOCK_REALTIME) + PROGRESS_INTERVAL;
  const time_t whole = (time_t)until;
  const struct timespec time = {.tv_sec = whole, .tv_nsec = (long)(1e9 * (until - (double)whole))};
  (void)pthread_cond_timedwait(&jobs->finished, &jobs->mutex, &time);
}

static void watch(Jobs *jobs) {
  const bool shows = render_progress_is_wanted(&jobs->batch->jobs[0].arguments);
  const double start = stopwatch_seconds(CLOCK_MONOTONIC);
  (void)pthread_mutex_lock(&jobs->mutex);
  while (jobs->left > 0) {
    if (shows)
      render_progress_show(jobs->batch, jobs->left, stopwatch_seconds(CLOCK_MONOTONIC) - start);
    wait_for_job(jobs);
  }
  (void)pthread_mutex_unlock(&jobs->mutex);
  if (shows) status_line("");
}

/* If the system refuses further threads, those that run do all the work, or this thread does. */
static void do_jobs(Jobs *jobs) {
  const RenderBatch *const batch = jobs->batch;
  pthread_t threads[MOST_JOBS];
  size_t count = 0;
  while (count < batch->threads && count < batch->count &&
         pthread_create(&threads[count], NULL, work, jobs) == 0) {
    count++;
  }
  if (count == 0) (void)work(jobs);
  watch(jobs);
  for (size_t i = 0; i < count; i++) (void)pthread_join(threads[i], NULL);
}

/* ---- what came of them ---- */

static json_t *failure_json(const RenderJob *job) {
  return json_pack("{s:o, s:o, s:b}", "preset", json_text(preset_argument(&job->arguments)),
                   "output", json_text(job->output), "failed", true);
}

static Outcome print_reports(RenderBatch *batch) {
  json_t *list = json_array();
  for (size_t i = 0; i < batch->count; i++) {
    RenderJob *const job = &batch->jobs[i];
    list = json_with_item(list, job->report ? job->report : failure_json(job));
    job->report = NULL;
  }
  return json_print(json_pack("{s:o}", "renders", list));
}

static Outcome worst(const RenderBatch *batch) {
  Outcome outcome = OUTCOME_OK;
  for (size_t i = 0; i < batch->count; i++) {
    if (batch->jobs[i].outcome > outcome) outcome = batch->jobs[i].outcome;
  }
  return outcome;
}

/* What each sound was made with, a row a sound: it can be heard again by --set. */
static void write_rows(const RenderBatch *batch, char *text, size_t size) {
  const Variations *const variations = &batch->variations;
  size_t length = (size_t)snprintf(text, size, "file");
  for (size_t key = 0; key < variations->key_count; key++)
    length += (size_t)snprintf(text + length, size - length, ",%.*s",
                               (int)variations->varied[key].key, variations->varied[key].text);
  for (size_t i = 0; i < batch->count; i++) {
    const RenderJob *const job = &batch->jobs[i];
    if (job->outcome != OUTCOME_OK) continue;
    length += (size_t)snprintf(text + length, size - length, "\n%s", path_base(job->output));
    for (size_t key = 0; key < variations->key_count; key++) {
      char value[TABLE_VALUE];
      variations_value(variations, key, i % variations->count, value, sizeof value);
      length += (size_t)snprintf(text + length, size - length, ",%s", value);
    }
  }
  (void)snprintf(text + length, size - length, "\n");
}

static Outcome write_table(const RenderBatch *batch) {
  const size_t cells = (batch->count + 1) * (batch->variations.key_count + 4);
  const size_t size = cells * TABLE_VALUE;
  char *const path = folder_path(batch->folder, TABLE);
  char *const text = malloc(size);
  Outcome outcome = path && text ? OUTCOME_OK : fail_memory();
  if (outcome == OUTCOME_OK) {
    write_rows(batch, text, size);
    outcome = text_file_write(path, text, false);
  }
  free(text);
  free(path);
  return outcome;
}

/* Not for nothing: a job must be left that can be rendered. */
static Outcome create_folder(const RenderBatch *batch) {
  size_t failed = 0;
  while (failed < batch->count && batch->jobs[failed].outcome != OUTCOME_OK) failed++;
  return failed == batch->count ? OUTCOME_OK : folder_create(batch->folder);
}

Outcome render_jobs_do(RenderBatch *batch) {
  Jobs jobs = {.batch = batch,
               .mutex = PTHREAD_MUTEX_INITIALIZER,
               .finished = PTHREAD_COND_INITIALIZER,
               .left = batch->count};
  if (batch->count == 0) return OUTCOME_OK;
  json_object_seed(0); /* before there are threads, says jansson */
  shared_models_begin(&jobs.models);
  do_jobs(&jobs);
  shared_models_end(&jobs.models);
  return worst(batch);
}

Outcome render_jobs_run(RenderBatch *batch) {
  Outcome outcome = create_folder(batch);
  if (outcome != OUTCOME_OK) return outcome;
  const Outcome rendered = render_jobs_do(batch);
  if (batch->variations.count > 0) outcome = write_table(batch);
  if (outcome == OUTCOME_OK && arguments_has(&batch->jobs[0].arguments, "json"))
    outcome = print_reports(batch);
  return outcome == OUTCOME_OK ? rendered : outcome;
}
