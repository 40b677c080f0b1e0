/* SPDX-License-Identifier: MIT */
#include "play/take_writer.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <time.h>

struct Recorder {
  Player *player;
  OutputFile *output;
  AudioFile file;
  double *silence; /* a block of it, for what the disk was too slow for */
  uint64_t frames; /* written or failed to be */
  pthread_t thread;
  Outcome outcome; /* of writing */
  atomic_bool stops;
};

static void pause_ms(long milliseconds) {
  const struct timespec moment = {.tv_nsec = milliseconds * 1000000};
  (void)nanosleep(&moment, NULL);
}

/* A block whose predecessor was lost stays in its place. */
static Outcome write_silence_until(Recorder *recorder, uint64_t frame) {
  Outcome outcome = OUTCOME_OK;
  while (recorder->frames < frame && outcome == OUTCOME_OK) {
    const uint64_t missing = frame - recorder->frames;
    const uint32_t frames = missing < AUDIO_BLOCK ? (uint32_t)missing : AUDIO_BLOCK;
    outcome = audio_file_write(&recorder->file, recorder->silence, frames);
    recorder->frames += frames;
  }
  return outcome;
}

static Outcome write_frames(Recorder *recorder, const PlayerRecord *block) {
  const Outcome outcome = write_silence_until(recorder, block->frame);
  if (outcome != OUTCOME_OK) return outcome;
  recorder->frames += block->frames;
  return audio_file_write(&recorder->file, block->samples, block->frames);
}

/* What goes wrong is said once; then blocks are only taken away. */
static void write_block(Recorder *recorder, const PlayerRecord *block) {
  char reason[1000];
  if (recorder->outcome != OUTCOME_OK) return;
  const MessageCapture before = message_capture(reason, sizeof reason);
  recorder->outcome = write_frames(recorder, block);
  message_release(before);
  if (recorder->outcome == OUTCOME_OK) return;
  (void)fail("%s; the recording ends after %.2f s, playing goes on", reason,
             (double)recorder->file.frames / recorder->file.format.rate);
}

static void write_all(Recorder *recorder) {
  const PlayerRecord *block;
  while ((block = player_record(recorder->player)) != NULL) {
    write_block(recorder, block);
    player_record_next(recorder->player);
  }
}

static void *run(void *context) {
  Recorder *const recorder = context;
  while (!atomic_load(&recorder->stops)) {
    write_all(recorder);
    pause_ms(5);
  }
  write_all(recorder);
  return NULL;
}

static void recorder_free(Recorder *recorder) {
  audio_file_free(&recorder->file);
  free(recorder->silence);
  free(recorder);
}

static Outcome open_file(Recorder *recorder, const AudioFormat *format) {
  const Outcome outcome = output_open(recorder->output, format->container != AUDIO_AU);
  if (outcome != OUTCOME_OK) return outcome;
  return audio_file_open(&recorder->file, format, recorder->output);
}

Outcome recorder_start(const AudioFormat *format, OutputFile *output, Player *player,
                       Recorder **started) {
  Recorder *const recorder = calloc(1, sizeof *recorder);
  *started = NULL;
  if (!recorder) return fail_memory();
  recorder->player = player;
  recorder->output = output;
  recorder->silence = calloc((size_t)AUDIO_BLOCK * format->channels, sizeof *recorder->silence);
  Outcome outcome = recorder->silence ? open_file(recorder, format) : fail_memory();
  if (outcome == OUTCOME_OK && pthread_create(&recorder->thread, NULL, run, recorder) != 0) {
    outcome = fail("cannot start a thread for the recording");
  }
  if (outcome == OUTCOME_OK) {
    *started = recorder;
  } else {
    recorder_free(recorder);
  }
  return outcome;
}

void recorder_wait(const Recorder *recorder, uint32_t frames) {
  while (!player_record_has_room(recorder->player, frames)) pause_ms(1);
}

static Outcome deliver(Recorder *recorder, uint64_t *kept) {
  const Outcome writing = recorder->outcome;
  const uint64_t frames = recorder->file.frames;
  Outcome outcome = writing == OUTCOME_OK ? audio_file_finish(&recorder->file)
                                          : audio_file_salvage(&recorder->file);
  if (outcome == OUTCOME_OK) outcome = output_complete(recorder->output);
  if (outcome == OUTCOME_OK) outcome = output_deliver(&recorder->output, 1);
  *kept = outcome == OUTCOME_OK ? frames : 0;
  return writing == OUTCOME_OK ? outcome : writing;
}

Outcome recorder_finish(Recorder *recorder, uint64_t *kept) {
  if (!recorder) return OUTCOME_OK;
  atomic_store(&recorder->stops, true);
  (void)pthread_join(recorder->thread, NULL);
  const Outcome outcome = deliver(recorder, kept);
  recorder_free(recorder);
  return outcome;
}
