/* SPDX-License-Identifier: MIT */
#include "render_progress.h"

#include <math.h>
#include <stdio.h>
#include <unistd.h>

#include "ring_out.h"

#define GUESSED_RING_OUT 3.0 /* [s], as long as no drum has died away */
#define LEAST_ELAPSED 1.0    /* [s] before a forecast is ventured */
#define LEAST_FRACTION 0.02  /* of all the sound, likewise */

bool render_progress_is_wanted(const Arguments *arguments) {
  return !arguments_has(arguments, "quiet") && isatty(STDERR_FILENO);
}

void render_progress_show_frames(const RenderRequest *request, uint32_t frames) {
  char text[32];
  if (frames % request->audio.rate >= RING_OUT_BLOCK) return;
  (void)snprintf(text, sizeof text, "%u s ", (unsigned)(frames / request->audio.rate));
  status_line(text);
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

void render_progress_show(const RenderBatch *batch, size_t left, double elapsed) {
  const double fraction = fraction_played(batch);
  char text[96];
  const int length =
    snprintf(text, sizeof text, "%zu of %zu done ", batch->count - left, batch->count);
  if (elapsed >= LEAST_ELAPSED && fraction >= LEAST_FRACTION) {
    const long remaining = lround(elapsed / fraction - elapsed);
    (void)snprintf(text + length, sizeof text - (size_t)length, "- about %ld:%02ld left ",
                   remaining / 60, remaining % 60);
  }
  status_line(text);
}
