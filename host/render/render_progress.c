/* SPDX-License-Identifier: MIT */
#include "render/render_progress.h"

#include <math.h>
#include <stdio.h>
#include <unistd.h>

#include "drums/model_build.h"

#define GUESSED_RING_OUT 3.0 /* [s], as long as no drum has died away */
#define LEAST_ELAPSED 1.0    /* [s] before a forecast is ventured */
#define LEAST_FRACTION 0.02  /* of all the sound, likewise */

bool render_progress_is_wanted(const Arguments *arguments) {
  return !arguments_has(arguments, "quiet") && isatty(STDERR_FILENO);
}

static double seconds_played(const RenderJob *job) {
  const unsigned frames = atomic_load_explicit(&job->played, memory_order_relaxed);
  return frames > 0 ? frames / job->rate : 0; /* what could not be read has no rate */
}

static bool is_finished(const RenderJob *job) { return atomic_load(&job->finished); }

/* How long the drums that are finished sounded after their last stroke, on average [s]. */
static double usual_ring_out(const RenderBatch *batch) {
  double sum = 0;
  size_t count = 0;
  for (size_t i = 0; i < batch->count; i++) {
    const RenderJob *const job = &batch->jobs[i];
    if (!is_finished(job) || job->length > 0 || seconds_played(job) == 0) continue;
    sum += seconds_played(job) - job->last_stroke;
    count++;
  }
  return count > 0 ? sum / (double)count : GUESSED_RING_OUT;
}

/* The part of all the jobs' sound that has been played, 0 to 1. */
static double fraction_played(const RenderBatch *batch) {
  const double ring_out = usual_ring_out(batch);
  double played = 0, length = 0;
  for (size_t i = 0; i < batch->count; i++) {
    const RenderJob *const job = &batch->jobs[i];
    const double probable = job->length > 0 ? job->length : job->last_stroke + ring_out;
    played += seconds_played(job);
    length += is_finished(job) ? seconds_played(job) : fmax(seconds_played(job), probable);
  }
  return length > 0 ? played / length : 0;
}

/* Nobody knows when a single drum will have died away: its end is known while strokes are still to
 * come. */
static bool has_known_end(const RenderBatch *batch) {
  const RenderJob *const job = &batch->jobs[0];
  return batch->count > 1 || job->length > 0 || seconds_played(job) < job->last_stroke;
}

/* ", 21 %", and once there is something to conclude from, ", about 0:12 left". */
static void format_forecast(RenderBatch *batch, double elapsed, char *text, size_t size) {
  const double fraction = batch->shown = fmax(batch->shown, fraction_played(batch));
  const int percent = (int)fmin(100 * fraction, 99); /* something is left while this is shown */
  if (elapsed < LEAST_ELAPSED || fraction < LEAST_FRACTION) {
    (void)snprintf(text, size, ", %d %%", percent);
    return;
  }
  const long remaining = lround(elapsed / fraction - elapsed);
  (void)snprintf(text, size, ", %d %%, about %ld:%02ld left", percent, remaining / 60,
                 remaining % 60);
}

void render_progress_text(RenderBatch *batch, size_t left, double elapsed, char *text,
                          size_t size) {
  char forecast[RENDER_PROGRESS_SIZE / 2] = "";
  if (has_known_end(batch)) format_forecast(batch, elapsed, forecast, sizeof forecast);
  if (batch->count > 1) {
    (void)snprintf(text, size, "%zu of %zu done%s", batch->count - left, batch->count, forecast);
  } else {
    (void)snprintf(text, size, "%.0f s%s", floor(seconds_played(&batch->jobs[0])), forecast);
  }
}

void render_progress_show(RenderBatch *batch, size_t left, double elapsed) {
  char text[RENDER_PROGRESS_SIZE];
  if (model_build_is_shown()) return;
  render_progress_text(batch, left, elapsed, text, sizeof text);
  status_line(text);
}
