/* SPDX-License-Identifier: MIT */
/*
 * Output without a device: a thread of this file requests the blocks.
 *
 * "null" requests a block whenever the clock shows that the last one has been played. It is for
 * trials on a machine without sound. "file" requests blocks as fast as possible, for the recording
 * alone; its time is the time of the sound.
 */
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>

#include "platform/clock.h"
#include "play/backend.h"

#define DEFAULT_RATE 48000.0
#define WIDTH 2

struct BackendStream {
  double rate;
  uint32_t buffer;
  float *samples; /* NULL: nobody takes any */
  BackendClient client;
  pthread_t thread;
  bool has_thread;
  atomic_bool stops, is_running;
  /* Asks for blocks until the client has no more, or the stream stops. */
  void (*ask)(BackendStream *stream);
};

static Outcome open_stream(const BackendRequest *request, BackendStream **opened,
                           BackendFacts *facts, const char *name) {
  BackendStream *const stream = calloc(1, sizeof *stream);
  *opened = stream;
  if (!stream) return fail_memory();
  stream->rate = request->rate > 0 ? request->rate : DEFAULT_RATE;
  stream->buffer = request->buffer;
  *facts = (BackendFacts){.rate = stream->rate, .buffer = stream->buffer};
  (void)snprintf(facts->device, sizeof facts->device, "%s", name);
  return OUTCOME_OK;
}

static void *run(void *context) {
  BackendStream *const stream = context;
  stream->ask(stream);
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

/* ---- null ----------------------------------------------------------------------------------- */

/* A block that comes later than it would have to be heard is a gap; the clock goes on from there.
 */
static void ask_by_the_clock(BackendStream *stream) {
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
    clock_sleep_until(due);
  }
}

static Outcome open_null(const BackendRequest *request, BackendStream **opened,
                         BackendFacts *facts) {
  const Outcome outcome = open_stream(request, opened, facts, "null");
  BackendStream *const stream = *opened;
  if (outcome != OUTCOME_OK) return outcome;
  facts->width = request->channels > WIDTH ? request->channels : WIDTH;
  facts->latency = stream->buffer / stream->rate;
  stream->ask = ask_by_the_clock;
  stream->samples = calloc((size_t)stream->buffer * facts->width, sizeof *stream->samples);
  return stream->samples ? OUTCOME_OK : fail_memory();
}

const Backend backend_null = {
  .name = "null",
  .open = open_null,
  .start = start,
  .is_running = is_running,
  .close = close_stream,
};

/* ---- file ----------------------------------------------------------------------------------- */

static void ask_at_once(BackendStream *stream) {
  const BackendClient *const client = &stream->client;
  const uint32_t frames = stream->buffer;
  uint64_t position = 0;
  bool more = true;
  while (more && !atomic_load(&stream->stops)) {
    const double now = (double)position / stream->rate;
    more = client->prepare(client->context, frames) &&
           client->process(client->context, NULL, frames, now, false);
    position += frames;
  }
}

static Outcome open_file(const BackendRequest *request, BackendStream **opened,
                         BackendFacts *facts) {
  const Outcome outcome = open_stream(request, opened, facts, "file");
  if (outcome == OUTCOME_OK) (*opened)->ask = ask_at_once;
  return outcome;
}

const Backend backend_file = {
  .name = "file",
  .waits = true,
  .open = open_file,
  .start = start,
  .is_running = is_running,
  .close = close_stream,
};
