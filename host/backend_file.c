/* SPDX-License-Identifier: MIT */
/*
 * No device: sound is computed as fast as can be, for the recording alone. Time is that of the sound.
 */
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>

#include "backend.h"

#define DEFAULT_RATE 48000.0

struct BackendStream {
  double rate;
  uint32_t buffer;
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
  *facts = (BackendFacts){.rate = stream->rate, .buffer = stream->buffer};
  (void)snprintf(facts->device, sizeof facts->device, "file");
  return OUTCOME_OK;
}

static void *run(void *context) {
  BackendStream *const stream = context;
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
  free(stream);
}

const Backend backend_file = {
  .name = "file",
  .waits = true,
  .open = open_stream,
  .start = start,
  .is_running = is_running,
  .close = close_stream,
};
