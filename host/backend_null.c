/* SPDX-License-Identifier: MIT */
/*
 * A device that nobody hears: a thread asks for a block whenever a clock says that the last one has
 * been played. For trying things out where there is no sound.
 */
#include <errno.h>
#include <math.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>

#include "backend.h"
#include "stopwatch.h"

#define DEFAULT_RATE 48000.0
#define WIDTH 2

struct BackendStream {
  double rate;
  uint32_t buffer, width;
  float *samples;
  BackendClient client;
  pthread_t thread;
  bool has_thread;
  atomic_bool stops, is_running;
};

static Outcome open_stream(const BackendRequest *request, BackendStream **opened,
                           BackendFacts *facts) {
  BackendStream *const stream = calloc(1, sizeof *stream);
  *opened = stream;
  if (!stream) return fail_memory();
  stream->rate = request->rate > 0 ? request->rate : DEFAULT_RATE;
  stream->buffer = request->buffer;
  stream->width = request->channels > WIDTH ? request->channels : WIDTH;
  stream->samples = calloc((size_t)stream->buffer * stream->width, sizeof *stream->samples);
  if (!stream->samples) return fail_memory();
  *facts = (BackendFacts){.rate = stream->rate,
                          .buffer = stream->buffer,
                          .width = stream->width,
                          .latency = stream->buffer / stream->rate};
  (void)snprintf(facts->device, sizeof facts->device, "null");
  return OUTCOME_OK;
}

static void sleep_until(double time) {
  const struct timespec moment = {.tv_sec = (time_t)time,
                                  .tv_nsec = (long)(1e9 * (time - floor(time)))};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &moment, NULL) == EINTR) continue;
}

/* A block that comes later than it would have to be heard is a gap; the clock goes on from there. */
static void *run(void *context) {
  BackendStream *const stream = context;
  const BackendClient *const client = &stream->client;
  const double period = stream->buffer / stream->rate;
  double due = stopwatch_seconds(CLOCK_MONOTONIC);
  bool more = true;
  while (more && !atomic_load(&stream->stops)) {
    const double now = stopwatch_seconds(CLOCK_MONOTONIC);
    const bool gap = now > due + period;
    if (gap) due = now;
    more = client->process(client->context, stream->samples, stream->buffer, due, gap);
    due += period;
    sleep_until(due);
  }
  atomic_store(&stream->is_running, false);
  return NULL;
}

static Outcome start(BackendStream *stream, const BackendClient *client) {
  stream->client = *client;
  atomic_store(&stream->is_running, true);
  stream->has_thread = pthread_create(&stream->thread, NULL, run, stream) == 0;
  return stream->has_thread ? OUTCOME_OK : fail("cannot start a thread for the sound");
}

static bool is_running(BackendStream *stream) { return atomic_load(&stream->is_running); }

static void close_stream(BackendStream *stream) {
  if (!stream) return;
  atomic_store(&stream->stops, true);
  if (stream->has_thread) (void)pthread_join(stream->thread, NULL);
  free(stream->samples);
  free(stream);
}

const Backend backend_null = {
  .name = "null",
  .open = open_stream,
  .start = start,
  .is_running = is_running,
  .close = close_stream,
};
