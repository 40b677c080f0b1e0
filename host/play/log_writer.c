/* SPDX-License-Identifier: MIT */
#include "play/log_writer.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

struct LogWriter {
  Player *player;
  OutputFile *output;
  pthread_t thread;
  atomic_bool stops;
  uint64_t end; /* behind the last message */

  pthread_mutex_t lock; /* of a line, and of what follows */
  Outcome outcome;      /* of writing */
};

static void pause_ms(long milliseconds) {
  const struct timespec moment = {.tv_nsec = milliseconds * 1000000};
  (void)nanosleep(&moment, NULL);
}

/* Takes the line over; NULL means that memory was short. */
static Outcome write_line(LogWriter *writer, char *line) {
  const Outcome outcome = line ? output_write(writer->output, line, strlen(line)) : fail_memory();
  free(line);
  return outcome;
}

/* Adds a line while the drum plays. What goes wrong is said once. */
static void add_line(LogWriter *writer, char *line) {
  char reason[1000];
  (void)pthread_mutex_lock(&writer->lock);
  const Outcome before = writer->outcome;
  const MessageCapture capture = message_capture(reason, sizeof reason);
  if (before == OUTCOME_OK) {
    writer->outcome = write_line(writer, line);
  } else {
    free(line);
  }
  message_release(capture);
  if (writer->outcome != before) (void)fail("%s; there is no log then, playing goes on", reason);
  (void)pthread_mutex_unlock(&writer->lock);
}

static void write_messages(LogWriter *writer) {
  const PlayerMessage *message;
  while ((message = player_log(writer->player)) != NULL) {
    add_line(writer, log_line_message(message));
    writer->end = message->frame + 1;
    player_log_next(writer->player);
  }
}

static void *run(void *context) {
  LogWriter *const writer = context;
  while (!atomic_load(&writer->stops)) {
    write_messages(writer);
    pause_ms(5);
  }
  return NULL;
}

static void log_writer_free(LogWriter *writer) {
  (void)pthread_mutex_destroy(&writer->lock);
  free(writer);
}

static Outcome write_start(LogWriter *writer, const LogWriterSetup *setup) {
  LogStart start = setup->start;
  (void)snprintf(start.program, sizeof start.program, "%s", tabor_version());
  return write_line(writer, log_line_start(&start, setup->model, setup->preset));
}

Outcome log_writer_start(const LogWriterSetup *setup, OutputFile *output, LogWriter **started) {
  LogWriter *const writer = calloc(1, sizeof *writer);
  *started = NULL;
  if (!writer) return fail_memory();
  writer->player = setup->player;
  writer->output = output;
  (void)pthread_mutex_init(&writer->lock, NULL);
  Outcome outcome = output_open(output, true);
  if (outcome == OUTCOME_OK) outcome = write_start(writer, setup);
  if (outcome == OUTCOME_OK && pthread_create(&writer->thread, NULL, run, writer) != 0) {
    outcome = fail("cannot start a thread for the log");
  }
  if (outcome == OUTCOME_OK) {
    *started = writer;
  } else {
    log_writer_free(writer);
  }
  return outcome;
}

void log_writer_add_model(LogWriter *writer, uint32_t number, const TaborModel *model,
                          const char *preset) {
  if (writer) add_line(writer, log_line_model(number, model, preset));
}

void log_writer_wait(const LogWriter *writer) {
  while (writer && !player_log_has_room(writer->player)) pause_ms(1);
}

/* With its last line, which it takes over. */
static Outcome deliver(LogWriter *writer, char *end) {
  Outcome outcome = writer->outcome;
  if (outcome == OUTCOME_OK) {
    outcome = write_line(writer, end);
  } else {
    free(end);
  }
  if (outcome == OUTCOME_OK) outcome = output_complete(writer->output);
  return outcome == OUTCOME_OK ? output_deliver(&writer->output, 1) : outcome;
}

/* If the audio thread hangs within a block, messages may be ahead of what counts as played. */
Outcome log_writer_finish(LogWriter *writer) {
  if (!writer) return OUTCOME_OK;
  atomic_store(&writer->stops, true);
  (void)pthread_join(writer->thread, NULL);
  write_messages(writer);
  const uint64_t played = player_position(writer->player);
  const uint64_t frames = played > writer->end ? played : writer->end;
  const uint64_t lost = player_log_lost(writer->player);
  const Outcome outcome =
    frames > 0 ? deliver(writer, log_line_end(frames, lost)) : writer->outcome;
  log_writer_free(writer);
  return outcome;
}
