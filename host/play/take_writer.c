/* SPDX-License-Identifier: MIT */
#include "play/take_writer.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <time.h>

#define REFRESH_TIME 0.5 /* [s] of sound from one header to the next */

struct TakeWriter {
  Recording *recording;
  OutputFile *output;
  AudioFile file;
  double *silence; /* a block of it, for what the disk was too slow for */
  uint64_t frames; /* written or failed to be */
  uint64_t next;   /* number of frames at which the header is renewed */
  pthread_t thread;
  Outcome outcome; /* of writing */
  atomic_bool stops;
};

static void pause_ms(long milliseconds) {
  const struct timespec moment = {.tv_nsec = milliseconds * 1000000};
  (void)nanosleep(&moment, NULL);
}

/* A block whose predecessor was lost stays in its place. */
static Outcome write_silence_until(TakeWriter *writer, uint64_t frame) {
  Outcome outcome = OUTCOME_OK;
  while (writer->frames < frame && outcome == OUTCOME_OK) {
    const uint64_t missing = frame - writer->frames;
    const uint32_t frames = missing < AUDIO_BLOCK ? (uint32_t)missing : AUDIO_BLOCK;
    outcome = audio_file_write(&writer->file, writer->silence, frames);
    writer->frames += frames;
  }
  return outcome;
}

/* The first block is in the header at once. */
static Outcome refresh(TakeWriter *writer) {
  if (writer->output->kind != OUTPUT_REPLACED || writer->frames < writer->next) return OUTCOME_OK;
  if (writer->next == 0) output_keep(writer->output);
  writer->next = writer->frames + (uint64_t)(REFRESH_TIME * writer->file.format.rate);
  return audio_file_refresh(&writer->file);
}

static Outcome write_frames(TakeWriter *writer, const RecordingBlock *block) {
  Outcome outcome = write_silence_until(writer, block->frame);
  if (outcome != OUTCOME_OK) return outcome;
  writer->frames += block->frames;
  outcome = audio_file_write(&writer->file, block->samples, block->frames);
  return outcome == OUTCOME_OK ? refresh(writer) : outcome;
}

/* What goes wrong is said once; then blocks are only taken away. */
static void write_block(TakeWriter *writer, const RecordingBlock *block) {
  char reason[1000];
  if (writer->outcome != OUTCOME_OK) return;
  const MessageCapture before = message_capture(reason, sizeof reason);
  writer->outcome = write_frames(writer, block);
  message_release(before);
  if (writer->outcome == OUTCOME_OK) return;
  (void)fail("%s; the recording ends after %.2f s, playing goes on", reason,
             (double)writer->file.frames / writer->file.format.rate);
}

static void write_all(TakeWriter *writer) {
  const RecordingBlock *block;
  while ((block = recording_peek(writer->recording)) != NULL) {
    write_block(writer, block);
    recording_pop(writer->recording);
  }
}

static void *run(void *context) {
  TakeWriter *const writer = context;
  while (!atomic_load(&writer->stops)) {
    write_all(writer);
    pause_ms(5);
  }
  write_all(writer);
  return NULL;
}

static void take_writer_free(TakeWriter *writer) {
  audio_file_free(&writer->file);
  free(writer->silence);
  free(writer);
}

static Outcome open_file(TakeWriter *writer, const AudioFormat *format) {
  writer->output->findable = true;
  const Outcome outcome = output_open(writer->output, format->container != AUDIO_AU);
  if (outcome != OUTCOME_OK) return outcome;
  return audio_file_open(&writer->file, format, writer->output);
}

Outcome take_writer_start(const AudioFormat *format, OutputFile *output, Recording *recording,
                          TakeWriter **started) {
  TakeWriter *const writer = calloc(1, sizeof *writer);
  *started = NULL;
  if (!writer) return fail_memory();
  writer->recording = recording;
  writer->output = output;
  writer->silence = calloc((size_t)AUDIO_BLOCK * format->channels, sizeof *writer->silence);
  Outcome outcome = writer->silence ? open_file(writer, format) : fail_memory();
  if (outcome == OUTCOME_OK && pthread_create(&writer->thread, NULL, run, writer) != 0) {
    outcome = fail("cannot start a thread for the recording");
  }
  if (outcome == OUTCOME_OK) {
    *started = writer;
  } else {
    take_writer_free(writer);
  }
  return outcome;
}

void take_writer_wait(const TakeWriter *writer, uint32_t frames) {
  while (!recording_has_room(writer->recording, frames)) pause_ms(1);
}

static Outcome deliver(TakeWriter *writer, uint64_t *kept) {
  const Outcome writing = writer->outcome;
  const uint64_t frames = writer->file.frames;
  Outcome outcome =
    writing == OUTCOME_OK ? audio_file_finish(&writer->file) : audio_file_salvage(&writer->file);
  if (outcome == OUTCOME_OK) outcome = output_complete(writer->output);
  if (outcome == OUTCOME_OK) outcome = output_deliver(&writer->output, 1);
  *kept = outcome == OUTCOME_OK ? frames : 0;
  return writing == OUTCOME_OK ? outcome : writing;
}

Outcome take_writer_finish(TakeWriter *writer, uint64_t *kept) {
  if (!writer) return OUTCOME_OK;
  atomic_store(&writer->stops, true);
  (void)pthread_join(writer->thread, NULL);
  const Outcome outcome = deliver(writer, kept);
  take_writer_free(writer);
  return outcome;
}
